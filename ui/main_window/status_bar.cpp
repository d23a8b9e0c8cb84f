#include "ui/main_window/status_bar.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <cmath>

namespace prizma {

StatusBar::StatusBar(QWidget* parent)
    : QStatusBar(parent),
      activity_(new QLabel),
      task_(new QLabel),
      progress_(new QProgressBar),
      cancel_(new QToolButton),
      denoised_(new QLabel(tr("Denoised preview"))),
      samples_(new QLabel),
      device_(new QToolButton) {
    activity_->setObjectName(QStringLiteral("activity"));
    task_->setObjectName(QStringLiteral("task"));
    progress_->setFixedWidth(140);
    progress_->setMaximumHeight(14);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    cancel_->setObjectName(QStringLiteral("cancelImport"));
    cancel_->setIcon(icon(QStringLiteral("process-stop")));
    cancel_->setToolTip(tr("Cancel"));
    cancel_->setAutoRaise(true);
    denoised_->setObjectName(QStringLiteral("denoisedMark"));
    denoised_->setToolTip(tr("The picture in the view is smoothed; files are written as it is"));
    QPalette marked = denoised_->palette();
    marked.setColor(QPalette::WindowText, theme::accent());
    denoised_->setPalette(marked);
    samples_->setObjectName(QStringLiteral("samples"));
    samples_->setToolTip(tr("Samples in each pixel so far, and how many there will be"));
    device_->setObjectName(QStringLiteral("device"));
    device_->setIcon(icon(QStringLiteral("computer")));
    device_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    device_->setToolTip(tr("The device that renders; click to choose another one"));
    device_->setAutoRaise(true);
    device_->setText(tr("No device"));
    connect(cancel_, &QToolButton::clicked, this, &StatusBar::cancelRequested);
    connect(device_, &QToolButton::clicked, this, &StatusBar::deviceClicked);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{activity_, task_, progress_, cancel_, denoised_, samples_, device_})
        addPermanentWidget(widget);
    activity_->hide();
    denoised_->hide();
    endProgress();
    setSizeGripEnabled(false);
}

void StatusBar::setActivity(const QString& what, bool running) {
    activity_->setText(tr("%1…").arg(what));
    activity_->setVisible(running);
}

void StatusBar::setFrame(const FramePtr& frame) {
    samples_->setText(tr("%1 of %2 samples").arg(frame->samples).arg(frame->sampleLimit));
    denoised_->setVisible(frame->isDenoised);
}

void StatusBar::setDevice(const DeviceInfo& device) {
    const QString name = toQString(device.name);
    device_->setText(name.isEmpty() ? tr("No device") : fontMetrics().elidedText(name, Qt::ElideMiddle, 260));
    device_->setStatusTip(toQString(device.platform));
}

void StatusBar::startProgress(const QString& label) {
    task_->setText(label);
    progress_->setValue(0);
    for (QWidget* widget : std::initializer_list<QWidget*>{task_, progress_, cancel_})
        widget->show();
}

void StatusBar::setProgress(double fraction) {
    // Work that has not yet said how far it is shows that it is alive.
    progress_->setMaximum(fraction > 0.0 ? 1000 : 0);
    progress_->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
}

void StatusBar::endProgress() {
    for (QWidget* widget : std::initializer_list<QWidget*>{task_, progress_, cancel_})
        widget->hide();
}

} // namespace prizma
