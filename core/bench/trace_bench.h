#pragma once

#include "core/bvh/device_layout.h"
#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace prizma::bench {

struct TraceBenchOptions {
    std::string deviceId; ///< Empty: the default device.
    int width = 1280;     ///< Of the picture whose camera rays are traced.
    int height = 720;
    int repeats = 5; ///< Rates are medians of this many; ours and Embree's take turns.
};

/// Millions of rays a second.
struct EmbreeRates {
    double single = 0.0; ///< One ray a call.
    double packet16 = 0.0;
    double robustSingle = 0.0; ///< In a scene with Embree's robust flag.
    double robustPacket16 = 0.0;
};

struct TraceResult {
    std::string rays; ///< "camera", "diffuse" or "shadow".
    std::size_t rayCount = 0;
    double mraysPerSecond = 0.0;
    /// Rays that end elsewhere than in Embree's robust mode (without Embree: than in the reference tracer):
    /// hit or miss, or another triangle at a distance that differs by more than a share of 1e-4.
    std::size_t mismatches = 0;
    /// Of these, the ones where the reference tracer clearly contradicts the kernel.
    std::size_t wrong = 0;
    std::optional<EmbreeRates> embree; ///< Nothing in a program built without Embree.
    double ratio = 0.0;                ///< Our rate over the better of Embree's; 0 without Embree.
    double ratioRobust = 0.0; ///< The same over Embree's robust mode, which is watertight as our test is.
};

struct TraceReport {
    std::string device;
    TreeLayout layout = TreeLayout::Wide8; ///< That the device was given.
    std::size_t triangles = 0;             ///< As instanced in the scene.
    std::uint64_t deviceBytes = 0;         ///< Of the scene on the device: trees, vertices, materials.
    std::vector<TraceResult> results;
};

/// Measures how fast rays of three kinds are traced. Errors: nothing to trace, no device, no memory.
Result<TraceReport> benchTrace(const Scene& scene, const TraceBenchOptions& options);

} // namespace prizma::bench
