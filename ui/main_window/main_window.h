#pragma once

#include "core/diagnostic.h"
#include "core/render/render_thread.h"

#include <QMainWindow>

#include <vector>

class QDockWidget;

namespace prizma {

class Document;
class EditActions;
class ExportActions;
class FileActions;
class HelpActions;
class ImportController;
class LogPanel;
class PlaybackActions;
class PropertyEditor;
class RenderSession;
class SceneTree;
class StatusBar;
class TimelineController;
class TimelinePanel;
class ViewActions;
class Viewport;
class ViewportMenu;

/// The editor's window: the view in the middle, panels around it, and the commands in the menus. It owns the
/// document and everything that works on it.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// Renders on the device `deviceId` names, or on the default one. The document is a starter scene.
    explicit MainWindow(const QString& deviceId = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a project; asks first if unsaved work would be lost. Done in the background.
    void openFile(const QString& file);

    /// Opens a project as an untitled scene, so that its file cannot be overwritten.
    void openSample(const QString& file);

    /// Adds a model to the scene, read with the options that are remembered for it. Done in the background.
    void importFile(const QString& file);

    /// Projects are opened, other files imported.
    void takeFiles(const QStringList& files);

    Document& document() { return *document_; }
    Viewport& viewport() { return *viewport_; }
    SceneTree& sceneTree() { return *sceneTree_; }
    PropertyEditor& propertyEditor() { return *propertyEditor_; }
    LogPanel& log() { return *log_; }
    TimelineController& timeline() { return *timeline_; }
    TimelinePanel& timelinePanel() { return *timelinePanel_; }
    ExportActions& exportActions() { return *exportActions_; }
    FileActions& fileActions() { return *fileActions_; }

    /// Adds a panel that can be moved, closed and found in the View menu; `name` is what it is remembered by.
    QDockWidget* addPanel(QWidget& content, const QString& title, const QString& name,
                          Qt::DockWidgetArea area);

    void resetLayout();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makePanels();
    void makeMenus();
    void connectSession();
    void connectImports();
    void restoreLayout();
    void saveLayout() const;
    void updateTitle();
    void report(const Diagnostic& diagnostic);
    void jumpTo(const Diagnostic& diagnostic);
    void showImported(Id object, const QString& file);

    Document* document_;
    RenderSession* session_;
    Viewport* viewport_;
    ImportController* importer_;
    SceneTree* sceneTree_;
    PropertyEditor* propertyEditor_;
    LogPanel* log_;
    TimelineController* timeline_;
    PlaybackActions* playbackActions_;
    TimelinePanel* timelinePanel_;
    StatusBar* statusBar_;
    FileActions* fileActions_;
    EditActions* editActions_;
    ExportActions* exportActions_;
    ViewActions* viewActions_;
    HelpActions* helpActions_;
    ViewportMenu* viewportMenu_;
    std::vector<QDockWidget*> panels_;
    QDockWidget* timelineDock_ = nullptr;
    QDockWidget* logDock_ = nullptr;
    bool mayClose_ = false;
};

} // namespace prizma
