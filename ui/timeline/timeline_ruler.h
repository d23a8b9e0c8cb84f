#pragma once

#include "ui/timeline/ruler_scale.h"

#include <QWidget>

#include <functional>

namespace prizma {

class Document;
class TimelineController;

/// The frames of the timeline as a ruler with a playhead, and below it the clip that plays. Dragging scrubs
/// (with Shift also between frames), the wheel zooms to the pointer, dragging with the middle button moves
/// the ruler, a double click shows the whole range again.
class TimelineRuler : public QWidget {
    Q_OBJECT

  public:
    /// Keeps references to both.
    TimelineRuler(Document& document, TimelineController& controller, QWidget* parent = nullptr);

    /// Where a frame is, in pixels from the left edge.
    double xOf(double frame) const;

    void showAll(); ///< The whole range, from now on also when it changes.

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void follow();
    void scrubTo(double x, Qt::KeyboardModifiers modifiers);
    void endDrag();
    double bandHeight() const;
    void paintRange(QPainter& painter) const;
    void forEachMark(int step, const std::function<void(double)>& draw) const;
    void paintClip(QPainter& painter) const;
    void paintBar(QPainter& painter, double start, double end, const QString& name) const;
    void paintMarks(QPainter& painter) const;
    void paintPlayhead(QPainter& painter) const;

    Document& document_;
    TimelineController& controller_;
    RulerScale scale_;
    bool zoomed_ = false; ///< By hand: it shows what it shows, whatever the range is.
    Qt::MouseButton button_ = Qt::NoButton;
    double lastX_ = 0.0;
};

} // namespace prizma
