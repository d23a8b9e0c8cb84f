#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace prizma {

/// What one stage of the last pass did.
struct StageStatistics {
    std::string stage; ///< "RayShader", "Top level", ...
    std::string why;   ///< "camera moved", ...
    double milliseconds = 0.0;
    int objects = 0; ///< Objects it touched; 0 if that means nothing.
};

struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, secondary = 0;

    std::uint64_t total() const { return camera + shadow + secondary; }
};

/// About the picture on the screen, for the overlay and --stats.
struct RenderStatistics {
    std::string device;
    std::vector<StageStatistics> stages; ///< The last RenderPlan, as it ran.
    RayCounts rays;                      ///< Of the last pass.
    double passMilliseconds = 0.0;       ///< From the snapshot to the finished pass.
    std::uint64_t triangles = 0;         ///< As instanced in the scene.
    std::uint64_t deviceBytes = 0;       ///< Buffers on the device.
    double treeWear = 1.0;               ///< Cost of the most worn refitted tree over its cost when built.
};

} // namespace prizma
