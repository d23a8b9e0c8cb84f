#include "ui/main_window/main_window.h"

#include "core/animation/posed_bounds.h"
#include "core/scene/edits.h"
#include "core/scene/starter_scene.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/export/export_actions.h"
#include "ui/import/import_controller.h"
#include "ui/import/import_settings.h"
#include "ui/log/log_panel.h"
#include "ui/main_window/edit_actions.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/help_actions.h"
#include "ui/main_window/status_bar.h"
#include "ui/main_window/theme.h"
#include "ui/main_window/view_actions.h"
#include "ui/main_window/viewport_menu.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/properties/property_editor.h"
#include "ui/scene_tree/scene_tree.h"
#include "ui/timeline/playback_actions.h"
#include "ui/timeline/timeline_controller.h"
#include "ui/timeline/timeline_panel.h"
#include "ui/viewport/render_session.h"
#include "ui/viewport/viewport.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>

#include <cmath>

namespace prizma {
namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

/// Grows when the panels change so much that a remembered layout makes no sense any more.
constexpr int layoutVersion = 2;

QStringList localFiles(const QMimeData* data) {
    QStringList files;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            files += url.toLocalFile();
    return files;
}

bool comesFrom(const Material& material, const std::string& file) {
    return material.baseColorTexture.file == file || material.normalTexture.file == file;
}

} // namespace

MainWindow::MainWindow(const QString& deviceId, QWidget* parent)
    : QMainWindow(parent),
      document_(new Document(this)),
      session_(new RenderSession(deviceId, this)),
      viewport_(new Viewport(*document_, *session_)),
      importer_(new ImportController(*document_, this)),
      sceneTree_(new SceneTree(*document_)),
      propertyEditor_(new PropertyEditor(*document_)),
      log_(new LogPanel),
      timeline_(new TimelineController(*document_, this)),
      playbackActions_(new PlaybackActions(*timeline_, this)),
      timelinePanel_(new TimelinePanel(*document_, *timeline_, *playbackActions_)),
      statusBar_(new StatusBar),
      fileActions_(new FileActions(*document_, *importer_, *this)),
      editActions_(new EditActions(*document_, *this)),
      exportActions_(new ExportActions(*document_, *session_, *this)),
      viewActions_(new ViewActions(*document_, *session_, *viewport_, *this)),
      helpActions_(new HelpActions(*this)),
      viewportMenu_(new ViewportMenu(*session_, *viewActions_, editActions_->selectionActions(), *this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCentralWidget(viewport_);
    setStatusBar(statusBar_);
    makePanels();
    makeMenus();
    connectSession();
    connectImports();
    connect(document_, &Document::fileChanged, this, &MainWindow::updateTitle);
    connect(viewport_, &Viewport::framesPerSecondChanged, this, &MainWindow::updateTitle);
    connect(viewport_, &Viewport::contextMenuRequested, viewportMenu_, &ViewportMenu::show);
    document_->reset(makeStarterScene(), {});
    restoreLayout();
    updateTitle();
    viewport_->setFocus();
}

MainWindow::~MainWindow() {
    // The view goes before what it shows and before what renders for it.
    delete takeCentralWidget();
    delete importer_;
    delete session_;
}

void MainWindow::openFile(const QString& file) {
    fileActions_->openFile(file);
}

void MainWindow::openSample(const QString& file) {
    fileActions_->openSample(file);
}

void MainWindow::importFile(const QString& file) {
    fileActions_->importFiles({file}, importOptionsFor(file));
}

void MainWindow::takeFiles(const QStringList& files) {
    fileActions_->takeFiles(files);
}

QDockWidget* MainWindow::addPanel(QWidget& content, const QString& title, const QString& name,
                                  Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(&content);
    addDockWidget(area, dock);
    panels_.push_back(dock);
    return dock;
}

void MainWindow::makePanels() {
    addPanel(*sceneTree_, tr("Scene"), QStringLiteral("scenePanel"), Qt::LeftDockWidgetArea);
    addPanel(*propertyEditor_, tr("Properties"), QStringLiteral("propertyPanel"), Qt::RightDockWidgetArea);
    timelineDock_ =
        addPanel(*timelinePanel_, tr("Timeline"), QStringLiteral("timelinePanel"), Qt::BottomDockWidgetArea);
    logDock_ = addPanel(*log_, tr("Log"), QStringLiteral("logPanel"), Qt::BottomDockWidgetArea);
    sceneTree_->setMinimumWidth(180);
    propertyEditor_->setMinimumWidth(280);
    // The side panels keep the window's full height; timeline and log lie under the view.
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);

    for (QWidget* widget : std::initializer_list<QWidget*>{viewport_, timelinePanel_})
        playbackActions_->addKeysTo(*widget);
    playbackActions_->addPlayKeysTo(*sceneTree_);

    std::vector<QAction*> treeActions = editActions_->selectionActions();
    treeActions.push_back(viewActions_->frameSelected());
    sceneTree_->setMenuActions(treeActions);
    const auto warn = [this](const QString& reason) {
        report({Severity::Warning, toStdString(reason), {}, 0});
    };
    connect(sceneTree_, &SceneTree::refused, this, warn);
    connect(propertyEditor_, &PropertyEditor::message, this, &MainWindow::report);
    connect(fileActions_, &FileActions::message, this, &MainWindow::report);
    connect(exportActions_, &ExportActions::message, this, &MainWindow::report);
    connect(log_, &LogPanel::jumpRequested, this, &MainWindow::jumpTo);
    connect(log_, &LogPanel::errorAdded, this, [this] {
        if (!preferences::opensLogOnError())
            return;
        logDock_->show();
        logDock_->raise();
    });
}

void MainWindow::makeMenus() {
    fileActions_->fillMenu(*menuBar()->addMenu(tr("&File")), exportActions_->actions());
    editActions_->fillEditMenu(*menuBar()->addMenu(tr("&Edit")));
    editActions_->fillAddMenu(*menuBar()->addMenu(tr("&Add")));
    QList<QAction*> toggles;
    for (QDockWidget* panel : panels_)
        toggles += panel->toggleViewAction();
    auto* reset = new QAction(icon(QStringLiteral("reset")), tr("Reset &Layout"), this);
    reset->setStatusTip(tr("Put the panels where they were at first"));
    connect(reset, &QAction::triggered, this, &MainWindow::resetLayout);
    viewActions_->fillViewMenu(*menuBar()->addMenu(tr("&View")), toggles, reset);
    playbackActions_->fillMenu(*menuBar()->addMenu(tr("&Playback")));
    viewActions_->fillRenderMenu(*menuBar()->addMenu(tr("&Render")));
    helpActions_->fillMenu(*menuBar()->addMenu(tr("&Help")));
}

void MainWindow::connectSession() {
    connect(session_, &RenderSession::frameReady, statusBar_, &StatusBar::setFrame);
    connect(session_, &RenderSession::message, this, &MainWindow::report);
    connect(session_, &RenderSession::deviceChanged, statusBar_, &StatusBar::setDevice);
    connect(session_, &RenderSession::activityChanged, statusBar_, &StatusBar::setActivity);
    connect(statusBar_, &StatusBar::deviceClicked, viewActions_, &ViewActions::showDevices);
}

void MainWindow::connectImports() {
    connect(importer_, &ImportController::started, statusBar_, &StatusBar::startProgress);
    connect(importer_, &ImportController::progressed, statusBar_, &StatusBar::setProgress);
    connect(importer_, &ImportController::finished, statusBar_, &StatusBar::endProgress);
    connect(statusBar_, &StatusBar::cancelRequested, importer_, &ImportController::cancel);
    connect(importer_, &ImportController::message, this, &MainWindow::report);
    connect(importer_, &ImportController::modelImported, this, &MainWindow::showImported);
    connect(importer_, &ImportController::animationsImported, this, [this](Id object, int clips) {
        const Object* animated = document_->scene().findObject(object);
        const QString name = animated ? toQString(animated->name) : QString();
        statusBar_->showMessage(clips == 1 ? tr("%1 has a new clip").arg(name)
                                           : tr("%1 has %2 new clips").arg(name).arg(clips),
                                5000);
    });
    connect(fileActions_, &FileActions::saved, this, [this](const QString& file) {
        statusBar_->showMessage(tr("Saved %1").arg(QFileInfo(file).fileName()), 5000);
    });
}

void MainWindow::showImported(Id object, const QString& file) {
    statusBar_->showMessage(tr("Imported %1").arg(QFileInfo(file).fileName()), 5000);
    const Scene& scene = document_->scene();
    const Object* imported = scene.findObject(object);
    if (!imported)
        return;
    const double aspect = static_cast<double>(viewport_->width()) / std::max(1, viewport_->height());
    const bool isOnly = scene.objects.size() == 1;
    if (isOnly || !isWellInView(scene.camera, worldBounds(scene, *imported), aspect))
        viewport_->frameSelected();
}

void MainWindow::report(const Diagnostic& diagnostic) {
    log_->add(diagnostic);
    const QString name = QFileInfo(toQString(diagnostic.file)).fileName();
    const QString text = toQString(diagnostic.message);
    const int milliseconds = diagnostic.severity == Severity::Error ? 15000 : 6000;
    statusBar_->showMessage(name.isEmpty() ? text : QStringLiteral("%1: %2").arg(name, text), milliseconds);
}

void MainWindow::jumpTo(const Diagnostic& diagnostic) {
    if (diagnostic.file.empty())
        return;
    std::vector<EntityRef> causes;
    for (const Material& material : document_->scene().materials)
        if (comesFrom(material, diagnostic.file))
            causes.push_back({EntityKind::Material, material.id});
    for (const Object& object : document_->scene().objects)
        if (object.source.file == diagnostic.file ||
            std::ranges::find(object.clipFiles, diagnostic.file) != object.clipFiles.end())
            causes.push_back({EntityKind::Object, object.id});
    if (document_->scene().background.image.file == diagnostic.file)
        causes.push_back({EntityKind::Background});
    if (causes.empty())
        statusBar_->showMessage(tr("Nothing in the scene comes from %1.").arg(toQString(diagnostic.file)),
                                6000);
    else
        document_->setSelection(causes);
}

void MainWindow::updateTitle() {
    QString title = QStringLiteral("%1[*] – Prizma").arg(document_->title());
    if (const long fps = std::lround(viewport_->framesPerSecond()); fps > 0)
        title += tr(" – %1 FPS").arg(fps);
    setWindowTitle(title);
    setWindowFilePath(document_->file());
    setWindowModified(document_->isModified());
}

void MainWindow::resetLayout() {
    const Qt::DockWidgetArea areas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                        Qt::BottomDockWidgetArea};
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        panels_[i]->setFloating(false);
        addDockWidget(areas[std::min<std::size_t>(i, 2)], panels_[i]);
        panels_[i]->setVisible(panels_[i] != logDock_);
    }
    resizeDocks({panels_[0], panels_[1]}, {230, 330}, Qt::Horizontal);
    tabifyDockWidget(timelineDock_, logDock_);
    resizeDocks({timelineDock_}, {180}, Qt::Vertical);
}

void MainWindow::restoreLayout() {
    resize(1280, 800);
    resetLayout();
    const QSettings settings;
    restoreGeometry(settings.value(geometryKey).toByteArray());
    restoreState(settings.value(stateKey).toByteArray(), layoutVersion);
}

void MainWindow::saveLayout() const {
    QSettings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(stateKey, saveState(layoutVersion));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose_ && document_->isModified()) {
        event->ignore();
        fileActions_->unsavedChanges().guard([this] {
            mayClose_ = true;
            close();
        });
        return;
    }
    saveLayout();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    takeFiles(localFiles(event->mimeData()));
}

} // namespace prizma
