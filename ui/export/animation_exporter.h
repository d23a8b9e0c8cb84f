#pragma once

#include "core/render/animation_export.h"
#include "ui/import/background_job.h"

#include <QObject>
#include <QPointer>

#include <atomic>
#include <memory>

namespace prizma {

/// Exports one animation at a time in the background, on a renderer of its own: the view goes on.
class AnimationExporter : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Renders `scene` as it is now on the device `deviceId` names. Does nothing while one is being exported.
    void start(const Scene& scene, const QString& deviceId, const AnimationExport& animation);
    void cancel(); ///< The frames that are done stay.

    bool isBusy() const { return job_ != nullptr; }
    bool isMakingVideo() const { return makingVideo_ && *makingVideo_; } ///< All frames are rendered.
    const AnimationExport& animation() const { return animation_; }      ///< The one of the last start.

  Q_SIGNALS:
    void started();
    void progressed(double fraction); ///< Of the frames; of the video while that is being made.
    void finished();                  ///< However it ended; `message` says how.
    void message(const prizma::Diagnostic& diagnostic);

  private:
    void deliver(const Result<SequenceSummary>& summary);

    AnimationExport animation_;
    std::shared_ptr<std::atomic<bool>> makingVideo_;
    QPointer<BackgroundJob> job_;
};

} // namespace prizma
