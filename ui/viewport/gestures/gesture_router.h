#pragma once

#include "core/scene/camera.h"
#include "ui/viewport/gestures/click_handlers.h"
#include "ui/viewport/gestures/drag_gesture.h"
#include "ui/viewport/gestures/zoom_gesture.h"

#include <QObject>
#include <QPoint>

#include <memory>
#include <vector>

class QMouseEvent;
class QWheelEvent;

namespace prizma {

/// Tells clicks from drags and hands each to the one gesture it belongs to.
class GestureRouter : public QObject {
    Q_OBJECT

  public:
    /// Keeps references to both; `view` gets the cursors of gestures.
    GestureRouter(QWidget& view, GestureContext& context);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);

    bool isDragging() const { return dragging_; }

    /// Ends the drag that is going on and puts the camera back to where it began.
    void cancel();

  Q_SIGNALS:
    /// A right click that was not a drag.
    void contextMenuRequested(const QPoint& globalPosition);

  private:
    void click(const QMouseEvent& event);
    void finish();

    QWidget& view_;
    GestureContext& context_;
    std::vector<std::unique_ptr<DragGesture>> drags_;
    WheelZoom wheelZoom_;
    SelectClick selectClick_;
    TargetDoubleClick targetDoubleClick_;

    Qt::MouseButton button_ = Qt::NoButton; ///< That went down first and is still down.
    bool doubleClick_ = false;              ///< `button_` went down for the second time.
    bool dragging_ = false;
    DragGesture* drag_ = nullptr; ///< Of `button_`; null if it has none.
    QPointF last_;                ///< Where the pointer was, or where the button went down.
    Camera cameraBefore_;
};

} // namespace prizma
