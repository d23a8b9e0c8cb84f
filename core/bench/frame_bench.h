#pragma once

#include "core/diagnostic.h"
#include "core/render/statistics.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace prizma::bench {

struct FrameBenchOptions {
    std::string deviceId; ///< Empty: the default device.
    int width = 0;        ///< Of the picture; 0: 1280 x 720, on graphics cards 1920 x 1080.
    int height = 0;
    std::string exportTo; ///< Where other renderers find the scene (scene_export.h); empty: nowhere.
    int repeats = 5;      ///< Times are medians of this many; frames and rays take turns.
};

/// The rays of one kind that a frame traces, by themselves.
struct FrameRays {
    std::string rays; ///< "camera", "shadow packets", "further" or "shadow".
    std::uint64_t count = 0;
    bool inPackets = false; ///< What was faster for these rays: sixteen a work item, or one.
    double milliseconds = 0.0;
};

struct FrameResult {
    std::string shader; ///< "whitted" or "path".
    int width = 0, height = 0;
    double milliseconds = 0.0; ///< Of a sample, by the host's clock, from the plan to the finished pass.
    PassTimes times;           ///< Where they go; means.
    std::vector<FrameRays> rays;
    double raysMilliseconds = 0.0; ///< Of all rays.
    double ratio = 0.0;            ///< The frame's time over its rays'.
    std::uint64_t nonFinitePixels = 0;

    double framesPerSecond() const { return milliseconds > 0.0 ? 1000.0 / milliseconds : 0.0; }
};

struct FrameReport {
    std::string device;
    std::uint64_t triangles = 0; ///< As instanced in the scene.
    std::vector<FrameResult> frames;
};

/// Measures a sample a pixel of Whitted and of Path (four bounces), lit by one point light, against the very
/// same rays traced by themselves (record_rays.clh, RayQuery). The scene's own lights are not used. Errors:
/// nothing to draw, no device, no memory.
Result<FrameReport> benchFrame(Scene scene, const FrameBenchOptions& options);

} // namespace prizma::bench
