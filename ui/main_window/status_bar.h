#pragma once

#include "core/compute/device.h"
#include "core/render/render_thread.h"

#include <QStatusBar>

class QLabel;
class QProgressBar;
class QToolButton;

namespace prizma {

/// What goes on: activity and progress at the left, samples and device at the right.
class StatusBar : public QStatusBar {
    Q_OBJECT

  public:
    explicit StatusBar(QWidget* parent = nullptr);

    void setActivity(const QString& what, bool running);
    void setFrame(const FramePtr& frame);
    void setDevice(const DeviceInfo& device);

    void startProgress(const QString& label);
    void setProgress(double fraction);
    void endProgress();

  Q_SIGNALS:
    void cancelRequested();
    void deviceClicked();

  private:
    QLabel* activity_;
    QLabel* task_;
    QProgressBar* progress_;
    QToolButton* cancel_;
    QLabel* denoised_;
    QLabel* samples_;
    QToolButton* device_;
};

} // namespace prizma
