#include "core/render/interactive_resolution.h"

#include <algorithm>
#include <cmath>

namespace prizma {

void InteractiveResolution::measured(double pixels, double milliseconds) {
    if (pixels <= 0.0 || milliseconds <= 0.0)
        return;
    const double rate = pixels / milliseconds;
    // Quick to slow down, so that a sudden heavy view costs one late picture only; slow to speed up.
    const double share = rate < pixelsPerMillisecond_ ? 0.7 : 0.3;
    pixelsPerMillisecond_ =
        pixelsPerMillisecond_ == 0.0 ? rate : std::lerp(pixelsPerMillisecond_, rate, share);
}

std::pair<int, int> InteractiveResolution::sizeFor(int width, int height) const {
    constexpr double firstGuess = 0.5; // linear scale, before anything was measured
    const double pixels = static_cast<double>(width) * height;
    double scale = firstGuess;
    if (pixelsPerMillisecond_ > 0.0)
        scale = std::min(1.0, std::sqrt(pixelsPerMillisecond_ * targetMilliseconds / pixels));
    const int smallest = std::min({smallestSide, width, height});
    // In steps of a sixteenth, so that small changes of speed do not change the size with every picture.
    scale = scale < 1.0 ? std::max(std::floor(scale * 16.0), 1.0) / 16.0 : 1.0;
    return {std::max(static_cast<int>(std::lround(width * scale)), smallest),
            std::max(static_cast<int>(std::lround(height * scale)), smallest)};
}

} // namespace prizma
