#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace prizma::bench {

struct AnimateBenchOptions {
    std::string deviceId; ///< Empty: the default device.
    int repeats = 11;     ///< Times are medians of this many; ours and Embree's take turns.
};

/// What it costs to bring posed objects to another time, in milliseconds by the host's clock, waiting for the
/// device after each stage.
struct AnimateReport {
    std::string device;
    std::size_t objects = 0, triangles = 0, vertices = 0, bones = 0; ///< Of the objects that are posed.
    double pose = 0.0; ///< Evaluating clips and uploading matrices.
    double vertexShader = 0.0;
    double triangleShader = 0.0;
    double refitTreeShader = 0.0;
    double milliseconds = 0.0;         ///< All of them.
    std::optional<double> embreeRefit; ///< Embree's refit alone, of the very same vertices.
    double ratio = 0.0;                ///< Our milliseconds over that; 0 without Embree.
};

/// Measures the animation of all posed objects of a scene. Errors: nothing is posed, no device, no memory.
Result<AnimateReport> benchAnimate(const Scene& scene, const AnimateBenchOptions& options);

struct PlayBenchOptions {
    std::string deviceId;
    int width = 480, height = 270; ///< Of the picture.
    int frames = 90;
    double fps = 30.0; ///< Of the timeline that is played.
};

struct PlayReport {
    std::string device;
    std::size_t objects = 0, triangles = 0; ///< As instanced in the scene.
    double framesPerSecond = 0.0;           ///< From one snapshot to the next, display included.
    double medianMilliseconds = 0.0, slowestMilliseconds = 0.0;
    /// Means over the frames.
    double pose = 0.0, vertexShader = 0.0, triangleShader = 0.0, refitTreeShader = 0.0, topLevel = 0.0,
           trace = 0.0, shade = 0.0;
    std::size_t fewestPosed = 0, mostPosed = 0; ///< Objects that a frame re-ran.
    std::size_t uploads = 0;                    ///< Frames that had to upload geometry, after the first.
};

/// Plays a scene's timeline, one sample a frame, as fast as it goes. Errors: no device, no memory.
Result<PlayReport> benchPlay(const Scene& scene, const PlayBenchOptions& options);

} // namespace prizma::bench
