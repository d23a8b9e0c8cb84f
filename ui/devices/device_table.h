#pragma once

#include "core/compute/device.h"

#include <QString>
#include <QTreeWidget>

#include <vector>

namespace prizma {

/// One fact about a device, ready to be shown.
struct DeviceFact {
    QString label;
    QString value;
};

/// Everything that is known about `device`, in the order in which people look for it.
std::vector<DeviceFact> factsOf(const DeviceInfo& device);

/// All devices under their platforms, with the facts that matter most in columns.
class DeviceTable : public QTreeWidget {
    Q_OBJECT

  public:
    explicit DeviceTable(QWidget* parent = nullptr);

    /// Replaces what is shown; the selected device stays selected if it is still there, else the current one
    /// is.
    void setDevices(const std::vector<DeviceInfo>& devices);

    /// Marks the device that renders; an empty id marks none.
    void setCurrentDevice(const QString& deviceId);

    /// The selected device; null if none is.
    const DeviceInfo* selectedDevice() const;

    int deviceCount() const { return static_cast<int>(devices_.size()); }

  Q_SIGNALS:
    void deviceSelected();  ///< Another one, or none.
    void deviceActivated(); ///< Double click or Enter.

  private:
    QTreeWidgetItem* platformItem(const QString& platform);
    void addDevice(std::size_t index);
    void markCurrent();
    void select(const QString& deviceId);
    const DeviceInfo* deviceOf(const QTreeWidgetItem* item) const;

    std::vector<DeviceInfo> devices_;
    QString currentId_;
};

} // namespace prizma
