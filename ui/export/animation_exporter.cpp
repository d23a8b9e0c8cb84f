#include "ui/export/animation_exporter.h"

#include "ui/document/strings.h"

#include <QFileInfo>

namespace prizma {
namespace {

Result<SequenceSummary> render(const Scene& scene, const std::string& deviceId,
                               const AnimationExport& animation, Progress& progress,
                               std::atomic<bool>& makingVideo) {
    RendererOptions options;
    options.deviceId = deviceId;
    auto renderer = Renderer::create(std::move(options));
    if (!renderer)
        return std::unexpected(renderer.error());
    return exportAnimation(**renderer, scene, animation, progress, [&makingVideo] { makingVideo = true; });
}

} // namespace

void AnimationExporter::start(const Scene& scene, const QString& deviceId, const AnimationExport& animation) {
    if (isBusy())
        return;
    animation_ = animation;
    makingVideo_ = std::make_shared<std::atomic<bool>>(false);
    const QString name = QFileInfo(toQString(animation.output)).fileName();
    job_ = new BackgroundJob(
        tr("Exporting %1…").arg(name),
        [this, scene, device = toStdString(deviceId), animation,
         makingVideo = makingVideo_](Progress& progress) -> BackgroundJob::Delivery {
            auto summary = render(scene, device, animation, progress, *makingVideo);
            return [this, summary = std::move(summary)] { deliver(summary); };
        },
        this);
    connect(job_, &BackgroundJob::progressed, this, &AnimationExporter::progressed);
    connect(job_, &BackgroundJob::finished, this, [this] {
        job_ = nullptr;
        Q_EMIT finished();
    });
    Q_EMIT started();
}

void AnimationExporter::cancel() {
    if (!job_)
        return;
    job_->cancel();
    Q_EMIT message(
        {Severity::Information,
         toStdString(tr("The export was cancelled. The frames that are done stay: to go on, export again.")),
         animation_.output, 0});
}

void AnimationExporter::deliver(const Result<SequenceSummary>& summary) {
    if (!summary) {
        Q_EMIT message(summary.error());
        return;
    }
    const int count = summary->rendered + summary->skipped;
    QString text = count == 1 ? tr("Exported one frame.") : tr("Exported %n frames.", nullptr, count);
    if (summary->skipped > 0)
        text += QLatin1Char(' ') + tr("%n of them had been rendered before.", nullptr, summary->skipped);
    Q_EMIT message({Severity::Information, toStdString(text), animation_.output, 0});
}

} // namespace prizma
