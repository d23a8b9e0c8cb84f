#include "ui/main_window/viewport_menu.h"

#include "ui/document/strings.h"
#include "ui/import/background_job.h"
#include "ui/main_window/theme.h"
#include "ui/main_window/view_actions.h"
#include "ui/viewport/render_session.h"

#include <QAction>
#include <QMenu>
#include <QSettings>

namespace prizma {

ViewportMenu::ViewportMenu(RenderSession& session, ViewActions& view, std::vector<QAction*> selectionActions,
                           QWidget& window)
    : QObject(&window),
      session_(session),
      view_(view),
      selectionActions_(std::move(selectionActions)),
      window_(window) {
    connect(&session_, &RenderSession::deviceChanged, this, &ViewportMenu::listInBackground);
}

void ViewportMenu::listInBackground() {
    new BackgroundJob(
        tr("Looking for devices…"),
        [this](Progress&) -> BackgroundJob::Delivery {
            return [this, devices = listDevices()] { devices_ = devices; };
        },
        this);
}

void ViewportMenu::show(const QPoint& globalPosition) {
    auto* menu = new QMenu(&window_);
    menu->setObjectName(QStringLiteral("viewportMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillDevices(*menu->addMenu(icon(QStringLiteral("computer")), tr("OpenCL &Device")));
    menu->addSeparator();
    menu->addActions({view_.frameSelected(), view_.frameAll()});
    menu->addSeparator();
    menu->addActions({view_.pause(), view_.statistics()});
    menu->addSeparator();
    for (QAction* action : selectionActions_)
        menu->addAction(action);
    menu->popup(globalPosition);
}

void ViewportMenu::fillDevices(QMenu& menu) {
    for (const DeviceInfo& device : devices_) {
        QAction* action = menu.addAction(
            QStringLiteral("%1 (%2)").arg(toQString(device.name), toQString(describe(device.type))), this,
            [this, device] { choose(device); });
        action->setCheckable(true);
        action->setChecked(device.id == session_.device().id);
        action->setEnabled(device.usable);
        action->setStatusTip(toQString(device.platform));
    }
    if (devices_.empty())
        menu.addAction(tr("No device found"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(tr("All About Them…"), &view_, &ViewActions::showDevices);
}

void ViewportMenu::choose(const DeviceInfo& device) {
    session_.selectDevice(toQString(device.id));
    QSettings().setValue(QStringLiteral("device"), toQString(device.id));
}

} // namespace prizma
