#include "ui/viewport/statistics_overlay.h"

#include <QEvent>
#include <QFontDatabase>
#include <QLocale>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr int padding = 12;
constexpr int columnGap = 16;
constexpr int rowGap = 4;
constexpr int titleGap = 4;
constexpr int blockGap = 8; // Above and below the line between the blocks.
constexpr int longestNote = 260;

constexpr QColor panelColor{18, 20, 24, 200};
constexpr QColor edgeColor{255, 255, 255, 28};
constexpr QColor labelColor{200, 205, 214};
constexpr QColor noteColor{140, 147, 160};
constexpr QColor valueColor{245, 247, 250};

QString raysPerSecond(const RenderStatistics& statistics) {
    if (!(statistics.passMilliseconds > 0.0) || statistics.rays.total() == 0)
        return QStringLiteral("–");
    const double millions =
        static_cast<double>(statistics.rays.total()) / (statistics.passMilliseconds * 1000.0);
    return StatisticsOverlay::tr("%1 M/s").arg(QLocale().toString(millions, 'f', 1));
}

QString milliseconds(double value) {
    return StatisticsOverlay::tr("%1 ms").arg(QLocale().toString(value, 'f', 2));
}

} // namespace

StatisticsOverlay::StatisticsOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Statistics"));
}

void StatisticsOverlay::show(const FramePtr& frame, double framesPerSecond) {
    summary_.clear();
    stages_.clear();
    title_.clear();
    if (frame) {
        title_ = QString::fromStdString(frame->statistics.device);
        addSummary(*frame, framesPerSecond);
        addStages(frame->statistics.stages);
    }
    setAccessibleDescription(text());
    resize(sizeHint());
    update();
}

void StatisticsOverlay::addSummary(const Frame& frame, double framesPerSecond) {
    const QLocale locale;
    const RenderStatistics& statistics = frame.statistics;
    summary_ = {
        {tr("Frames a second"), {}, locale.toString(framesPerSecond, 'f', 0)},
        {tr("Samples"), frame.isDenoised ? tr("denoised preview") : QString(),
         QStringLiteral("%1 / %2").arg(frame.samples).arg(frame.sampleLimit)},
        {tr("Resolution"), {}, QStringLiteral("%1 × %2").arg(frame.width).arg(frame.height)},
        {tr("Rays"), {}, raysPerSecond(statistics)},
        {tr("Triangles"), {}, locale.toString(static_cast<qulonglong>(statistics.triangles))},
        {tr("Device memory"), {}, locale.formattedDataSize(static_cast<qint64>(statistics.deviceBytes), 1)},
    };
    if (statistics.nonFinitePixels > 0)
        summary_.push_back({tr("Pixels without a number"),
                            {},
                            locale.toString(static_cast<qulonglong>(statistics.nonFinitePixels))});
}

void StatisticsOverlay::addStages(const std::vector<StageStatistics>& stages) {
    for (const StageStatistics& stage : stages) {
        QString note = QString::fromStdString(stage.why);
        if (stage.objects > 0) {
            const QString objects =
                stage.objects == 1 ? tr("1 object") : tr("%n objects", nullptr, stage.objects);
            note = note.isEmpty() ? objects : QStringLiteral("%1, %2").arg(note, objects);
        }
        stages_.push_back({QString::fromStdString(stage.stage), note, milliseconds(stage.milliseconds)});
    }
}

QString StatisticsOverlay::text() const {
    QStringList lines{title_};
    for (const auto* rows : {&summary_, &stages_})
        for (const Row& row : *rows)
            lines << QStringList{row.label, row.note, row.value}.join(u'\t');
    return lines.join(u'\n');
}

QFont StatisticsOverlay::figureFont() const {
    QFont figures = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    figures.setPointSizeF(font().pointSizeF());
    return figures;
}

StatisticsOverlay::Columns StatisticsOverlay::columns() const {
    const QFontMetrics words(font());
    const QFontMetrics figures(figureFont());
    Columns columns;
    columns.rowHeight = std::max(words.height(), figures.height()) + rowGap;
    for (const auto* rows : {&summary_, &stages_})
        for (const Row& row : *rows) {
            columns.label = std::max(columns.label, words.horizontalAdvance(row.label));
            columns.note = std::max(columns.note, words.horizontalAdvance(row.note));
            columns.value = std::max(columns.value, figures.horizontalAdvance(row.value));
        }
    columns.note = std::min(columns.note, longestNote);
    return columns;
}

QSize StatisticsOverlay::sizeHint() const {
    const Columns wide = columns();
    const int noteSpace = wide.note > 0 ? wide.note + columnGap : 0;
    const int content = wide.label + columnGap + noteSpace + wide.value;
    const int rows = 1 + static_cast<int>(summary_.size() + stages_.size());
    const int separator = stages_.empty() ? 0 : 2 * blockGap + 1;
    return {content + 2 * padding, rows * wide.rowHeight + titleGap + separator + 2 * padding};
}

void StatisticsOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(edgeColor);
    painter.setBrush(panelColor);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);

    const Columns wide = columns();
    const int right = width() - padding;
    int top = padding;
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(valueColor);
    painter.drawText(QRect(padding, top, right - padding, wide.rowHeight), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(title_, Qt::ElideRight, right - padding));
    top += wide.rowHeight + titleGap;

    const QFont figures = figureFont();
    const auto paintRow = [&](const Row& row) {
        const QRect line(padding, top, right - padding, wide.rowHeight);
        painter.setFont(font());
        painter.setPen(labelColor);
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, row.label);
        painter.setPen(noteColor);
        const QString note = painter.fontMetrics().elidedText(row.note, Qt::ElideRight, wide.note);
        painter.drawText(line.adjusted(wide.label + columnGap, 0, 0, 0), Qt::AlignVCenter, note);
        painter.setFont(figures);
        painter.setPen(valueColor);
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, row.value);
        top += wide.rowHeight;
    };
    std::for_each(summary_.begin(), summary_.end(), paintRow);
    if (stages_.empty())
        return;
    top += blockGap;
    painter.fillRect(padding, top, right - padding, 1, edgeColor);
    top += 1 + blockGap;
    std::for_each(stages_.begin(), stages_.end(), paintRow);
}

void StatisticsOverlay::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        resize(sizeHint());
    QWidget::changeEvent(event);
}

} // namespace prizma
