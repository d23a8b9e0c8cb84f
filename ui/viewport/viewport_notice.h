#pragma once

#include "core/compute/device.h"
#include "core/diagnostic.h"

#include <QCoreApplication>
#include <QString>

class QPainter;
class QRect;

namespace prizma {

/// What the viewport says while it has no picture to show: what it waits for, or what is missing.
class ViewportNotice {
    Q_DECLARE_TR_FUNCTIONS(ViewportNotice)

  public:
    void setDevice(const DeviceInfo& device);
    void setActivity(const QString& what, bool running);
    void setMessage(const Diagnostic& diagnostic);

    QString title() const;
    QString details() const; ///< May be empty.

    void paint(QPainter& painter, const QRect& area) const;

  private:
    bool hasDevice_ = false;
    QString activity_;
    QString fault_; ///< The last error; empty if there was none since the device came.
};

/// What to install to get an OpenCL device, as a sentence.
QString deviceInstallHint();

} // namespace prizma
