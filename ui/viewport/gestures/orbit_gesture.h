#pragma once

#include "ui/viewport/gestures/drag_gesture.h"
#include "ui/viewport/gestures/gesture_context.h"

namespace prizma {

/// Left drag: turns the camera about its target, as if the scene stood on a turntable under the hand.
class OrbitGesture : public DragGesture {
  public:
    explicit OrbitGesture(GestureContext& context) : context_(context) {}

    bool startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const override;
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }
    void begin(const QPointF&) override {}
    void drag(const QPointF& from, const QPointF& to) override;

  private:
    GestureContext& context_;
};

} // namespace prizma
