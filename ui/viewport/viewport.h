#pragma once

#include "core/render/render_thread.h"
#include "core/scene/bounds.h"
#include "core/scene/camera_motion.h"
#include "ui/viewport/frame_meter.h"
#include "ui/viewport/gestures/gesture_context.h"
#include "ui/viewport/gestures/gesture_router.h"
#include "ui/viewport/interaction_clock.h"
#include "ui/viewport/viewport_notice.h"

#include <QImage>
#include <QPointer>
#include <QWidget>

namespace prizma {

class Document;
class RenderSession;
class SkeletonOverlay;
class StatisticsOverlay;

/// The ray-traced picture of the document's scene. Asks for a new one whenever the scene or the view changes,
/// and for nothing while it is hidden or nothing changes. Drags move the camera, a click selects.
class Viewport : public QWidget {
    Q_OBJECT

  public:
    /// Keeps references to both.
    Viewport(Document& document, RenderSession& session, QWidget* parent = nullptr);
    ~Viewport() override;

    void frameSelected(); ///< Moves the camera to show what is selected, or everything if that has no place.
    void frameAll();

    /// Paused, the picture that is there stays; edits show when it goes on.
    void setPaused(bool paused);
    bool isPaused() const { return paused_; }

    void setStatisticsVisible(bool visible);
    bool isStatisticsVisible() const;

    void setSkeletonsVisible(bool visible); ///< Bones over the picture.

    double framesPerSecond() const; ///< Pictures shown in the last second; 0 when idle.
    FramePtr lastFrame() const { return frame_; }

    void viewFrom(ViewDirection direction);

    QSize sizeHint() const override { return {960, 600}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

  Q_SIGNALS:
    void framesPerSecondChanged(double fps); ///< At most four times a second, with 0 at last.
    void contextMenuRequested(const QPoint& globalPosition);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void connectSession();
    void watchWindow();
    void requestPicture();
    void stopRendering();
    void showFrame(const FramePtr& frame);
    void updateStatistics();
    void updateSkeletons();
    void frame(const DBounds& bounds);
    bool canBeSeen() const;
    QSize pixelSize() const;

    Document& document_;
    RenderSession& session_;
    InteractionClock clock_;
    FrameMeter meter_;
    GestureContext gestureContext_;
    GestureRouter gestures_;
    ViewportNotice notice_;
    SkeletonOverlay* skeletons_; ///< Owned as a child, as the next.
    StatisticsOverlay* overlay_;
    QPointer<QWidget> watchedWindow_;

    FramePtr frame_;
    QImage image_;            ///< Of `frame_`, in the screen's own format.
    bool frameIsNew_ = false; ///< Not painted yet.
    QSize requestedSize_;
    bool paused_ = false;
};

} // namespace prizma
