#pragma once

namespace prizma {

/// Which frames a ruler shows where: frame `first` at its left end, frame `last` at its right end.
class RulerScale {
  public:
    RulerScale() = default;

    /// `last` is more than `first`, `width` (pixels) more than 0; else both are mended.
    RulerScale(double first, double last, double width);

    double first() const { return first_; }
    double last() const { return last_; }
    double pixelsPerFrame() const { return width_ / (last_ - first_); }

    double xOf(double frame) const { return (frame - first_) * pixelsPerFrame(); }
    double frameAt(double x) const { return first_ + x / pixelsPerFrame(); }

    RulerScale withWidth(double width) const { return {first_, last_, width}; }
    RulerScale panned(double pixels) const; ///< What is shown moves by that many pixels to the right.

    /// `factor` times as many pixels a frame; the frame at `x` stays there. Ends where a frame fills the
    /// ruler, and at a hundred million frames.
    RulerScale zoomed(double factor, double x) const;

    /// Frames between two marks that are to be at least `pixels` apart: 1, 2, 5, 10, 20, 50, ...
    int markStep(double pixels) const;

  private:
    double first_ = 0.0;
    double last_ = 100.0;
    double width_ = 100.0;
};

} // namespace prizma
