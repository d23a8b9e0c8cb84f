#pragma once

#include "core/compute/device.h"
#include "core/diagnostic.h"

#include <QDialog>

#include <thread>
#include <vector>

class QFormLayout;
class QLabel;
class QPushButton;

namespace prizma {

class DeviceTable;
class RenderSession;

/// Shows every OpenCL device with what it can do, and lets people change to another one while the scene
/// stays. The choice is remembered (setting "device") once the device renders.
class DeviceDialog : public QDialog {
    Q_OBJECT

  public:
    /// Keeps a reference to `session`.
    DeviceDialog(RenderSession& session, QWidget* parent = nullptr);

    /// Waits for the drivers if they are still being asked.
    ~DeviceDialog() override;

  private:
    void buildLayout();
    void connectSession();
    void refresh();
    void showDevices(const std::vector<DeviceInfo>& devices);
    void showDetails();
    void updateButton();
    void useSelected();
    void confirm(const DeviceInfo& device);
    void refuse(const Diagnostic& diagnostic);
    void setStatus(const QString& text, bool isFault);

    RenderSession& session_;
    DeviceTable* table_;
    QFormLayout* details_;
    QLabel* status_;
    QPushButton* useButton_;
    QPushButton* refreshButton_;
    QString wantedId_; ///< That the session was asked for and has not confirmed; empty if none.
    std::jthread listing_;
};

} // namespace prizma
