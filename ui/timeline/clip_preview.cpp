#include "ui/timeline/clip_preview.h"

#include "core/animation/pose_key.h"
#include "ui/document/document.h"
#include "ui/timeline/timeline_controller.h"

#include <chrono>
#include <optional>

namespace prizma {
namespace {

constexpr std::chrono::milliseconds interval{16};

/// At once, without a fade; if `seconds` is given, at that time of the clip.
void playClip(Object& object, const std::string& clip, double sceneSeconds, std::optional<double> seconds) {
    changeClip(object, clip, sceneSeconds, 0.0);
    if (seconds)
        object.playback.offset = *seconds - object.playback.speed * sceneSeconds;
}

} // namespace

ClipPreview::ClipPreview(Document& document, const TimelineController& controller, QObject* parent)
    : QObject(parent), document_(document), controller_(controller), timer_(this) {
    timer_.setInterval(interval);
    connect(&timer_, &QTimer::timeout, this, &ClipPreview::apply);
    connect(&document, &Document::replaced, this, [this] {
        timer_.stop();
        object_ = noId;
    });
}

void ClipPreview::show(Id object, const std::string& clip) {
    if (object == object_ && clip == clip_)
        return;
    object_ = object;
    clip_ = clip;
    elapsed_.start();
    timer_.start();
    apply();
}

void ClipPreview::end() {
    if (object_ == noId)
        return;
    object_ = noId;
    timer_.stop();
    document_.endPreview();
}

void ClipPreview::apply() {
    std::optional<double> seconds;
    if (!controller_.isPlaying())
        seconds = static_cast<double>(elapsed_.nsecsElapsed()) * 1e-9;
    document_.setPreview([id = object_, clip = clip_, seconds](Scene& scene) {
        for (Object& object : scene.objects.edit())
            if (object.id == id)
                playClip(object, clip, scene.timeline.seconds(), seconds);
    });
}

} // namespace prizma
