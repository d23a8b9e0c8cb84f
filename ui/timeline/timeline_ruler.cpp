#include "ui/timeline/timeline_ruler.h"

#include "ui/document/document.h"
#include "ui/main_window/theme.h"
#include "ui/timeline/clip_edits.h"
#include "ui/timeline/timeline_controller.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double margin = 22.0;   // Beyond the range's ends, for their labels and the playhead's.
constexpr double labelGap = 18.0; // Between two labels.
constexpr double tickGap = 5.0;
constexpr double longTick = 9.0;
constexpr double shortTick = 5.0;
constexpr double shortestBar = 6.0; // Clips that repeat more quickly become one bar.

/// A number that grows and shrinks by one place must not shift the others.
double labelWidth(const QFontMetricsF& metrics, double frame) {
    return metrics.horizontalAdvance(QString::number(std::llround(frame)));
}

/// A whole pixel's middle, so that thin lines are sharp.
double crisp(double x) {
    return std::floor(x) + 0.5;
}

} // namespace

TimelineRuler::TimelineRuler(Document& document, TimelineController& controller, QWidget* parent)
    : QWidget(parent), document_(document), controller_(controller) {
    setObjectName(QStringLiteral("timelineRuler"));
    setAccessibleName(tr("Timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(tr("Drag to move in time; turn the wheel to zoom, double-click to see all"));
    connect(&document, &Document::sceneChanged, this, &TimelineRuler::follow);
    connect(&document, &Document::replaced, this, [this] { zoomed_ = false; });
    connect(&document, &Document::selectionChanged, this, qOverload<>(&QWidget::update));
    follow();
}

QSize TimelineRuler::sizeHint() const {
    return {480, fontMetrics().height() * 3};
}

QSize TimelineRuler::minimumSizeHint() const {
    return {120, fontMetrics().height() * 2 + 24};
}

double TimelineRuler::xOf(double frame) const {
    return scale_.xOf(frame);
}

void TimelineRuler::showAll() {
    zoomed_ = false;
    follow();
}

void TimelineRuler::follow() {
    const Timeline& timeline = document_.scene().timeline;
    const double width = std::max(QWidget::width(), 1);
    if (zoomed_) {
        scale_ = scale_.withWidth(width);
    } else {
        const double last = std::max(timeline.end, timeline.start + 1);
        const double frames = (last - timeline.start) * margin / std::max(width - 2.0 * margin, 1.0);
        scale_ = {timeline.start - frames, last + frames, width};
    }
    update();
}

void TimelineRuler::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    follow();
}

void TimelineRuler::scrubTo(double x, Qt::KeyboardModifiers modifiers) {
    const double frame = scale_.frameAt(x);
    controller_.goTo(modifiers.testFlag(Qt::ShiftModifier) ? frame : std::round(frame));
}

void TimelineRuler::mousePressEvent(QMouseEvent* event) {
    if (button_ != Qt::NoButton)
        return; // a second button during a drag changes nothing
    button_ = event->button();
    lastX_ = event->position().x();
    if (button_ == Qt::LeftButton) {
        controller_.beginScrub();
        scrubTo(lastX_, event->modifiers());
    } else if (button_ == Qt::MiddleButton) {
        setCursor(Qt::ClosedHandCursor);
    }
}

void TimelineRuler::mouseMoveEvent(QMouseEvent* event) {
    if (button_ != Qt::NoButton && !event->buttons().testFlag(button_)) {
        endDrag(); // the release went elsewhere
        return;
    }
    const double x = event->position().x();
    if (button_ == Qt::LeftButton) {
        scrubTo(x, event->modifiers());
    } else if (button_ == Qt::MiddleButton) {
        zoomed_ = true;
        scale_ = scale_.panned(x - lastX_);
        update();
    }
    lastX_ = x;
}

void TimelineRuler::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == button_)
        endDrag();
}

void TimelineRuler::endDrag() {
    if (button_ == Qt::LeftButton)
        controller_.endScrub();
    unsetCursor();
    button_ = Qt::NoButton;
}

void TimelineRuler::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && zoomed_)
        showAll();
    else
        mousePressEvent(event);
}

void TimelineRuler::wheelEvent(QWheelEvent* event) {
    const double turns = event->angleDelta().y() / 120.0;
    if (turns != 0.0) {
        zoomed_ = true;
        scale_ = scale_.zoomed(std::pow(1.25, turns), event->position().x());
        update();
    }
    event->accept();
}

/// Of the band with the numbers and the marks.
double TimelineRuler::bandHeight() const {
    return fontMetrics().height() + 4.0 + longTick;
}

void TimelineRuler::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    paintRange(painter);
    paintMarks(painter);
    paintClip(painter);
    paintPlayhead(painter);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

/// What plays is dark, what lies beyond has the window's colour.
void TimelineRuler::paintRange(QPainter& painter) const {
    const Timeline& timeline = document_.scene().timeline;
    const double left = std::max(xOf(timeline.start), -1.0);
    const double right = std::min(xOf(std::max(timeline.start, timeline.end)), width() + 1.0);
    if (left > right)
        return;
    painter.fillRect(QRectF(left, 0.0, std::max(right - left, 1.0), height()),
                     palette().color(QPalette::Base));
}

void TimelineRuler::paintMarks(QPainter& painter) const {
    const QFontMetricsF metrics(font());
    const double widest = std::max(labelWidth(metrics, scale_.first()), labelWidth(metrics, scale_.last()));
    const int labelStep = scale_.markStep(widest + labelGap);
    const int tickStep = scale_.markStep(tickGap);
    const double bottom = bandHeight();
    painter.setPen(palette().color(QPalette::Light));
    forEachMark(tickStep, [&](double frame) {
        const double x = crisp(xOf(frame));
        painter.drawLine(QPointF(x, bottom - shortTick), QPointF(x, bottom));
    });
    forEachMark(labelStep, [&](double frame) {
        const double x = crisp(xOf(frame));
        painter.setPen(palette().color(QPalette::Button));
        painter.drawLine(QPointF(x, bottom), QPointF(x, height()));
        painter.setPen(theme::dim());
        painter.drawLine(QPointF(x, bottom - longTick), QPointF(x, bottom));
        painter.drawText(QRectF(x - widest, 2.0, 2.0 * widest, metrics.height()), Qt::AlignCenter,
                         QString::number(frame, 'f', 0));
    });
}

/// From the one before the left edge to the one behind the right edge, whose numbers reach into view.
void TimelineRuler::forEachMark(int step, const std::function<void(double)>& draw) const {
    const auto last = static_cast<long long>(std::ceil(scale_.last() / step));
    for (auto i = static_cast<long long>(std::floor(scale_.first() / step)); i <= last; ++i)
        draw(static_cast<double>(i) * step);
}

/// A bar for each time that the clip plays.
void TimelineRuler::paintClip(QPainter& painter) const {
    const auto span = playingSpan(document_);
    if (!span)
        return;
    if (!span->repeats) {
        paintBar(painter, span->start, span->start + span->frames, span->name);
        return;
    }
    const double first = std::floor((scale_.first() - span->start) / span->frames);
    const double last = std::floor((scale_.last() - span->start) / span->frames);
    if (span->frames * scale_.pixelsPerFrame() < shortestBar) {
        paintBar(painter, span->start + first * span->frames, span->start + (last + 1.0) * span->frames,
                 span->name);
        return;
    }
    for (auto i = static_cast<long long>(first); i <= static_cast<long long>(last); ++i) {
        const double start = span->start + static_cast<double>(i) * span->frames;
        paintBar(painter, start, start + span->frames, span->name);
    }
}

void TimelineRuler::paintBar(QPainter& painter, double start, double end, const QString& name) const {
    const double top = bandHeight() + 4.0;
    const double size = std::min(height() - top - 4.0, fontMetrics().height() + 6.0);
    if (size < 4.0)
        return;
    QColor fill = theme::accent();
    fill.setAlpha(56);
    const double left = std::max(xOf(start), -10.0);
    const QRectF bar(left + 0.5, top, std::min(xOf(end), width() + 10.0) - left - 1.0, size);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(bar, 3.0, 3.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QRectF inner = bar.intersected(rect()).adjusted(6.0, 0.0, -6.0, 0.0);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(
        inner, Qt::AlignVCenter | Qt::AlignLeft,
        fontMetrics().elidedText(name, Qt::ElideRight, std::max(static_cast<int>(inner.width()), 0)));
}

void TimelineRuler::paintPlayhead(QPainter& painter) const {
    const double frame = document_.scene().timeline.frame;
    const double x = crisp(xOf(frame));
    const QFontMetricsF metrics(font());
    const QString text = QString::number(std::floor(frame + 1e-6), 'f', 0);
    const double halfWidth = std::max(metrics.horizontalAdvance(text) * 0.5 + 6.0, 11.0);
    const QRectF badge(x - halfWidth, 1.0, 2.0 * halfWidth, metrics.height() + 2.0);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::accent(), 1.0));
    painter.drawLine(QPointF(x, badge.bottom()), QPointF(x, height()));
    painter.setPen(QPen(palette().color(QPalette::Base), 4.0)); // keeps off the number beside it
    painter.setBrush(theme::accent());
    painter.drawRoundedRect(badge, 3.0, 3.0);
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(badge, 3.0, 3.0);
    painter.setPen(palette().color(QPalette::Base));
    painter.drawText(badge, Qt::AlignCenter, text);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace prizma
