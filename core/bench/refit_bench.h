#pragma once

#include "core/bvh/device_layout.h"
#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace prizma::bench {

struct RefitBenchOptions {
    std::string deviceId;             ///< Empty: the default device.
    std::optional<TreeLayout> layout; ///< Nothing: what suits the device.
    int repeats = 5;                  ///< Times are medians of this many; ours and Embree's take turns.
};

/// Over all visible objects of a scene, each made to bend slightly (makeBending).
struct RefitReport {
    std::string device;
    std::size_t triangles = 0;
    /// From new vertices to trees that can be traced: TriangleShader and RefitTreeShader, by the host's
    /// clock, with the read of the trees' boxes. VertexShader is not in it: Embree is given its vertices as
    /// well.
    double milliseconds = 0.0;
    double vertexShader = 0.0;
    double triangleShader = 0.0;
    double refitTreeShader = 0.0;
    std::optional<double> embreeRefit; ///< Of the very same vertices; nothing in a program without Embree.
    double ratio = 0.0; ///< Our milliseconds over Embree's: below 1 is faster. 0 without Embree.
};

/// Measures refitting all trees of a scene. Errors: no mesh, no device, no memory.
Result<RefitReport> benchRefit(const Scene& scene, const RefitBenchOptions& options);

} // namespace prizma::bench
