#include "ui/viewport/gestures/gesture_router.h"

#include "ui/viewport/gestures/orbit_gesture.h"
#include "ui/viewport/gestures/pan_gesture.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>

namespace prizma {
namespace {

constexpr double dragThreshold = 4.0; // Pixels that a hand may move during a click.

} // namespace

GestureRouter::GestureRouter(QWidget& view, GestureContext& context)
    : view_(view),
      context_(context),
      wheelZoom_(context),
      selectClick_(context),
      targetDoubleClick_(context) {
    drags_.push_back(std::make_unique<OrbitGesture>(context));
    drags_.push_back(std::make_unique<PanGesture>(context));
    drags_.push_back(std::make_unique<ZoomGesture>(context));
}

void GestureRouter::press(const QMouseEvent& event) {
    if (button_ != Qt::NoButton && button_ != event.button() && event.buttons().testFlag(button_))
        return; // A second button during a drag changes nothing.
    finish();   // If the last release went elsewhere.
    button_ = event.button();
    doubleClick_ = event.type() == QEvent::MouseButtonDblClick;
    if (doubleClick_ && button_ == Qt::LeftButton)
        targetDoubleClick_.click(event.position());
    last_ = event.position();
    cameraBefore_ = context_.camera();
    const auto found = std::find_if(drags_.begin(), drags_.end(), [&](const auto& drag) {
        return drag->startsWith(event.button(), event.modifiers());
    });
    drag_ = found == drags_.end() ? nullptr : found->get();
    if (drag_)
        drag_->begin(last_);
}

void GestureRouter::move(const QMouseEvent& event) {
    if (button_ == Qt::NoButton)
        return;
    if (!event.buttons().testFlag(button_)) {
        finish(); // The release went elsewhere, to a popup for instance.
        return;
    }
    if (!drag_)
        return;
    if (!dragging_) {
        if ((event.position() - last_).manhattanLength() < dragThreshold)
            return;
        dragging_ = true;
        view_.setCursor(drag_->cursor());
    }
    drag_->drag(last_, event.position());
    last_ = event.position();
}

void GestureRouter::release(const QMouseEvent& event) {
    if (event.button() != button_)
        return;
    const bool wasDrag = dragging_;
    finish();
    if (!wasDrag)
        click(event);
}

void GestureRouter::click(const QMouseEvent& event) {
    if (event.button() == Qt::RightButton)
        Q_EMIT contextMenuRequested(event.globalPosition().toPoint());
    else if (event.button() == Qt::LeftButton && !doubleClick_)
        selectClick_.click(event.position(), event.modifiers());
}

void GestureRouter::wheel(const QWheelEvent& event) {
    if (event.angleDelta().y() != 0)
        wheelZoom_.turn(event.position(), event.angleDelta().y());
}

void GestureRouter::cancel() {
    if (!dragging_)
        return;
    finish();
    context_.moveCamera(cameraBefore_);
}

void GestureRouter::finish() {
    if (dragging_)
        view_.unsetCursor();
    button_ = Qt::NoButton;
    drag_ = nullptr;
    dragging_ = false;
}

} // namespace prizma
