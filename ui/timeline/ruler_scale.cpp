#include "ui/timeline/ruler_scale.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double fewestFrames = 1.0;
constexpr double mostFrames = 1e8;

} // namespace

RulerScale::RulerScale(double first, double last, double width)
    : first_(first), last_(std::max(last, first + fewestFrames)), width_(std::max(width, 1.0)) {}

RulerScale RulerScale::panned(double pixels) const {
    const double frames = pixels / pixelsPerFrame();
    return {first_ - frames, last_ - frames, width_};
}

RulerScale RulerScale::zoomed(double factor, double x) const {
    const double anchor = frameAt(x);
    const double frames = std::clamp((last_ - first_) / factor, fewestFrames, mostFrames);
    const double share = x / width_;
    return {anchor - frames * share, anchor + frames * (1.0 - share), width_};
}

int RulerScale::markStep(double pixels) const {
    const double wanted = pixels / pixelsPerFrame();
    constexpr int largest = 500'000'000;
    for (int decade = 1; decade < largest / 5; decade *= 10)
        for (const int step : {decade, 2 * decade, 5 * decade})
            if (step >= wanted)
                return step;
    return largest;
}

} // namespace prizma
