#include "core/scene/diff.h"

#include <unordered_map>

namespace prizma {
namespace {

void diffObject(const Object& before, const Object& after, SceneDiff& changes) {
    if (before.transform != after.transform)
        changes.objectsMoved.push_back(after.id);
    if (before.visible != after.visible)
        changes.objectsShown.push_back(after.id);
    if (before.mesh != after.mesh || before.dynamic != after.dynamic)
        changes.meshesChanged.push_back(after.id);
    if (before.materials != after.materials)
        changes.materialsAssigned.push_back(after.id);
    if (before.clip != after.clip || before.clips != after.clips || before.playback != after.playback ||
        before.morphWeights != after.morphWeights)
        changes.clipsChanged.push_back(after.id);
}

void diffObjects(const CowList<Object>& before, const CowList<Object>& after, SceneDiff& changes) {
    if (before.shares(after))
        return;
    std::unordered_map<Id, const Object*> old;
    for (const Object& object : before)
        old.emplace(object.id, &object);
    for (const Object& object : after) {
        const auto found = old.find(object.id);
        if (found == old.end()) {
            changes.objectsAdded.push_back(object.id);
            continue;
        }
        diffObject(*found->second, object, changes);
        old.erase(found);
    }
    for (const Object& object : before)
        if (old.contains(object.id))
            changes.objectsRemoved.push_back(object.id);
}

/// Whether two items differ in more than their names.
template <class T>
bool differs(T a, const T& b) {
    a.name = b.name;
    return a != b;
}

template <class T>
bool differs(const CowList<T>& before, const CowList<T>& after) {
    if (before.shares(after))
        return false;
    if (before.size() != after.size())
        return true;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (differs(before[i], after[i]))
            return true;
    return false;
}

bool texturesDiffer(const CowList<Material>& before, const CowList<Material>& after) {
    if (before.shares(after))
        return false;
    if (before.size() != after.size())
        return true;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].id != after[i].id || texturesOf(before[i]) != texturesOf(after[i]) ||
            before[i].alphaMode != after[i].alphaMode) // which decides how textures are filtered
            return true;
    return false;
}

/// Whether a sample of the picture means something else; `samples` and the display's settings aside.
bool samplesDiffer(RenderSettings before, const RenderSettings& after) {
    before.samples = after.samples;
    before.exposure = after.exposure;
    before.viewTransform = after.viewTransform;
    before.denoise = after.denoise;
    return before != after;
}

} // namespace

bool SceneDiff::isEmpty() const {
    return *this == SceneDiff{};
}

bool SceneDiff::isTimeOnly() const {
    SceneDiff rest = *this;
    rest.time = false;
    return time && rest.isEmpty();
}

SceneDiff diff(const Scene& before, const Scene& after) {
    SceneDiff changes;
    diffObjects(before.objects, after.objects, changes);
    changes.lights = differs(before.lights, after.lights);
    changes.materials = differs(before.materials, after.materials);
    changes.textures = texturesDiffer(before.materials, after.materials) ||
                       before.background.image != after.background.image;
    changes.camera = before.camera != after.camera;
    changes.background = before.background != after.background;
    changes.time = before.timeline.seconds() != after.timeline.seconds();
    changes.settings = samplesDiffer(before.render, after.render);
    changes.samples = before.render.samples != after.render.samples;
    changes.exposure = before.render.exposure != after.render.exposure ||
                       before.render.viewTransform != after.render.viewTransform ||
                       before.render.denoise != after.render.denoise;
    return changes;
}

} // namespace prizma
