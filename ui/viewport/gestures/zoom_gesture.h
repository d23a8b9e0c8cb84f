#pragma once

#include "ui/viewport/gestures/drag_gesture.h"
#include "ui/viewport/gestures/zoom_anchor.h"

namespace prizma {

/// Right drag: up goes to what was under the pointer when the button went down, down goes away from it.
class ZoomGesture : public DragGesture {
  public:
    explicit ZoomGesture(GestureContext& context) : context_(context), anchor_(context) {}

    bool startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const override;
    Qt::CursorShape cursor() const override { return Qt::SizeVerCursor; }
    void begin(const QPointF& position) override { anchor_.aim(position); }
    void drag(const QPointF& from, const QPointF& to) override;

  private:
    GestureContext& context_;
    ZoomAnchor anchor_;
};

/// Mouse wheel or two fingers on a touchpad: goes to what is under the pointer.
class WheelZoom {
  public:
    explicit WheelZoom(GestureContext& context) : context_(context), anchor_(context) {}

    /// `angle` as in QWheelEvent: 120 is one notch away from the hand.
    void turn(const QPointF& position, double angle);

  private:
    GestureContext& context_;
    ZoomAnchor anchor_;
};

} // namespace prizma
