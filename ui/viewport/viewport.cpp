#include "ui/viewport/viewport.h"

#include "core/animation/pose_key.h"
#include "core/animation/posed_bounds.h"
#include "ui/document/document.h"
#include "ui/viewport/render_session.h"
#include "ui/viewport/selection_bounds.h"
#include "ui/viewport/skeleton_overlay.h"
#include "ui/viewport/statistics_overlay.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>

namespace prizma {
namespace {

constexpr QColor emptyColor{30, 32, 37};
constexpr int overlayMargin = 10;

/// In the format that the screen's buffer has, so that painting it again costs little.
QImage imageOf(const Frame& frame) {
    if (frame.width <= 0 || frame.height <= 0 ||
        frame.pixels.size() <
            static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 4)
        return {};
    const QImage view(frame.pixels.data(), frame.width, frame.height, static_cast<qsizetype>(frame.width) * 4,
                      QImage::Format_RGBX8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

bool isAnimated(const Object& object) {
    return object.visible && isPosed(object) && findClip(object, object.clip);
}

} // namespace

Viewport::Viewport(Document& document, RenderSession& session, QWidget* parent)
    : QWidget(parent),
      document_(document),
      session_(session),
      clock_(this),
      meter_(this),
      gestureContext_(*this, document, session, clock_),
      gestures_(*this, gestureContext_),
      skeletons_(new SkeletonOverlay(*this)),
      overlay_(new StatisticsOverlay(this)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Viewport"));
    overlay_->move(overlayMargin, overlayMargin);
    overlay_->hide();
    skeletons_->hide();
    notice_.setDevice(session.device());

    connect(&document, &Document::sceneChanged, this, [this](const SceneDiff& changes) {
        if (changes.isEmpty())
            return;
        // A picture in which nothing moves need not get coarser because the timeline plays.
        const auto& objects = document_.scene().objects;
        if (!changes.isTimeOnly() || std::any_of(objects.begin(), objects.end(), isAnimated))
            clock_.noteChange();
        requestPicture();
    });
    connect(&document, &Document::previewChanged, this, [this] {
        clock_.noteChange();
        requestPicture();
    });
    connect(&document, &Document::selectionChanged, this, &Viewport::updateSkeletons);
    connect(&clock_, &InteractionClock::ended, this, &Viewport::requestPicture);
    connect(&gestures_, &GestureRouter::contextMenuRequested, this, &Viewport::contextMenuRequested);
    connect(&meter_, &FrameMeter::updated, this, [this](double fps) {
        updateStatistics();
        Q_EMIT framesPerSecondChanged(fps);
    });
    connectSession();
}

Viewport::~Viewport() = default;

void Viewport::connectSession() {
    connect(&session_, &RenderSession::frameReady, this, &Viewport::showFrame);
    connect(&session_, &RenderSession::deviceChanged, this, [this](const DeviceInfo& device) {
        notice_.setDevice(device);
        requestPicture();
        update();
    });
    connect(&session_, &RenderSession::message, this, [this](const Diagnostic& diagnostic) {
        notice_.setMessage(diagnostic);
        if (!frame_)
            update();
    });
    connect(&session_, &RenderSession::activityChanged, this, [this](const QString& what, bool running) {
        notice_.setActivity(what, running);
        if (!frame_)
            update();
    });
}

bool Viewport::canBeSeen() const {
    return isVisible() && !window()->isMinimized();
}

QSize Viewport::pixelSize() const {
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void Viewport::requestPicture() {
    if (!canBeSeen())
        return;
    requestedSize_ = pixelSize();
    RenderRequest request;
    request.scene = document_.shownScene();
    request.width = requestedSize_.width();
    request.height = requestedSize_.height();
    request.interacting = clock_.isInteracting();
    request.paused = paused_;
    session_.submit(std::move(request));
}

/// A picture that nobody sees need not become any better.
void Viewport::stopRendering() {
    if (requestedSize_.isEmpty())
        return;
    RenderRequest request;
    request.scene = document_.shownScene();
    request.width = requestedSize_.width();
    request.height = requestedSize_.height();
    request.paused = true;
    session_.submit(std::move(request));
}

void Viewport::showFrame(const FramePtr& frame) {
    frame_ = frame;
    image_ = imageOf(*frame);
    frameIsNew_ = true;
    // Figures that change with every picture cannot be read: the meter updates them, but the last ones must
    // show.
    if (frame->isFinal || framesPerSecond() == 0.0)
        updateStatistics();
    updateSkeletons();
    update();
}

void Viewport::updateSkeletons() {
    if (skeletons_->isVisibleTo(this))
        skeletons_->show(frame_, document_.selection());
}

void Viewport::updateStatistics() {
    if (overlay_->isVisibleTo(this))
        overlay_->show(frame_, framesPerSecond());
}

double Viewport::framesPerSecond() const {
    return meter_.framesPerSecond();
}

void Viewport::setPaused(bool paused) {
    if (paused == paused_)
        return;
    paused_ = paused;
    requestPicture();
}

void Viewport::setStatisticsVisible(bool visible) {
    overlay_->setVisible(visible);
    updateStatistics();
}

void Viewport::setSkeletonsVisible(bool visible) {
    skeletons_->setVisible(visible);
    updateSkeletons();
}

bool Viewport::isStatisticsVisible() const {
    return overlay_->isVisibleTo(this);
}

void Viewport::frameSelected() {
    const DBounds bounds = selectionBounds(document_.scene(), document_.selection());
    if (bounds.isEmpty())
        frameAll();
    else
        frame(bounds);
}

void Viewport::frameAll() {
    frame(worldBounds(document_.scene()));
}

void Viewport::frame(const DBounds& bounds) {
    const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
    document_.setCamera(frameBounds(mended(document_.scene().camera), bounds, aspect));
}

void Viewport::viewFrom(ViewDirection direction) {
    document_.setCamera(prizma::viewFrom(document_.scene().camera, direction));
}

void Viewport::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (image_.isNull()) {
        painter.fillRect(rect(), emptyColor);
        notice_.paint(painter, rect());
    } else {
        const bool exact = image_.size() == pixelSize();
        painter.setRenderHint(QPainter::SmoothPixmapTransform, !exact);
        image_.setDevicePixelRatio(exact ? devicePixelRatioF() : 1.0);
        if (exact)
            painter.drawImage(QPoint(0, 0), image_);
        else
            painter.drawImage(rect(), image_);
    }
    if (frameIsNew_) {
        frameIsNew_ = false;
        meter_.noteFrame();
    }
    // A move to a screen with other pixels tells in nothing but this.
    if (requestedSize_ != pixelSize())
        requestPicture();
}

void Viewport::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    clock_.noteChange();
    requestPicture();
}

void Viewport::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    watchWindow();
    requestPicture();
}

void Viewport::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    stopRendering();
}

/// Minimising does not hide the widgets of a window on every platform.
void Viewport::watchWindow() {
    if (watchedWindow_ == window())
        return;
    if (watchedWindow_)
        watchedWindow_->removeEventFilter(this);
    watchedWindow_ = window();
    watchedWindow_->installEventFilter(this);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::WindowStateChange && watched == watchedWindow_ && isVisible()) {
        if (canBeSeen())
            requestPicture();
        else
            stopRendering();
    }
    return QWidget::eventFilter(watched, event);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    gestures_.press(*event);
}
void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    gestures_.press(*event);
}
void Viewport::mouseMoveEvent(QMouseEvent* event) {
    gestures_.move(*event);
}
void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    gestures_.release(*event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    gestures_.wheel(*event);
    event->accept();
}

bool Viewport::event(QEvent* event) {
    // During a drag, Escape belongs to it and not to a shortcut of the window.
    if (event->type() == QEvent::ShortcutOverride && gestures_.isDragging() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    return QWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && gestures_.isDragging())
        gestures_.cancel();
    else
        QWidget::keyPressEvent(event);
}

void Viewport::contextMenuEvent(QContextMenuEvent* event) {
    // With the mouse, the menu waits for the release, because the press may be the start of a zoom.
    if (event->reason() != QContextMenuEvent::Mouse)
        Q_EMIT contextMenuRequested(mapToGlobal(rect().center()));
    event->accept();
}

} // namespace prizma
