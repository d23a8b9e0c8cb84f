#pragma once

#include "ui/viewport/gestures/drag_gesture.h"
#include "ui/viewport/gestures/gesture_context.h"

#include <optional>

namespace prizma {

/// Middle drag, or Shift and left drag: moves the camera sideways so that what was grabbed stays under the
/// pointer.
class PanGesture : public DragGesture {
  public:
    explicit PanGesture(GestureContext& context) : context_(context) {}

    bool startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const override;
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }
    void begin(const QPointF& position) override;
    void drag(const QPointF& from, const QPointF& to) override;

  private:
    GestureContext& context_;
    std::optional<double> grabbedDepth_; ///< Until it is known, the target's depth serves.
    int number_ = 0;                     ///< Of the drag, to tell answers to an earlier one.
};

} // namespace prizma
