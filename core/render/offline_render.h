#pragma once

#include "core/progress.h"
#include "core/render/renderer.h"

#include <vector>

namespace prizma {

struct OfflineOptions {
    int width = 1280;
    int height = 720;
    int samples = 0;        ///< A pixel; 0 takes the scene's own limit.
    double timeLimit = 0.0; ///< Seconds after which the pass in progress is the last; 0 for none.
    double maxError = 0.0;  ///< Stop once the estimated error is below this; 0 for never.
    bool deep = false;      ///< 16 bits a channel for PNG files, too.
};

/// Milliseconds by what they went into.
struct OfflineTimes {
    double total = 0.0, compile = 0.0, build = 0.0, upload = 0.0, refit = 0.0, trace = 0.0, shade = 0.0;
};

/// Radiance and display are always there.
struct OfflinePicture : Picture {
    /// Estimated relMSE (mean of squared error over squared radiance + 0.01): the difference between the
    /// picture and the one of half as many samples, whose square has the variance of the picture as its mean.
    /// 0 for one sample.
    double error = 0.0;
    std::uint64_t nonFinitePixels =
        0; ///< Samples left out because they were no numbers, and such pixels of the picture.
    OfflineTimes times;
    PassTimes passTimes; ///< Of all passes.
    RayCounts rays;
};

/// Renders a scene to its end, without a display. Cancelling `cancel` (it may be null) ends it with an error
/// after the chunk in progress, about 30 ms.
Result<OfflinePicture> renderOffline(Renderer& renderer, const Scene& scene, const OfflineOptions& options,
                                     const Progress* cancel = nullptr);

/// relMSE of `picture` against `reference` (accuracy.md): RGBA floats of equal count, alpha left out.
double relativeMeanSquaredError(const std::vector<float>& picture, const std::vector<float>& reference);

} // namespace prizma
