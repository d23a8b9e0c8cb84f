#pragma once

#include "ui/viewport/gestures/gesture_context.h"

#include <QElapsedTimer>

#include <optional>

namespace prizma {

/// The point in the world that a zoom goes to: what is under the pointer. What that is gets known a little
/// later; until then, and over the background, it is the point as far away as the camera's target. Both lie
/// on the same line of sight, so that the picture does not jump when the answer comes.
class ZoomAnchor {
  public:
    explicit ZoomAnchor(GestureContext& context) : context_(context) {}

    /// A zoom to `position` goes on or starts. It counts as a new one after a rest or a move of the pointer.
    void aim(const QPointF& position);

    glm::dvec3 point() const;

  private:
    GestureContext& context_;
    QPointF position_;
    QElapsedTimer sinceAimed_;
    std::optional<glm::dvec3> hit_;
    int number_ = 0; ///< Of the zoom, to tell answers to an earlier one.
};

} // namespace prizma
