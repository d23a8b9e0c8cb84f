#include "ui/viewport/viewport_notice.h"

#include <QFont>
#include <QPainter>
#include <QRect>

namespace prizma {
namespace {

constexpr QColor titleColor{225, 228, 234};
constexpr QColor detailsColor{160, 166, 178};
constexpr int textWidth = 560;
constexpr int gap = 10;

} // namespace

QString deviceInstallHint() {
    return QCoreApplication::translate("ViewportNotice",
                                       "Prizma draws with OpenCL. To let it use this computer's processor:\n"
                                       "sudo apt install pocl-opencl-icd");
}

void ViewportNotice::setDevice(const DeviceInfo& device) {
    hasDevice_ = !device.id.empty();
    fault_.clear();
}

void ViewportNotice::setActivity(const QString& what, bool running) {
    if (running)
        activity_ = what;
    else if (activity_ == what)
        activity_.clear();
}

void ViewportNotice::setMessage(const Diagnostic& diagnostic) {
    if (diagnostic.severity == Severity::Error)
        fault_ = QString::fromStdString(describe(diagnostic));
}

QString ViewportNotice::title() const {
    if (!activity_.isEmpty())
        return tr("%1…").arg(activity_);
    if (!fault_.isEmpty())
        return hasDevice_ ? tr("The picture could not be drawn") : tr("No OpenCL device to draw with");
    return hasDevice_ ? tr("Drawing the first picture…") : tr("Looking for an OpenCL device…");
}

QString ViewportNotice::details() const {
    if (fault_.isEmpty() || !activity_.isEmpty())
        return {};
    return hasDevice_ ? fault_ : QStringLiteral("%1\n\n%2").arg(fault_, deviceInstallHint());
}

void ViewportNotice::paint(QPainter& painter, const QRect& area) const {
    const QFont base = painter.font();
    QFont large = base;
    large.setPointSizeF(base.pointSizeF() * 1.5);

    QRect column(0, 0, qMin(textWidth, area.width() - 2 * gap), area.height());
    column.moveCenter(area.center());
    constexpr int flags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    const QString below = details();
    const int titleHeight = QFontMetrics(large).boundingRect(column, flags, title()).height();
    const int belowHeight =
        below.isEmpty() ? 0 : gap + QFontMetrics(base).boundingRect(column, flags, below).height();
    column.setTop(area.center().y() - (titleHeight + belowHeight) / 2);

    painter.setFont(large);
    painter.setPen(titleColor);
    painter.drawText(column, flags, title());
    painter.setFont(base);
    painter.setPen(detailsColor);
    painter.drawText(column.adjusted(0, titleHeight + gap, 0, 0), flags, below);
}

} // namespace prizma
