#include "ui/main_window/view_actions.h"

#include "core/scene/property_tables.h"
#include "ui/devices/device_dialog.h"
#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/viewport/render_session.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

namespace prizma {
namespace {

const QString statisticsKey = QStringLiteral("view/statistics");
const QString skeletonsKey = QStringLiteral("view/skeletons");

} // namespace

ViewActions::ViewActions(Document& document, RenderSession& session, Viewport& viewport, QMainWindow& window)
    : QObject(&window),
      document_(document),
      session_(session),
      viewport_(viewport),
      window_(window),
      frameSelected_(makeAction("zoom-fit-selection", tr("&Frame Selected"), {Qt::Key_F})),
      frameAll_(makeAction("zoom-fit-best", tr("Frame &All"), {Qt::SHIFT | Qt::Key_F})),
      pause_(makeAction("media-playback-pause", tr("&Pause Rendering"), {Qt::Key_P})),
      statistics_(makeAction("view-statistics", tr("&Statistics"), {Qt::Key_F3})),
      skeletons_(makeAction("skeleton", tr("S&keletons"), {Qt::Key_B})),
      shaders_(new QActionGroup(this)),
      transforms_(new QActionGroup(this)),
      denoise_(makeAction("denoise", tr("&Denoise Preview"), {Qt::CTRL | Qt::SHIFT | Qt::Key_D})) {
    frameSelected_->setStatusTip(tr("Move the camera so that what is selected fills the view"));
    frameAll_->setStatusTip(tr("Move the camera so that the whole scene is in the view"));
    pause_->setCheckable(true);
    pause_->setStatusTip(tr("Keep the picture as it is and leave the device alone"));
    statistics_->setCheckable(true);
    statistics_->setStatusTip(tr("Show what the picture cost, over the view"));
    connect(frameSelected_, &QAction::triggered, &viewport_, &Viewport::frameSelected);
    connect(frameAll_, &QAction::triggered, &viewport_, &Viewport::frameAll);
    connect(pause_, &QAction::toggled, &viewport_, &Viewport::setPaused);
    connect(statistics_, &QAction::toggled, this, [this](bool shown) {
        viewport_.setStatisticsVisible(shown);
        QSettings().setValue(statisticsKey, shown);
    });
    statistics_->setChecked(QSettings().value(statisticsKey, false).toBool());
    skeletons_->setCheckable(true);
    skeletons_->setStatusTip(tr("Show the bones of what is selected, or of everything, over the view"));
    connect(skeletons_, &QAction::toggled, this, [this](bool shown) {
        viewport_.setSkeletonsVisible(shown);
        QSettings().setValue(skeletonsKey, shown);
    });
    skeletons_->setChecked(QSettings().value(skeletonsKey, false).toBool());
    makePresets();
    makeShaders();
    makeDisplays();
    connect(&document_, &Document::sceneChanged, this, &ViewActions::showSettings);
    showSettings();
}

QAction* ViewActions::makeAction(const char* iconName, const QString& text, const QList<QKeySequence>& keys) {
    auto* action = new QAction(icon(QString::fromLatin1(iconName)), text, this);
    action->setShortcuts(keys);
    return action;
}

void ViewActions::makePresets() {
    const auto add = [this](const QString& text, Qt::Key key, ViewDirection direction) {
        auto* action = makeAction("camera", text, {key});
        connect(action, &QAction::triggered, &viewport_,
                [this, direction] { viewport_.viewFrom(direction); });
        presets_ += action;
    };
    add(tr("View from the F&ront"), Qt::Key_1, ViewDirection::Front);
    add(tr("View from the S&ide"), Qt::Key_3, ViewDirection::Right);
    add(tr("View from the &Top"), Qt::Key_7, ViewDirection::Top);
}

void ViewActions::makeShaders() {
    for (std::size_t i = 0; i < choicesOf<ShaderType>().size(); ++i) {
        auto* action = new QAction(labelOf(static_cast<ShaderType>(i)), shaders_);
        action->setCheckable(true);
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i))));
        const std::string key(choicesOf<ShaderType>()[i].key);
        connect(action, &QAction::triggered, this,
                [this, key] { document_.setProperty({{EntityKind::Render}}, "shader", key); });
    }
}

void ViewActions::makeDisplays() {
    for (const Choice& choice : choicesOf<ViewTransform>()) {
        auto* action = new QAction(translated(choice.label), transforms_);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, key = std::string(choice.key)] {
            document_.setProperty({{EntityKind::Render}}, "viewTransform", key);
        });
    }
    denoise_->setCheckable(true);
    denoise_->setStatusTip(tr("Smooth the picture in the view along surfaces; files stay as they are"));
    connect(denoise_, &QAction::triggered, this,
            [this](bool wanted) { document_.setProperty({{EntityKind::Render}}, "denoise", wanted); });
}

void ViewActions::showSettings() {
    const RenderSettings& settings = document_.scene().render;
    shaders_->actions().at(static_cast<int>(settings.shader))->setChecked(true);
    transforms_->actions().at(static_cast<int>(settings.viewTransform))->setChecked(true);
    denoise_->setChecked(settings.denoise);
}

void ViewActions::fillViewMenu(QMenu& menu, const QList<QAction*>& panelActions, QAction* resetLayout) {
    menu.addActions({frameSelected_, frameAll_});
    menu.addSeparator();
    menu.addActions(presets_);
    menu.addSeparator();
    QMenu* display = menu.addMenu(tr("&Colours"));
    display->addActions(transforms_->actions());
    menu.addAction(denoise_);
    menu.addSeparator();
    menu.addActions({pause_, statistics_, skeletons_});
    menu.addSeparator();
    QMenu* panels = menu.addMenu(tr("Pa&nels"));
    panels->addActions(panelActions);
    menu.addAction(resetLayout);
    auto* fullScreen = makeAction("view-fullscreen", tr("F&ull Screen"), {Qt::Key_F11});
    fullScreen->setCheckable(true);
    connect(fullScreen, &QAction::toggled, this, [this](bool full) {
        window_.setWindowState(window_.windowState().setFlag(Qt::WindowFullScreen, full));
    });
    menu.addAction(fullScreen);
}

void ViewActions::fillRenderMenu(QMenu& menu) {
    auto* devices = makeAction("computer", tr("OpenCL &Devices…"), {Qt::Key_F10});
    devices->setStatusTip(tr("Choose what renders"));
    connect(devices, &QAction::triggered, this, &ViewActions::showDevices);
    menu.addAction(devices);
    QMenu* shader = menu.addMenu(icon(QStringLiteral("render")), tr("&Shader"));
    shader->addActions(shaders_->actions());
    menu.addSeparator();
    QAction* settings = menu.addAction(icon(QStringLiteral("configure")), tr("Render S&ettings"), this,
                                       [this] { document_.setSelection({{EntityKind::Render}}); });
    settings->setStatusTip(tr("Show samples, depth and exposure in the property panel"));
}

void ViewActions::showDevices() {
    if (!devices_) {
        devices_ = new DeviceDialog(session_, &window_);
        devices_->setAttribute(Qt::WA_DeleteOnClose);
    }
    devices_->show();
    devices_->raise();
    devices_->activateWindow();
}

} // namespace prizma
