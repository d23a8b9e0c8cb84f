#include "core/scene/hierarchy.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// `v` at unit length, or `otherwise` if it has no direction.
glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? v / length : otherwise;
}

void transformRectangle(Light& light, const glm::dmat3& turn) {
    const glm::dmat3 axes = glm::mat3_cast(glm::normalize(light.rotation));
    const glm::dvec3 along = turn * axes[0] * light.size.x;
    const glm::dvec3 across = turn * axes[2] * light.size.y;
    const glm::dvec3 x = unitOr(along, axes[0]);
    const glm::dvec3 square = across - x * glm::dot(x, across);
    const glm::dvec3 z = unitOr(square, axes[2]);
    glm::dvec3 y = glm::cross(z, x);
    if (glm::dot(y, turn * axes[1]) < 0.0) // mirrored: it still shines to the side it is turned to
        y = -y;
    light.rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
    light.size = {glm::length(along), glm::length(square)};
}

template <class T>
void appendMembers(const CowList<T>& list, EntityKind kind, Id group, std::vector<EntityRef>& members) {
    for (const T& item : list)
        if (item.parent == group)
            members.push_back({kind, item.id});
}

} // namespace

Hierarchy::Hierarchy(const Scene& scene) {
    nodes_.reserve(scene.groups.size());
    std::unordered_map<Id, const Group*> groups;
    for (const Group& group : scene.groups)
        groups.emplace(group.id, &group);
    std::vector<const Group*> chain;
    for (const Group& start : scene.groups) {
        chain.clear();
        Id next = start.id;
        while (!nodes_.contains(next)) {
            const auto group = groups.find(next);
            if (group == groups.end() || std::ranges::find(chain, group->second) != chain.end())
                break; // the top, or a circle
            chain.push_back(group->second);
            next = group->second->parent;
        }
        for (; !chain.empty(); chain.pop_back()) {
            const Group& group = *chain.back();
            const Node* above = find(group.parent);
            Node node;
            node.parent = above ? group.parent : noId;
            node.toWorld = above ? above->toWorld * group.transform.matrix() : group.transform.matrix();
            node.shows = group.visible && (!above || above->shows);
            nodes_.emplace(group.id, node);
        }
    }
}

const Hierarchy::Node* Hierarchy::find(Id group) const {
    const auto found = nodes_.find(group);
    return found == nodes_.end() ? nullptr : &found->second;
}

const glm::dmat4& Hierarchy::toWorld(Id group) const {
    static const glm::dmat4 identity(1.0);
    const Node* node = find(group);
    return node ? node->toWorld : identity;
}

bool Hierarchy::shows(Id group) const {
    const Node* node = find(group);
    return !node || node->shows;
}

bool Hierarchy::isWithin(Id group, Id ancestor) const {
    for (const Node* node = find(group); node; group = node->parent, node = find(group))
        if (group == ancestor)
            return true;
    return false;
}

glm::dmat4 Hierarchy::worldMatrix(const Object& object) const {
    const Node* group = find(object.parent);
    return group ? group->toWorld * object.transform.matrix() : object.transform.matrix();
}

glm::dmat4 worldMatrix(const Scene& scene, const Object& object) {
    return object.parent == noId ? object.transform.matrix() : Hierarchy(scene).worldMatrix(object);
}

bool isShown(const Scene& scene, const Object& object) {
    return object.visible && (object.parent == noId || Hierarchy(scene).shows(object.parent));
}

Light transformed(Light light, const glm::dmat4& toWorld) {
    const glm::dmat3 turn(toWorld);
    light.position = glm::dvec3(toWorld * glm::dvec4(light.position, 1.0));
    light.direction = unitOr(turn * light.direction, light.direction);
    light.radius *= std::cbrt(std::abs(glm::determinant(turn)));
    if (light.type == LightType::Rectangle)
        transformRectangle(light, turn);
    return light;
}

std::vector<Light> lightsInWorld(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    const bool anySolo =
        std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.solo; });
    std::vector<Light> lights;
    lights.reserve(scene.lights.size());
    for (const Light& light : scene.lights) {
        const Id group = light.parent;
        lights.push_back(findGroup(scene, group) ? transformed(light, hierarchy.toWorld(group)) : light);
        Light& placed = lights.back();
        placed.parent = noId;
        placed.enabled = light.enabled && hierarchy.shows(group) && (light.solo || !anySolo);
        placed.solo = false;
    }
    return lights;
}

const Group* findGroup(const Scene& scene, Id id) {
    const auto found = std::ranges::find(scene.groups, id, &Group::id);
    return found == scene.groups.end() ? nullptr : &*found;
}

Id addGroup(Scene& scene, Group item) {
    item.id = scene.newId();
    item.name = uniqueName(scene.groups, item.name);
    scene.groups.edit().push_back(std::move(item));
    return scene.lastId;
}

Id parentOf(const Scene& scene, EntityRef entity) {
    const auto parent = [](const auto* item) { return item ? item->parent : noId; };
    switch (entity.kind) {
    case EntityKind::Object:
        return parent(scene.findObject(entity.id));
    case EntityKind::Light:
        return parent(scene.findLight(entity.id));
    case EntityKind::Group:
        return parent(findGroup(scene, entity.id));
    default:
        return noId;
    }
}

std::vector<EntityRef> membersOf(const Scene& scene, Id group) {
    std::vector<EntityRef> members;
    appendMembers(scene.groups, EntityKind::Group, group, members);
    appendMembers(scene.objects, EntityKind::Object, group, members);
    appendMembers(scene.lights, EntityKind::Light, group, members);
    return members;
}

} // namespace prizma
