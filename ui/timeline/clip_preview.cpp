#include "ui/timeline/clip_preview.h"

#include "ui/document/document.h"
#include "ui/timeline/timeline_controller.h"

#include <chrono>

namespace prizma {
namespace {

constexpr std::chrono::milliseconds interval{16};

void playClip(Scene& scene, Id id, const std::string& clip) {
    for (Object& object : scene.objects.edit())
        if (object.id == id)
            object.clip = clip;
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

ClipPreview::~ClipPreview() {
    end();
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
    const bool playing = controller_.isPlaying();
    const double seconds = static_cast<double>(elapsed_.nsecsElapsed()) * 1e-9;
    document_.setPreview([object = object_, clip = clip_, playing, seconds](Scene& scene) {
        playClip(scene, object, clip);
        if (!playing && !clip.empty())
            scene.timeline.frame = seconds * scene.timeline.fps;
    });
}

} // namespace prizma
