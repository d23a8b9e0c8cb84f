#pragma once

#include "core/diagnostic.h"
#include "core/import/model_importer.h"
#include "core/project/project_file.h"
#include "ui/import/background_job.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <deque>
#include <memory>

namespace prizma {

class Document;

/// Brings files into the document: reads them one after the other in the background and edits the scene only
/// when all went well.
class ImportController : public QObject {
    Q_OBJECT

  public:
    explicit ImportController(Document& document, QObject* parent = nullptr);

    void importModel(const QString& file, const ImportOptions& options);

    /// Reads a project. What becomes of it is up to who listens to `projectLoaded`.
    void loadProject(const QString& file);

    bool isBusy() const { return job_ != nullptr; }
    void cancel(); ///< Drops everything that waits, too.

  Q_SIGNALS:
    void started(const QString& label);
    void progressed(double fraction);
    void finished(); ///< Nothing more goes on.
    void message(const prizma::Diagnostic& diagnostic);
    void failed(const QString& file, const QString& reason); ///< Told by `message` as well.
    void modelImported(prizma::Id object, const QString& file);
    void projectLoaded(const QString& file, std::shared_ptr<prizma::Project> project);

  private:
    struct Task {
        QString file;
        ImportOptions options;
        bool isProject = false;
    };

    void enqueue(Task task);
    void startNext();
    void deliverModel(const Task& task, const Result<ImportedModel>& model);
    void deliverProject(const QString& file, Result<Project> project);
    void tellFailure(const QString& file, Diagnostic diagnostic);

    Document& document_;
    std::deque<Task> waiting_;
    QPointer<BackgroundJob> job_;
};

} // namespace prizma
