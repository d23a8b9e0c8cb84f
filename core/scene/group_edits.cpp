#include "core/scene/group_edits.h"

#include "core/animation/posed_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace prizma {
namespace {

bool hangs(EntityRef entity) {
    return entity.kind == EntityKind::Object || entity.kind == EntityKind::Light ||
           entity.kind == EntityKind::Group;
}

template <class T>
T& editable(CowList<T>& list, Id id) {
    return *std::ranges::find(list.edit(), id, &T::id);
}

bool isFinite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

/// Hangs one entity, which exists, under `group`. `change` is from the space of its old group to the new
/// one's; nothing if there is no way from one to the other, or none is needed.
void hang(Scene& scene, EntityRef entity, Id group, const std::optional<glm::dmat4>& change) {
    const auto move = [&](auto& item) {
        item.parent = group;
        if (change)
            item.transform = transformOf(*change * item.transform.matrix());
    };
    if (entity.kind == EntityKind::Object) {
        move(editable(scene.objects, entity.id));
    } else if (entity.kind == EntityKind::Group) {
        move(editable(scene.groups, entity.id));
    } else {
        Light& light = editable(scene.lights, entity.id);
        light.parent = group;
        if (change)
            light = transformed(light, *change);
    }
}

/// From the space of one group to that of another.
std::optional<glm::dmat4> changeOfSpace(const Hierarchy& hierarchy, Id from, Id to) {
    const glm::dmat4& old = hierarchy.toWorld(from);
    const glm::dmat4& fresh = hierarchy.toWorld(to);
    if (old == fresh)
        return std::nullopt;
    const glm::dmat4 change = glm::inverse(fresh) * old;
    return isFinite(change) ? std::optional(change) : std::nullopt; // a group of no size has no inside
}

/// The nearest group that all of `entities` hang under, or noId.
Id commonGroup(const Scene& scene, const Hierarchy& hierarchy, std::span<const EntityRef> entities) {
    Id common = parentOf(scene, entities.front());
    while (findGroup(scene, common) && !std::ranges::all_of(entities, [&](const EntityRef& entity) {
               return hierarchy.isWithin(parentOf(scene, entity), common);
           }))
        common = parentOf(scene, {EntityKind::Group, common});
    return findGroup(scene, common) ? common : noId;
}

void hide(Scene& scene, EntityRef entity) {
    if (entity.kind == EntityKind::Object)
        editable(scene.objects, entity.id).visible = false;
    else if (entity.kind == EntityKind::Group)
        editable(scene.groups, entity.id).visible = false;
    else
        editable(scene.lights, entity.id).enabled = false;
}

/// Copies what hangs under `from` to hang under `to`.
void copyMembers(Scene& scene, Id from, Id to) {
    for (const EntityRef& member : membersOf(scene, from)) {
        const auto copyOf = [to](const auto& item) {
            auto copy = item;
            copy.parent = to;
            return copy;
        };
        if (member.kind == EntityKind::Object)
            addObject(scene, copyOf(*scene.findObject(member.id)));
        else if (member.kind == EntityKind::Light)
            addLight(scene, copyOf(*scene.findLight(member.id)));
        else
            copyMembers(scene, member.id, addGroup(scene, copyOf(*findGroup(scene, member.id))));
    }
}

} // namespace

Transform transformOf(const glm::dmat4& matrix) {
    Transform transform;
    transform.translation = glm::dvec3(matrix[3]);
    glm::dvec3 axes[3] = {glm::dvec3(matrix[0]), glm::dvec3(matrix[1]), glm::dvec3(matrix[2])};
    for (int i = 0; i < 3; ++i)
        transform.scale[i] = glm::length(axes[i]);
    if (glm::determinant(glm::dmat3(matrix)) < 0.0) { // mirrored
        transform.scale.x = -transform.scale.x;
        axes[0] = -axes[0];
    }
    // Gram and Schmidt's way to right angles; an axis of no length gets any direction that is left.
    const auto anyAcross = [](const glm::dvec3& v) {
        const glm::dvec3 helper = std::abs(v.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        return glm::normalize(glm::cross(v, helper));
    };
    const auto unit = [](const glm::dvec3& v, double whole) -> std::optional<glm::dvec3> {
        const double length = glm::length(v);
        return length > 1e-12 * whole ? std::optional(v / length) : std::nullopt;
    };
    const auto across = [&](const glm::dvec3& v, const glm::dvec3& x) { return v - x * glm::dot(v, x); };
    const auto z = unit(axes[2], 0.0);
    const auto y = unit(axes[1], 0.0);
    const glm::dvec3 x = unit(axes[0], 0.0)
                             .value_or(y && z ? glm::cross(*y, *z)
                                       : y    ? anyAcross(*y)
                                       : z    ? anyAcross(*z)
                                              : glm::dvec3(1, 0, 0));
    const glm::dvec3 firstAxis = glm::normalize(x);
    const auto second = unit(across(axes[1], firstAxis), glm::length(axes[1]));
    const auto third = unit(across(axes[2], firstAxis), glm::length(axes[2]));
    const glm::dvec3 secondAxis = second  ? *second
                                  : third ? glm::cross(*third, firstAxis)
                                          : anyAcross(firstAxis);
    const glm::dmat3 turn(firstAxis, secondAxis, glm::cross(firstAxis, secondAxis));
    transform.rotation = glm::normalize(glm::quat_cast(turn));
    return transform;
}

std::vector<EntityRef> topmost(const Scene& scene, std::span<const EntityRef> entities) {
    const Hierarchy hierarchy(scene);
    std::vector<EntityRef> kept;
    for (const EntityRef& entity : entities) {
        if (!hangs(entity) || !exists(scene, entity) || std::ranges::count(kept, entity) > 0)
            continue;
        const bool isCarried = std::ranges::any_of(entities, [&](const EntityRef& other) {
            return other.kind == EntityKind::Group && other != entity &&
                   hierarchy.isWithin(parentOf(scene, entity), other.id);
        });
        if (!isCarried)
            kept.push_back(entity);
    }
    return kept;
}

std::vector<EntityRef> withMembers(const Scene& scene, std::span<const EntityRef> entities) {
    std::vector<EntityRef> all;
    for (const EntityRef& entity : entities)
        if (std::ranges::count(all, entity) == 0)
            all.push_back(entity);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].kind == EntityKind::Group)
            for (const EntityRef& member : membersOf(scene, all[i].id))
                if (std::ranges::count(all, member) == 0)
                    all.push_back(member);
    return all;
}

Result<void> reparent(Scene& scene, std::span<const EntityRef> entities, Id group) {
    if (group != noId && !findGroup(scene, group))
        return failure("it is no longer in the scene");
    const Hierarchy hierarchy(scene);
    const auto moved = topmost(scene, entities);
    for (const EntityRef& entity : moved)
        if (entity.kind == EntityKind::Group && hierarchy.isWithin(group, entity.id))
            return failure("a group cannot be put into itself");
    for (const EntityRef& entity : moved)
        if (const Id parent = parentOf(scene, entity); parent != group)
            hang(scene, entity, group, changeOfSpace(hierarchy, parent, group));
    return {};
}

Id groupEntities(Scene& scene, std::span<const EntityRef> entities) {
    const auto members = topmost(scene, entities);
    if (members.empty())
        return noId;
    const Hierarchy hierarchy(scene);
    Group group;
    group.name = "group";
    group.parent = commonGroup(scene, hierarchy, members);
    const DBounds bounds = worldBounds(scene, members);
    const glm::dvec4 middle(bounds.isEmpty() ? glm::dvec3(0.0) : bounds.centre(), 1.0);
    const glm::dvec3 origin(glm::inverse(hierarchy.toWorld(group.parent)) * middle);
    if (std::isfinite(glm::dot(origin, origin)))
        group.transform.translation = origin;
    const Id id = addGroup(scene, group);
    // Never an error: the group is new, so that nothing hangs under it.
    static_cast<void>(reparent(scene, members, id));
    return id;
}

std::vector<EntityRef> ungroupEntities(Scene& scene, std::span<const EntityRef> entities) {
    std::vector<EntityRef> freed;
    for (const EntityRef& entity : entities) {
        const Group* found = entity.kind == EntityKind::Group ? findGroup(scene, entity.id) : nullptr;
        if (!found)
            continue;
        const Group group = *found;
        const auto members = membersOf(scene, group.id);
        const Id parent = findGroup(scene, group.parent) ? group.parent : noId;
        static_cast<void>(reparent(scene, members, parent)); // a group is never within its own members
        if (!group.visible)
            for (const EntityRef& member : members)
                hide(scene, member);
        std::erase_if(scene.groups.edit(), [&](const Group& g) { return g.id == group.id; });
        std::erase(freed, entity);
        freed.insert(freed.end(), members.begin(), members.end());
    }
    return freed;
}

Id duplicateGroup(Scene& scene, Id group) {
    const Group* original = findGroup(scene, group);
    if (!original)
        return noId;
    // In its original's place a copy would go unseen.
    const EntityRef entity{EntityKind::Group, group};
    const DBounds bounds = worldBounds(scene, std::span(&entity, 1));
    const glm::dmat4 toParent = glm::inverse(Hierarchy(scene).toWorld(original->parent));
    const glm::dvec3 step(toParent * glm::dvec4(bounds.extent().x * 1.1, 0.0, 0.0, 0.0));
    Group copy = *original;
    if (std::isfinite(glm::dot(step, step)))
        copy.transform.translation += step;
    const Id id = addGroup(scene, copy);
    copyMembers(scene, group, id);
    return id;
}

DBounds worldBounds(const Scene& scene, std::span<const EntityRef> entities) {
    const Hierarchy hierarchy(scene);
    DBounds bounds;
    for (const EntityRef& entity : withMembers(scene, entities)) {
        if (const Object* object = entity.kind == EntityKind::Object ? scene.findObject(entity.id) : nullptr)
            bounds.add(worldBounds(*object, hierarchy.worldMatrix(*object), scene.timeline.seconds()));
        else if (const Light* light = entity.kind == EntityKind::Light ? scene.findLight(entity.id) : nullptr)
            bounds.add(transformed(*light, hierarchy.toWorld(light->parent)).position);
    }
    return bounds;
}

} // namespace prizma
