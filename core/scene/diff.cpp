#include "core/scene/diff.h"

#include "core/scene/hierarchy.h"

#include <algorithm>
#include <unordered_map>

namespace prizma {
namespace {

bool hasMoved(const Object& a, const Hierarchy& before, const Object& b, const Hierarchy& after) {
    if (a.parent == noId && b.parent == noId)
        return a.transform != b.transform;
    return before.worldMatrix(a) != after.worldMatrix(b);
}

void diffObject(const Object& before, const Object& after, SceneDiff& changes) {
    if (before.mesh != after.mesh || before.dynamic != after.dynamic)
        changes.meshesChanged.push_back(after.id);
    if (before.materials != after.materials)
        changes.materialsAssigned.push_back(after.id);
    if (before.clip != after.clip || before.clips != after.clips || before.playback != after.playback ||
        before.morphWeights != after.morphWeights)
        changes.clipsChanged.push_back(after.id);
}

void diffObjects(const Scene& sceneBefore, const Scene& sceneAfter, SceneDiff& changes) {
    const CowList<Object>& before = sceneBefore.objects;
    const CowList<Object>& after = sceneAfter.objects;
    if (before.shares(after) && sceneBefore.groups.shares(sceneAfter.groups))
        return;
    const Hierarchy hierarchyBefore(sceneBefore);
    const Hierarchy hierarchyAfter(sceneAfter);
    std::unordered_map<Id, const Object*> old;
    for (const Object& object : before)
        old.emplace(object.id, &object);
    for (const Object& object : after) {
        const auto found = old.find(object.id);
        if (found == old.end()) {
            changes.objectsAdded.push_back(object.id);
            continue;
        }
        if (hasMoved(*found->second, hierarchyBefore, object, hierarchyAfter))
            changes.objectsMoved.push_back(object.id);
        if (hierarchyBefore.isShown(*found->second) != hierarchyAfter.isShown(object))
            changes.objectsShown.push_back(object.id);
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

/// Whether any light shines otherwise, be it for itself, for its group or for another one's solo.
bool lightsDiffer(const Scene& before, const Scene& after) {
    if (before.lights.shares(after.lights) && before.groups.shares(after.groups))
        return false;
    const std::vector<Light> a = lightsInWorld(before);
    const std::vector<Light> b = lightsInWorld(after);
    return !std::ranges::equal(a, b, [](const Light& x, const Light& y) { return !differs(x, y); });
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
    diffObjects(before, after, changes);
    changes.lights = lightsDiffer(before, after);
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
