#include "ui/devices/device_dialog.h"

#include "ui/devices/device_table.h"
#include "ui/viewport/render_session.h"
#include "ui/viewport/viewport_notice.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QVBoxLayout>

namespace prizma {
namespace {

// At first; people may drag.
constexpr int dialogWidth = 980;
constexpr int tableHeight = 220;
constexpr int factsHeight = 340;
constexpr int buttonsHeight = 100;

} // namespace

DeviceDialog::DeviceDialog(RenderSession& session, QWidget* parent)
    : QDialog(parent),
      session_(session),
      table_(new DeviceTable(this)),
      details_(nullptr),
      status_(new QLabel(this)),
      useButton_(new QPushButton(tr("&Use This Device"), this)),
      refreshButton_(new QPushButton(tr("&Refresh"), this)) {
    setWindowTitle(tr("OpenCL Devices"));
    buildLayout();
    table_->setCurrentDevice(QString::fromStdString(session.device().id));
    connect(table_, &DeviceTable::deviceSelected, this, [this] {
        showDetails();
        updateButton();
    });
    connect(table_, &DeviceTable::deviceActivated, this, &DeviceDialog::useSelected);
    connect(useButton_, &QPushButton::clicked, this, &DeviceDialog::useSelected);
    connect(refreshButton_, &QPushButton::clicked, this, &DeviceDialog::refresh);
    connectSession();
    refresh();
}

DeviceDialog::~DeviceDialog() = default;

void DeviceDialog::buildLayout() {
    auto* facts = new QWidget;
    details_ = new QFormLayout(facts);
    details_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    auto* scroll = new QScrollArea;
    scroll->setWidget(facts);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);

    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(table_);
    splitter->addWidget(scroll);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 0);
    splitter->setSizes({tableHeight, factsHeight});
    splitter->setChildrenCollapsible(false);

    status_->setWordWrap(true);
    status_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    status_->setObjectName(QStringLiteral("status"));
    useButton_->setObjectName(QStringLiteral("use"));
    refreshButton_->setObjectName(QStringLiteral("refresh"));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(useButton_, QDialogButtonBox::ActionRole);
    buttons->addButton(refreshButton_, QDialogButtonBox::ActionRole);
    // Enter uses the selected device and must not close the dialog too.
    for (QAbstractButton* button : buttons->buttons())
        if (auto* push = qobject_cast<QPushButton*>(button))
            push->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(splitter, 1);
    layout->addWidget(status_);
    layout->addWidget(buttons);
    resize(dialogWidth, tableHeight + factsHeight + buttonsHeight);
}

void DeviceDialog::connectSession() {
    connect(&session_, &RenderSession::deviceChanged, this, &DeviceDialog::confirm);
    connect(&session_, &RenderSession::message, this, [this](const Diagnostic& diagnostic) {
        if (!wantedId_.isEmpty() && diagnostic.severity == Severity::Error)
            refuse(diagnostic);
    });
}

/// Drivers may take a second to answer, so they are asked in a thread of their own.
void DeviceDialog::refresh() {
    refreshButton_->setEnabled(false);
    setStatus(tr("Looking for devices…"), false);
    listing_ = std::jthread([this] {
        const auto show = [this, devices = listDevices()] { showDevices(devices); };
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
    });
}

void DeviceDialog::showDevices(const std::vector<DeviceInfo>& devices) {
    refreshButton_->setEnabled(true);
    table_->setDevices(devices);
    if (devices.empty())
        setStatus(tr("There is no OpenCL device.") + u' ' + deviceInstallHint(), true);
    else
        setStatus(devices.size() == 1 ? tr("One device found.")
                                      : tr("%n devices found.", nullptr, static_cast<int>(devices.size())),
                  false);
    showDetails();
    updateButton();
}

void DeviceDialog::showDetails() {
    while (details_->rowCount() > 0)
        details_->removeRow(0);
    const DeviceInfo* device = table_->selectedDevice();
    if (!device)
        return;
    for (const DeviceFact& fact : factsOf(*device)) {
        auto* value = new QLabel(fact.value);
        value->setTextFormat(Qt::PlainText);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        details_->addRow(fact.label + u':', value);
    }
}

void DeviceDialog::updateButton() {
    const DeviceInfo* device = table_->selectedDevice();
    const bool isCurrent = device && device->id == session_.device().id;
    useButton_->setEnabled(device && device->usable && !isCurrent && wantedId_.isEmpty());
    if (device && !device->usable)
        useButton_->setToolTip(tr("This device is not available, or has no compiler."));
    else
        useButton_->setToolTip(isCurrent ? tr("This device is in use.") : QString());
}

void DeviceDialog::useSelected() {
    updateButton();
    if (!useButton_->isEnabled())
        return;
    const DeviceInfo& device = *table_->selectedDevice();
    wantedId_ = QString::fromStdString(device.id);
    setStatus(tr("Changing to %1…").arg(QString::fromStdString(device.name)), false);
    updateButton();
    session_.selectDevice(wantedId_);
}

void DeviceDialog::confirm(const DeviceInfo& device) {
    const QString id = QString::fromStdString(device.id);
    table_->setCurrentDevice(id);
    if (id == wantedId_) {
        // Only a choice that works is worth remembering.
        QSettings().setValue(QStringLiteral("device"), id);
        wantedId_.clear();
        setStatus(tr("%1 draws the picture now.").arg(QString::fromStdString(device.name)), false);
    }
    updateButton();
}

void DeviceDialog::refuse(const Diagnostic& diagnostic) {
    wantedId_.clear();
    setStatus(QString::fromStdString(describe(diagnostic)), true);
    updateButton();
}

void DeviceDialog::setStatus(const QString& text, bool isFault) {
    QPalette colors = palette();
    if (isFault)
        colors.setColor(QPalette::WindowText, QColor(0xd9, 0x53, 0x4f));
    status_->setPalette(colors);
    status_->setText(text);
}

} // namespace prizma
