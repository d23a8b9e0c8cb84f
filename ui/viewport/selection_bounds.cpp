#include "ui/viewport/selection_bounds.h"

#include "core/animation/posed_bounds.h"
#include "core/scene/group_edits.h"

namespace prizma {
namespace {

constexpr double bareLightRadius = 0.5; // Point and spot lights have no size; show what is around them.

DBounds boundsOf(const Light& light) {
    DBounds bounds;
    double radius = bareLightRadius;
    if (light.type == LightType::Directional)
        return bounds;
    if (light.type == LightType::Sphere)
        radius = light.radius;
    if (light.type == LightType::Rectangle)
        radius = 0.5 * glm::length(light.size);
    bounds.add(light.position - glm::dvec3(radius));
    bounds.add(light.position + glm::dvec3(radius));
    return bounds;
}

} // namespace

DBounds selectionBounds(const Scene& scene, std::span<const EntityRef> selection) {
    const Hierarchy hierarchy(scene);
    DBounds bounds;
    for (const EntityRef& entity : withMembers(scene, selection)) {
        if (entity.kind == EntityKind::Object) {
            if (const Object* object = scene.findObject(entity.id))
                bounds.add(worldBounds(scene, *object));
        } else if (entity.kind == EntityKind::Light) {
            if (const Light* light = scene.findLight(entity.id))
                bounds.add(boundsOf(transformed(*light, hierarchy.toWorld(light->parent))));
        }
    }
    return bounds;
}

} // namespace prizma
