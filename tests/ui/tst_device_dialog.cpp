#include "core/compute/device.h"
#include "ui/devices/device_dialog.h"
#include "ui/devices/device_table.h"
#include "ui/viewport/render_session.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidgetItemIterator>

#include <algorithm>

using namespace prizma;

namespace {

constexpr int startTimeout = 120000; // The first start on a device compiles its kernels.

QString idOf(const DeviceInfo& device) {
    return QString::fromStdString(device.id);
}

/// The rows of devices, without those of platforms.
std::vector<QTreeWidgetItem*> deviceRows(DeviceTable& table) {
    std::vector<QTreeWidgetItem*> rows;
    for (QTreeWidgetItemIterator it(&table); *it; ++it)
        if ((*it)->parent())
            rows.push_back(*it);
    return rows;
}

} // namespace

class TestDeviceDialog : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void init() { QSettings().clear(); }
    void factsNameEverything();
    void listsAllDevices();
    void marksTheCurrentDevice();
    void detailsFollowTheSelection();
    void anUnusableDeviceCannotBeChosen();
    void anUnknownDeviceLeavesTheOldOne();
    void switchingIsRemembered();
    void closingWhileListingIsSafe();

  private:
    QTemporaryDir settings_;
    std::vector<DeviceInfo> devices_;
    std::unique_ptr<RenderSession> session_;
};

void TestDeviceDialog::initTestCase() {
    QCoreApplication::setOrganizationName(QStringLiteral("Prizma"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_device_dialog"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings_.path());
    devices_ = listDevices();
    if (std::none_of(devices_.begin(), devices_.end(), [](const DeviceInfo& d) { return d.usable; }))
        QSKIP("There is no usable OpenCL device here.");
    session_ = std::make_unique<RenderSession>(QString());
    QTRY_VERIFY_WITH_TIMEOUT(!session_->device().id.empty(), startTimeout);
}

void TestDeviceDialog::cleanupTestCase() {
    session_.reset();
}

void TestDeviceDialog::factsNameEverything() {
    DeviceInfo device;
    device.id = "p / d";
    device.platform = "Some platform";
    device.name = "Some device";
    device.vendor = "Some vendor";
    device.driverVersion = "driver 7.1";
    device.openclVersion = "OpenCL 3.0";
    device.type = DeviceType::Gpu;
    device.computeUnits = 132;
    device.clockMHz = 1980;
    device.globalMemory = std::uint64_t{139} << 30;
    device.maxAllocation = std::uint64_t{35} << 30;
    device.localMemory = 48 << 10;
    device.maxWorkGroupSize = 1024;
    device.floatVectorWidth = 8;
    device.doublePrecision = true;
    device.usable = true;
    QString all;
    for (const DeviceFact& fact : factsOf(device))
        all += fact.label + u'=' + fact.value + u'\n';
    const QLocale locale;
    for (const QString& part :
         {QStringLiteral("Some platform"), QStringLiteral("Some device"), QStringLiteral("Some vendor"),
          QStringLiteral("driver 7.1"), QStringLiteral("OpenCL 3.0"), QStringLiteral("GPU"),
          QStringLiteral("=132\n"), locale.toString(1980) + QStringLiteral(" MHz"),
          locale.toString(139.0, 'f', 1) + QStringLiteral(" GiB"),
          locale.toString(35.0, 'f', 1) + QStringLiteral(" GiB"),
          locale.toString(48.0, 'f', 1) + QStringLiteral(" KiB"), locale.toString(1024),
          QStringLiteral("=8\n")})
        QVERIFY2(all.contains(part), qPrintable(part + QStringLiteral(" is not in ") + all));
}

void TestDeviceDialog::listsAllDevices() {
    DeviceDialog dialog(*session_);
    dialog.show();
    auto* table = dialog.findChild<DeviceTable*>();
    QVERIFY(table);
    QTRY_COMPARE(table->deviceCount(), static_cast<int>(devices_.size()));
    const auto rows = deviceRows(*table);
    QCOMPARE(rows.size(), devices_.size());
    for (const DeviceInfo& device : devices_) {
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const QTreeWidgetItem* row) {
            return row->text(0) == QString::fromStdString(device.name) &&
                   row->parent()->text(0) == QString::fromStdString(device.platform) &&
                   row->text(2) == QLocale().toString(device.computeUnits);
        });
        QVERIFY2(found != rows.end(), device.id.c_str());
    }
    auto* refresh = dialog.findChild<QPushButton*>(QStringLiteral("refresh"));
    QTRY_VERIFY(refresh->isEnabled());
    QTest::mouseClick(refresh, Qt::LeftButton);
    QVERIFY(!refresh->isEnabled());
    QTRY_VERIFY(refresh->isEnabled());
    QCOMPARE(deviceRows(*table).size(), devices_.size());
}

void TestDeviceDialog::marksTheCurrentDevice() {
    DeviceDialog dialog(*session_);
    auto* table = dialog.findChild<DeviceTable*>();
    QTRY_COMPARE(table->deviceCount(), static_cast<int>(devices_.size()));
    int marked = 0;
    for (const QTreeWidgetItem* row : deviceRows(*table))
        if (row->font(0).bold()) {
            ++marked;
            QCOMPARE(row->text(0), QString::fromStdString(session_->device().name));
        }
    QCOMPARE(marked, 1);
    QVERIFY(table->selectedDevice());
    QCOMPARE(idOf(*table->selectedDevice()), idOf(session_->device()));
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("use"))->isEnabled());
}

void TestDeviceDialog::detailsFollowTheSelection() {
    DeviceDialog dialog(*session_);
    auto* table = dialog.findChild<DeviceTable*>();
    QTRY_COMPARE(table->deviceCount(), static_cast<int>(devices_.size()));
    for (QTreeWidgetItem* row : deviceRows(*table)) {
        table->setCurrentItem(row);
        QStringList texts;
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            texts << label->text();
        for (const DeviceFact& fact : factsOf(*table->selectedDevice()))
            QVERIFY2(texts.contains(fact.value), qPrintable(fact.label));
    }
}

void TestDeviceDialog::anUnusableDeviceCannotBeChosen() {
    DeviceInfo broken;
    broken.id = "p / broken";
    broken.name = "Broken";
    broken.platform = "p";
    DeviceTable table;
    table.setDevices({broken});
    table.setCurrentItem(deviceRows(table).front());
    QCOMPARE(table.selectedDevice()->usable, false);
    QCOMPARE(deviceRows(table).front()->text(7), QStringLiteral("Not usable"));

    DeviceDialog dialog(*session_);
    auto* shown = dialog.findChild<DeviceTable*>();
    QTRY_COMPARE(shown->deviceCount(), static_cast<int>(devices_.size()));
    shown->setDevices({broken});
    shown->setCurrentItem(deviceRows(*shown).front());
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("use"))->isEnabled());
}

void TestDeviceDialog::anUnknownDeviceLeavesTheOldOne() {
    const QString before = idOf(session_->device());
    DeviceDialog dialog(*session_);
    auto* table = dialog.findChild<DeviceTable*>();
    QTRY_COMPARE(table->deviceCount(), static_cast<int>(devices_.size()));

    // A device that was unplugged after it was listed.
    DeviceInfo gone = session_->device();
    gone.id = "no platform / no device";
    gone.name = "Gone";
    table->setDevices({gone});
    table->setCurrentItem(deviceRows(*table).front());
    auto* use = dialog.findChild<QPushButton*>(QStringLiteral("use"));
    QVERIFY(use->isEnabled());
    QSignalSpy messages(session_.get(), &RenderSession::message);
    QTest::mouseClick(use, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(messages.size() >= 1, startTimeout);
    QCOMPARE(idOf(session_->device()), before);
    const QString status = dialog.findChild<QLabel*>(QStringLiteral("status"))->text();
    const auto said = messages.first().first().value<Diagnostic>();
    QCOMPARE(status, QString::fromStdString(describe(said)));
    QVERIFY(!QSettings().contains(QStringLiteral("device")));
    QVERIFY(use->isEnabled());
}

void TestDeviceDialog::switchingIsRemembered() {
    const auto other = std::find_if(devices_.begin(), devices_.end(), [&](const DeviceInfo& device) {
        return device.usable && device.id != session_->device().id;
    });
    if (other == devices_.end())
        QSKIP("There is only one usable OpenCL device here.");
    DeviceDialog dialog(*session_);
    auto* table = dialog.findChild<DeviceTable*>();
    QTRY_COMPARE(table->deviceCount(), static_cast<int>(devices_.size()));
    for (QTreeWidgetItem* row : deviceRows(*table)) {
        table->setCurrentItem(row);
        if (table->selectedDevice()->id == other->id)
            break;
    }
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("use")), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(idOf(session_->device()), idOf(*other), startTimeout);
    QCOMPARE(QSettings().value(QStringLiteral("device")).toString(), idOf(*other));
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("use"))->isEnabled());
}

void TestDeviceDialog::closingWhileListingIsSafe() {
    for (int i = 0; i < 5; ++i) {
        DeviceDialog dialog(*session_);
        dialog.show();
    }
    QTest::qWait(50);
    DeviceDialog dialog(*session_);
    QTRY_COMPARE(dialog.findChild<DeviceTable*>()->deviceCount(), static_cast<int>(devices_.size()));
}

QTEST_MAIN(TestDeviceDialog)
#include "tst_device_dialog.moc"
