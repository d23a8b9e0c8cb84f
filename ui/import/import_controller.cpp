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
    importTogether({{toStdString(QFileInfo(file).absoluteFilePath())}, {}}, options);
}

void ImportController::importTogether(const BatchFiles& files, const ImportOptions& options) {
    const QString name = QFileInfo(toQString(files.models.front())).fileName();
    enqueue({tr("Importing %1…").arg(name),
             [this, files, options](Progress& progress) -> BackgroundJob::Delivery {
                 const std::vector<ImportOptions> all(files.models.size(), options);
                 auto batch = std::make_shared<ImportBatch>(importBatch(files, all, progress));
                 return [this, batch] { deliverBatch(*batch); };
             }});
}

void ImportController::importAnimations(const QStringList& files, Id object) {
    const Object* target = document_.scene().findObject(object);
    if (files.isEmpty() || !target || !target->mesh || !target->mesh->skeleton)
        return;
    AnimationTask task{object, target->mesh, target->source, {}};
    for (const QString& file : files)
        task.files.push_back(toStdString(QFileInfo(file).absoluteFilePath()));
    const QString name = QFileInfo(files.front()).fileName();
    enqueue({tr("Importing %1…").arg(name), [this, task](Progress& progress) -> BackgroundJob::Delivery {
                 auto result = std::make_shared<AnimationResult>(readAnimations(task, progress));
                 return [this, task, result] { deliverAnimations(task, *result); };
             }});
}

void ImportController::loadProject(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    enqueue({tr("Opening %1…").arg(QFileInfo(file).fileName()),
             [this, path](Progress& progress) -> BackgroundJob::Delivery {
                 auto project =
                     std::make_shared<Result<Project>>(prizma::loadProject(toStdString(path), progress));
                 return [this, path, project] { deliverProject(path, std::move(*project)); };
             }});
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
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    job_ = new BackgroundJob(task.label, std::move(task.work), this);
    connect(job_, &BackgroundJob::progressed, this, &ImportController::progressed);
    connect(job_, &BackgroundJob::finished, this, [this] {
        job_ = nullptr;
        startNext();
    });
    Q_EMIT started(job_->label());
}

ImportController::AnimationResult ImportController::readAnimations(const AnimationTask& task,
                                                                   Progress& progress) {
    AnimationResult result;
    const auto count = static_cast<double>(task.files.size());
    for (std::size_t i = 0; i < task.files.size() && !progress.isCancelled(); ++i) {
        progress.beginPart(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        auto animation = importAnimation(task.files[i], *task.mesh->skeleton, task.source, progress);
        if (animation)
            result.animations.push_back(std::move(*animation));
        else
            result.faults.push_back(animation.error());
    }
    return result;
}

void ImportController::deliverBatch(const ImportBatch& batch) {
    for (const Diagnostic& fault : batch.faults)
        tellFailure(toQString(fault.file), fault);
    if (batch.models.empty())
        return;
    const std::vector<Id> objects = addImportedModels(document_, batch.models);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        tellWarnings(warningsOf(batch.models[i]));
        Q_EMIT modelImported(objects[i], toQString(batch.models[i].source.file));
    }
}

void ImportController::deliverAnimations(const AnimationTask& task, const AnimationResult& result) {
    for (const Diagnostic& fault : result.faults)
        tellFailure(toQString(fault.file), fault);
    const Object* object = document_.scene().findObject(task.object);
    if (result.animations.empty())
        return;
    if (!object || object->mesh != task.mesh) {
        Q_EMIT message({Severity::Warning,
                        toStdString(tr("The object that the animation was for is no longer there.")),
                        result.animations.front().file, 0});
        return;
    }
    addImportedAnimations(document_, task.object, result.animations);
    int clips = 0;
    for (const ImportedAnimation& animation : result.animations) {
        tellWarnings(animation.warnings);
        clips += static_cast<int>(animation.clips.size());
    }
    Q_EMIT animationsImported(task.object, clips);
}

void ImportController::tellWarnings(const Diagnostics& warnings) {
    for (const Diagnostic& warning : warnings)
        Q_EMIT message(warning);
}

void ImportController::deliverProject(const QString& file, Result<Project> project) {
    if (!project) {
        tellFailure(file, project.error());
        return;
    }
    const Diagnostics warnings = project->warnings;
    Q_EMIT projectLoaded(file, std::make_shared<Project>(std::move(*project)));
    tellWarnings(warnings);
}

void ImportController::tellFailure(const QString& file, Diagnostic diagnostic) {
    if (diagnostic.file.empty())
        diagnostic.file = toStdString(file);
    diagnostic.severity = Severity::Error;
    Q_EMIT message(diagnostic);
    Q_EMIT failed(file, toQString(diagnostic.message));
}

} // namespace prizma
