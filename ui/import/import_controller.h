#pragma once

#include "core/diagnostic.h"
#include "core/import/import_batch.h"
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

    /// Brings in models and the animations that belong to them, as one step. `options` are for all models.
    void importTogether(const BatchFiles& files, const ImportOptions& options);

    /// Gives the object, which has bones, the clips of animation files, as one step. Files that cannot be
    /// read are told of and left out.
    void importAnimations(const QStringList& files, Id object);

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
    void animationsImported(prizma::Id object, int clips);
    void projectLoaded(const QString& file, std::shared_ptr<prizma::Project> project);

  private:
    struct Task {
        QString label;
        BackgroundJob::Work work;
    };
    struct AnimationTask {
        Id object = noId;
        MeshPtr mesh; ///< The object's when it began: clips fit no other.
        MeshSource source;
        std::vector<std::string> files;
    };
    struct AnimationResult {
        std::vector<ImportedAnimation> animations;
        Diagnostics faults;
    };

    void enqueue(Task task);
    void startNext();
    static AnimationResult readAnimations(const AnimationTask& task, Progress& progress);
    void deliverBatch(const ImportBatch& batch);
    void deliverAnimations(const AnimationTask& task, const AnimationResult& result);
    void tellWarnings(const Diagnostics& warnings);
    void deliverProject(const QString& file, Result<Project> project);
    void tellFailure(const QString& file, Diagnostic diagnostic);

    Document& document_;
    std::deque<Task> waiting_;
    QPointer<BackgroundJob> job_;
};

} // namespace prizma
