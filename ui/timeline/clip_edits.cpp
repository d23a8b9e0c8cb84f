#include "ui/timeline/clip_edits.h"

#include "core/animation/clip_time.h"
#include "core/animation/pose_key.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace prizma {
const Object* timelineObject(const Document& document) {
    const Scene& scene = document.scene();
    for (const EntityRef& entity : document.selection() | std::views::reverse) {
        const Object* object = entity.kind == EntityKind::Object ? scene.findObject(entity.id) : nullptr;
        if (object && !object->clips.empty())
            return object;
    }
    const Object* only = nullptr;
    for (const Object& object : scene.objects) {
        if (object.clips.empty())
            continue;
        if (only)
            return nullptr;
        only = &object;
    }
    return only;
}

std::optional<ClipSpan> playingSpan(const Document& document) {
    const Object* object = timelineObject(document);
    const ClipPtr clip = object ? findClip(*object, object->clip) : nullptr;
    if (!clip)
        return std::nullopt;
    const Playback& playback = object->playback;
    const double rate = document.scene().timeline.fps;
    const double frames = playingSeconds(*clip, playback) * rate;
    if (!std::isfinite(frames) || frames <= 0.0)
        return std::nullopt;
    ClipSpan span{toQString(clip->name), -playback.offset / playback.speed * rate, frames,
                  loopMode(*clip, playback) != LoopMode::Once};
    if (playback.speed < 0.0)
        span.start -= frames; // it runs towards its beginning
    return span;
}

void chooseClip(Document& document, Id id, const std::string& clip, bool fromNow) {
    const Object* object = document.scene().findObject(id);
    if (!object || object->clip == clip)
        return;
    const QString what = nameOf(document.scene(), {EntityKind::Object, id});
    document.edit(Document::tr("Change clip of %1").arg(what), [&](Scene& scene) {
        for (Object& edited : scene.objects.edit()) {
            if (edited.id != id)
                continue;
            const double fade = edited.playback.fadeSeconds;
            changeClip(edited, clip, scene.timeline.seconds() - (fromNow ? 0.0 : fade), fade);
        }
    });
}

void fitTimeline(Document& document, const Object& object, const Clip& clip) {
    const double rate = frameRate(clip, object.playback);
    const double frames = std::round(playingSeconds(clip, object.playback) * rate);
    const bool loops = loopMode(clip, object.playback) == LoopMode::Loop;
    if (!std::isfinite(frames))
        return; // it stands still
    document.edit(Document::tr("Fit timeline to %1").arg(toQString(clip.name)), [&](Scene& scene) {
        Timeline& timeline = scene.timeline;
        timeline.fps = rate;
        timeline.start = 0;
        // The frame in which a loop begins anew is its first one.
        timeline.end =
            static_cast<int>(std::clamp(loops ? frames - 1.0 : frames, 0.0, Timeline::furthestFrame));
        timeline.frame = std::clamp(timeline.frame, 0.0, static_cast<double>(timeline.end));
    });
}

} // namespace prizma
