#include "ui/devices/device_table.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLocale>
#include <QTreeWidgetItemIterator>

namespace prizma {
namespace {

constexpr int columnGap = 8;
constexpr int indexRole = Qt::UserRole;

enum Column {
    NameColumn,
    TypeColumn,
    UnitsColumn,
    ClockColumn,
    MemoryColumn,
    DoubleColumn,
    VersionColumn,
    StateColumn
};

QString translate(const char* text) {
    return QCoreApplication::translate("DeviceTable", text);
}

QString bytes(std::uint64_t count) {
    return QLocale().formattedDataSize(static_cast<qint64>(count), 1, QLocale::DataSizeIecFormat);
}

QString yesOrNo(bool value) {
    return value ? translate("Yes") : translate("No");
}

QString clock(int megahertz) {
    return megahertz > 0
               ? QCoreApplication::translate("DeviceTable", "%1 MHz").arg(QLocale().toString(megahertz))
               : QStringLiteral("–");
}

QString typeName(const DeviceInfo& device) {
    return QString::fromStdString(describe(device.type));
}

} // namespace

std::vector<DeviceFact> factsOf(const DeviceInfo& device) {
    const QLocale locale;
    const auto text = [](const std::string& value) { return QString::fromStdString(value); };
    return {
        {translate("Name"), text(device.name)},
        {translate("Platform"), text(device.platform)},
        {translate("Vendor"), text(device.vendor)},
        {translate("Type"), typeName(device)},
        {translate("Compute units"), locale.toString(device.computeUnits)},
        {translate("Clock"), clock(device.clockMHz)},
        {translate("Memory"), bytes(device.globalMemory)},
        {translate("Largest buffer"), bytes(device.maxAllocation)},
        {translate("Local memory"), bytes(device.localMemory)},
        {translate("Largest work group"), locale.toString(static_cast<qulonglong>(device.maxWorkGroupSize))},
        {translate("Vector width (float)"), locale.toString(device.floatVectorWidth)},
        {translate("Double precision"), yesOrNo(device.doublePrecision)},
        {translate("OpenCL version"), text(device.openclVersion)},
        {translate("Driver version"), text(device.driverVersion)},
        {translate("Usable"),
         device.usable ? yesOrNo(true) : translate("No: not available, or without a compiler")},
    };
}

DeviceTable::DeviceTable(QWidget* parent) : QTreeWidget(parent) {
    setHeaderLabels({tr("Device"), tr("Type"), tr("Compute units"), tr("Clock"), tr("Memory"),
                     tr("Double precision"), tr("OpenCL"), tr("State")});
    setAccessibleName(tr("OpenCL devices"));
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setExpandsOnDoubleClick(false);
    connect(this, &QTreeWidget::currentItemChanged, this, &DeviceTable::deviceSelected);
    connect(this, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        if (deviceOf(item))
            Q_EMIT deviceActivated();
    });
}

void DeviceTable::setDevices(const std::vector<DeviceInfo>& devices) {
    const DeviceInfo* selected = selectedDevice();
    const QString wanted = selected ? QString::fromStdString(selected->id) : currentId_;
    clear();
    devices_ = devices;
    for (std::size_t index = 0; index < devices_.size(); ++index)
        addDevice(index);
    expandAll();
    markCurrent();
    select(wanted);
}

QTreeWidgetItem* DeviceTable::platformItem(const QString& platform) {
    for (int i = 0; i < topLevelItemCount(); ++i)
        if (topLevelItem(i)->text(NameColumn) == platform)
            return topLevelItem(i);
    auto* item = new QTreeWidgetItem(this, {platform});
    item->setFlags(Qt::ItemIsEnabled);
    item->setFirstColumnSpanned(true);
    return item;
}

void DeviceTable::addDevice(std::size_t index) {
    const DeviceInfo& device = devices_[index];
    auto* item = new QTreeWidgetItem(platformItem(QString::fromStdString(device.platform)));
    item->setData(NameColumn, indexRole, static_cast<qulonglong>(index));
    item->setText(NameColumn, QString::fromStdString(device.name));
    item->setText(TypeColumn, typeName(device));
    item->setText(UnitsColumn, QLocale().toString(device.computeUnits));
    item->setText(ClockColumn, clock(device.clockMHz));
    item->setText(MemoryColumn, bytes(device.globalMemory));
    item->setText(DoubleColumn, yesOrNo(device.doublePrecision));
    item->setText(VersionColumn, QString::fromStdString(device.openclVersion));
    for (const int column : {UnitsColumn, ClockColumn, MemoryColumn})
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    if (!device.usable)
        for (int column = 0; column < columnCount(); ++column)
            item->setForeground(column, palette().brush(QPalette::Disabled, QPalette::Text));
}

void DeviceTable::setCurrentDevice(const QString& deviceId) {
    currentId_ = deviceId;
    markCurrent();
    if (!selectedDevice())
        select(deviceId);
}

void DeviceTable::markCurrent() {
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        const DeviceInfo* device = deviceOf(*it);
        if (!device)
            continue;
        const bool isCurrent = !currentId_.isEmpty() && QString::fromStdString(device->id) == currentId_;
        (*it)->setText(StateColumn, isCurrent        ? tr("In use")
                                    : device->usable ? tr("Usable")
                                                     : tr("Not usable"));
        QFont font = this->font();
        font.setBold(isCurrent);
        (*it)->setFont(NameColumn, font);
        (*it)->setFont(StateColumn, font);
    }
    // Bold text is wider.
    for (int column = 0; column < columnCount(); ++column) {
        resizeColumnToContents(column);
        setColumnWidth(column, columnWidth(column) + columnGap);
    }
}

void DeviceTable::select(const QString& deviceId) {
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        const DeviceInfo* device = deviceOf(*it);
        if (device && QString::fromStdString(device->id) == deviceId)
            setCurrentItem(*it);
    }
}

const DeviceInfo* DeviceTable::selectedDevice() const {
    return deviceOf(currentItem());
}

const DeviceInfo* DeviceTable::deviceOf(const QTreeWidgetItem* item) const {
    const QVariant index = item ? item->data(NameColumn, indexRole) : QVariant();
    return index.isValid() && index.toULongLong() < devices_.size() ? &devices_[index.toULongLong()]
                                                                    : nullptr;
}

} // namespace prizma
