#include "ui/import/import_controller.h"

#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/document/strings.h"
#include "ui/import/background_job.h"

#include <QFileInfo>

namespace prizma {

ImportController::ImportController(Document& document, QObject* parent)
    : QObject(parent), document_(document) {}

void ImportController::importModel(const QString& file, const ImportOptions& options) {
    enqueue({QFileInfo(file).absoluteFilePath(), options, false});
}

void ImportController::loadProject(const QString& file) {
    enqueue({QFileInfo(file).absoluteFilePath(), {}, true});
}

void ImportController::cancel() {
    waiting_.clear();
    if (job_)
        job_->cancel();
}

void ImportController::enqueue(Task task) {
    waiting_.push_back(std::move(task));
    if (!job_)
        startNext();
}

void ImportController::startNext() {
    if (waiting_.empty()) {
        Q_EMIT finished();
        return;
    }
    const Task task = waiting_.front();
    waiting_.pop_front();
    const std::string path = toStdString(task.file);
    BackgroundJob::Work work;
    if (task.isProject)
        work = [this, task, path](Progress& progress) -> BackgroundJob::Delivery {
            auto project = std::make_shared<Result<Project>>(prizma::loadProject(path, progress));
            return [this, task, project] { deliverProject(task.file, std::move(*project)); };
        };
    else
        work = [this, task, path](Progress& progress) -> BackgroundJob::Delivery {
            auto model =
                std::make_shared<Result<ImportedModel>>(prizma::importModel(path, task.options, progress));
            return [this, task, model] { deliverModel(task, *model); };
        };
    const QString name = QFileInfo(task.file).fileName();
    job_ =
        new BackgroundJob((task.isProject ? tr("Opening %1…") : tr("Importing %1…")).arg(name), work, this);
    connect(job_, &BackgroundJob::progressed, this, &ImportController::progressed);
    connect(job_, &BackgroundJob::finished, this, [this] {
        job_ = nullptr;
        startNext();
    });
    Q_EMIT started(job_->label());
}

void ImportController::deliverModel(const Task& task, const Result<ImportedModel>& model) {
    if (!model) {
        tellFailure(task.file, model.error());
        return;
    }
    MeshSource source;
    source.file = toStdString(task.file);
    source.upAxis = task.options.upAxis;
    source.unitScale = task.options.unitScale;
    const Id object = addImportedModel(document_, *model, source);
    for (Diagnostic warning : model->warnings) {
        if (warning.file.empty())
            warning.file = source.file;
        Q_EMIT message(warning);
    }
    Q_EMIT modelImported(object, task.file);
}

void ImportController::deliverProject(const QString& file, Result<Project> project) {
    if (!project) {
        tellFailure(file, project.error());
        return;
    }
    const Diagnostics warnings = project->warnings;
    Q_EMIT projectLoaded(file, std::make_shared<Project>(std::move(*project)));
    for (const Diagnostic& warning : warnings)
        Q_EMIT message(warning);
}

void ImportController::tellFailure(const QString& file, Diagnostic diagnostic) {
    if (diagnostic.file.empty())
        diagnostic.file = toStdString(file);
    diagnostic.severity = Severity::Error;
    Q_EMIT message(diagnostic);
    Q_EMIT failed(file, toQString(diagnostic.message));
}

} // namespace prizma
