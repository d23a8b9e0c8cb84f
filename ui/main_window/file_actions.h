#pragma once

#include "core/diagnostic.h"
#include "core/import/model_importer.h"
#include "core/project/project_file.h"
#include "ui/main_window/recent_files.h"
#include "ui/main_window/unsaved_changes.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <optional>

class QAction;
class QMainWindow;
class QMenu;

namespace prizma {

class Document;
class ImportController;
class Viewport;

/// The File menu and what stands behind it.
class FileActions : public QObject {
    Q_OBJECT

  public:
    FileActions(Document& document, ImportController& importer, Viewport& viewport, QMainWindow& window);

    /// `exportAnimation` stands beside the export of a picture.
    void fillMenu(QMenu& menu, QAction* exportAnimation);

    void openFile(const QString& file); ///< Asks before unsaved work is lost.
    void
    openSample(const QString& file); ///< As a scene without a name, so that the file cannot be overwritten.
    void importFiles(const QStringList& files, const ImportOptions& options);
    void saveFile(const QString& file, const std::function<void()>& whenSaved = {});
    void exportImageTo(const QString& file);

    /// Files from the command line or dropped on the window: projects are opened, anything else is imported.
    void takeFiles(const QStringList& files);

    UnsavedChanges& unsavedChanges() { return unsavedChanges_; }

  Q_SIGNALS:
    void message(const prizma::Diagnostic& diagnostic);
    void saved(const QString& file);

  private:
    void newScene();
    void open();
    void save(const std::function<void()>& whenSaved);
    void saveAs(const std::function<void()>& whenSaved);
    void import();
    void askAndImport(const QStringList& files);
    void exportImage();
    void load(const QString& file, bool asSample);
    void takeProject(const QString& file, const std::shared_ptr<Project>& project);
    void report(const QString& title, const QString& text);

    Document& document_;
    ImportController& importer_;
    Viewport& viewport_;
    QMainWindow& window_;
    RecentFiles recentFiles_;
    UnsavedChanges unsavedChanges_;
    QString sample_;        ///< Being loaded as one.
    int loadRevision_ = -1; ///< The document's when it was agreed that it may be replaced.
};

} // namespace prizma
