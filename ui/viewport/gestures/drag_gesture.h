#pragma once

#include <QPointF>
#include <Qt>

namespace prizma {

/// Something that is done by pressing a button and moving the mouse.
class DragGesture {
  public:
    DragGesture() = default;
    virtual ~DragGesture() = default;
    DragGesture(const DragGesture&) = delete;
    DragGesture& operator=(const DragGesture&) = delete;

    /// Whether a drag that starts with this button and these keys is this gesture.
    virtual bool startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const = 0;

    virtual Qt::CursorShape cursor() const = 0;

    /// The button went down at `position`. A click may still come of it.
    virtual void begin(const QPointF& position) = 0;

    virtual void drag(const QPointF& from, const QPointF& to) = 0;
};

} // namespace prizma
