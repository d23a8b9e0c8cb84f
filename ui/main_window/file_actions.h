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

/// The File menu and what stands behind it.
class FileActions : public QObject {
    Q_OBJECT

  public:
    FileActions(Document& document, ImportController& importer, QMainWindow& window);

    /// `exports` stand below the imports.
    void fillMenu(QMenu& menu, const QList<QAction*>& exports);

    void openFile(const QString& file); ///< Asks before unsaved work is lost.
    void
    openSample(const QString& file); ///< As a scene without a name, so that the file cannot be overwritten.
    /// Animations come together with the models that they belong to, as one step.
    void importFiles(const QStringList& models, const ImportOptions& options,
                     const QStringList& animations = {});
    void importAnimationFiles(const QStringList& files); ///< For the selected object.
    void saveFile(const QString& file, const std::function<void()>& whenSaved = {});

    /// Files from the command line, dropped on the window or chosen for import: projects are opened, anything
    /// else is imported, animations together with the models among the files or else for the selected object.
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
    void importAnimation();
    void takeModels(const QStringList& files);
    void askAndImport(const QStringList& models, const QStringList& animations);
    void load(const QString& file, bool asSample);
    void takeProject(const QString& file, const std::shared_ptr<Project>& project);
    void report(const QString& title, const QString& text);

    Document& document_;
    ImportController& importer_;
    QMainWindow& window_;
    RecentFiles recentFiles_;
    UnsavedChanges unsavedChanges_;
    QString sample_;        ///< Being loaded as one.
    int loadRevision_ = -1; ///< The document's when it was agreed that it may be replaced.
};

} // namespace prizma
