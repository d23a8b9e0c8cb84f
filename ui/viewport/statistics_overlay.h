#pragma once

#include "core/render/render_thread.h"

#include <QString>
#include <QWidget>

#include <vector>

namespace prizma {

/// A translucent panel over the viewport: how fast, how far, and which stages ran and why. Lets the mouse
/// through.
class StatisticsOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit StatisticsOverlay(QWidget* parent);

    /// Shows the figures of `frame` (may be null) and resizes itself to fit.
    void show(const FramePtr& frame, double framesPerSecond);
    using QWidget::show;

    /// What it shows, a line a row, for screen readers and tests.
    QString text() const;

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        QString label;
        QString note; ///< Why a stage ran.
        QString value;
    };
    struct Columns {
        int label = 0, note = 0, value = 0, rowHeight = 0;
    };

    void addSummary(const Frame& frame, double framesPerSecond);
    void addStages(const std::vector<StageStatistics>& stages);
    Columns columns() const;
    QFont figureFont() const;

    QString title_;
    std::vector<Row> summary_;
    std::vector<Row> stages_;
};

} // namespace prizma
