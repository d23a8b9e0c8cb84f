#include "ui/timeline/clip_edits.h"

#include "ui/document/document.h"
#include "ui/document/strings.h"

#include <algorithm>
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

const Clip* findClip(const Object& object, const std::string& name) {
    const auto found =
        std::ranges::find_if(object.clips, [&](const ClipPtr& clip) { return clip->name == name; });
    return found == object.clips.end() ? nullptr : found->get();
}

void chooseClip(Document& document, Id object, const std::string& clip) {
    document.setProperty({{EntityKind::Object, object}}, "clip", clip);
}

void fitTimeline(Document& document, const Clip& clip) {
    document.edit(Document::tr("Fit timeline to %1").arg(toQString(clip.name)), [&](Scene& scene) {
        scene.timeline.fps = clip.fps;
        scene.timeline.start = 0;
        scene.timeline.end = std::max(clip.frameCount - 1, 0);
        scene.timeline.frame = std::clamp(scene.timeline.frame, 0.0, static_cast<double>(scene.timeline.end));
    });
}

} // namespace prizma
