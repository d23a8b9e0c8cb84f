#pragma once

#include <array>
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

/// Where the time of a pass went, in milliseconds. Where RayShader makes the camera rays itself, these are
/// estimates: one packet in 61 looks at the clock, and its shares are taken for those of all. Elsewhere
/// generate and trace are the device's own times of these kernels, and shade is all of RayShader.
struct PassTimes {
    double generate = 0.0; ///< Camera rays.
    double trace = 0.0;    ///< Their first hits.
    double shadow = 0.0;   ///< Shadow rays.
    double further = 0.0;  ///< Path's rays after the camera's.
    double single = 0.0; ///< Surfaces and lights of what is shaded pixel by pixel; Whitted's rays there, too.
    double shade = 0.0;  ///< Surfaces, lights and materials.
    double accumulate = 0.0; ///< Adding to the picture.
    bool isEstimated = false;

    void add(const PassTimes& other) {
        for (const auto part : parts)
            this->*part += other.*part;
        isEstimated = other.isEstimated;
    }
    void scale(double by) {
        for (const auto part : parts)
            this->*part *= by;
    }

    static const std::array<double PassTimes::*, 7> parts; ///< All of them.
};

inline constexpr std::array<double PassTimes::*, 7> PassTimes::parts{
    &PassTimes::generate, &PassTimes::trace, &PassTimes::shadow,    &PassTimes::further,
    &PassTimes::single,   &PassTimes::shade, &PassTimes::accumulate};

/// About the picture on the screen, for the overlay and --stats.
struct RenderStatistics {
    std::string device;
    std::vector<StageStatistics> stages; ///< The last RenderPlan, as it ran.
    RayCounts rays;                      ///< Of the last pass.
    PassTimes times;                     ///< Of the last pass.
    std::uint64_t nonFinitePixels = 0;   ///< Of the last pass: samples that were no numbers, and left out.
    double passMilliseconds = 0.0;       ///< From the snapshot to the finished pass.
    std::uint64_t triangles = 0;         ///< As instanced in the scene.
    std::uint64_t deviceBytes = 0;       ///< Buffers on the device.
    double treeWear = 1.0;               ///< Cost of the most worn refitted tree over its cost when built.
};

} // namespace prizma
