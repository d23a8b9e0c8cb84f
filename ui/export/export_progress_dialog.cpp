#include "ui/export/export_progress_dialog.h"

#include "ui/document/strings.h"
#include "ui/export/animation_exporter.h"
#include "ui/main_window/theme.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace prizma {

ExportProgressDialog::ExportProgressDialog(AnimationExporter& exporter, QWidget* parent)
    : QDialog(parent), exporter_(exporter), text_(new QLabel), left_(new QLabel), bar_(new QProgressBar) {
    setObjectName(QStringLiteral("exportProgress"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Exporting %1").arg(QFileInfo(toQString(exporter.animation().output)).fileName()));
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    QPalette dimmed = left_->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    left_->setPalette(dimmed);
    auto* buttons = new QDialogButtonBox;
    QPushButton* hide = buttons->addButton(tr("&Hide"), QDialogButtonBox::AcceptRole);
    hide->setToolTip(tr("The export goes on; its menu command shows this again"));
    QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    connect(hide, &QPushButton::clicked, this, &QDialog::close);
    connect(cancel, &QPushButton::clicked, &exporter_, &AnimationExporter::cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    for (QWidget* widget : std::initializer_list<QWidget*>{text_, bar_, left_, buttons})
        layout->addWidget(widget);
    setMinimumWidth(400);
    connect(&exporter_, &AnimationExporter::progressed, this, &ExportProgressDialog::showProgress);
    connect(&exporter_, &AnimationExporter::finished, this, &QDialog::close);
    showProgress(0.0);
}

void ExportProgressDialog::showProgress(double fraction) {
    const AnimationExport& animation = exporter_.animation();
    const int count = animation.last - animation.first + 1;
    if (exporter_.isMakingVideo())
        text_->setText(tr("Making the video"));
    else
        text_->setText(tr("Frame %1 of %2")
                           .arg(std::min(static_cast<int>(std::lround(fraction * count)) + 1, count))
                           .arg(count));
    bar_->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
    left_->setText(timeLeft(fraction));
}

QString ExportProgressDialog::timeLeft(double fraction) {
    if (exporter_.isMakingVideo())
        return {};
    if (firstFraction_ < 0.0 || fraction < firstFraction_) {
        firstFraction_ = fraction;
        clock_.start();
    }
    const double done = fraction - firstFraction_;
    if (done <= 0.0)
        return tr("Starting…");
    const double seconds = static_cast<double>(clock_.elapsed()) / 1000.0 * (1.0 - fraction) / done;
    if (seconds < 1.5)
        return tr("About a second left");
    if (seconds < 100.0)
        return tr("About %n seconds left", nullptr, static_cast<int>(std::lround(seconds)));
    return tr("About %n minutes left", nullptr, static_cast<int>(std::lround(seconds / 60.0)));
}

} // namespace prizma
