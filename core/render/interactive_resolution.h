#pragma once

#include <utility>

namespace prizma {

/// Chooses how many pixels to draw while a gesture goes on, so that a pass keeps to its time.
class InteractiveResolution {
  public:
    static constexpr double targetMilliseconds =
        28.0; ///< Leaves room for the screen at 30 pictures a second.
    static constexpr int smallestSide = 64;

    /// A pass of `pixels` pixels took this long.
    void measured(double pixels, double milliseconds);

    /// The picture's size for a view while interacting: at most that of the view, with its aspect.
    std::pair<int, int> sizeFor(int width, int height) const;

  private:
    double pixelsPerMillisecond_ = 0.0; ///< Smoothed; 0 until the first measurement.
};

} // namespace prizma
