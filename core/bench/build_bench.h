#pragma once

#include "core/bvh/device_layout.h"
#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>

namespace prizma::bench {

struct BuildBenchOptions {
    TreeLayout layout = TreeLayout::Wide8;
    int repeats = 5; ///< Times are medians of this many; ours and Embree's take turns.
};

/// Over all different meshes of a scene together.
struct BuildReport {
    std::size_t triangles = 0;
    double milliseconds = 0.0; ///< From a mesh to a tree that a device can trace: build and layout.
    double buildMilliseconds = 0.0;
    double layoutMilliseconds = 0.0;
    double bytesPerTriangle = 0.0;      ///< Of the device tree.
    double sahCost = 0.0;               ///< Mean over the meshes, by triangles.
    int depth = 0;                      ///< Of the deepest device tree.
    std::optional<double> embreeMedium; ///< Milliseconds; nothing in a program built without Embree.
    double ratio = 0.0; ///< Our milliseconds over Embree's: below 1 is faster. 0 without Embree.
};

/// Measures building the bottom level. Errors: no mesh, a build that fails.
Result<BuildReport> benchBuild(const Scene& scene, const BuildBenchOptions& options);

} // namespace prizma::bench
