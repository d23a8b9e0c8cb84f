#include "core/scene/edits.h"

#include "core/animation/posed_bounds.h"
#include "core/scene/group_edits.h"
#include "core/scene/primitives.h"
#include "core/scene/property_tables.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

template <class T>
T* findEditable(CowList<T>& list, Id id) {
    if (std::none_of(list.begin(), list.end(), [id](const T& item) { return item.id == id; }))
        return nullptr; // looked up first, because edit() copies the list
    auto& items = list.edit();
    return &*std::find_if(items.begin(), items.end(), [id](const T& item) { return item.id == id; });
}

template <class T>
bool removeById(CowList<T>& list, Id id) {
    if (!findEditable(list, id))
        return false;
    std::erase_if(list.edit(), [id](const T& item) { return item.id == id; });
    return true;
}

bool isMaterialUsed(const Scene& scene, Id material) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [material](const Object& object) {
        return std::find(object.materials.begin(), object.materials.end(), material) !=
               object.materials.end();
    });
}

void removeMaterial(Scene& scene, Id id) {
    removeById(scene.materials, id);
    if (!isMaterialUsed(scene, id))
        return;
    const Material* standIn = scene.findMaterial("default");
    Material fresh;
    fresh.name = "default";
    const Id replacement = standIn ? standIn->id : addMaterial(scene, fresh);
    for (Object& object : scene.objects.edit())
        std::replace(object.materials.begin(), object.materials.end(), id, replacement);
}

/// A step along the world's X in the space of a group; none if the group has no size.
glm::dvec3 stepIn(const Scene& scene, Id group, double length) {
    const glm::dmat4 toGroup = glm::inverse(Hierarchy(scene).toWorld(group));
    const glm::dvec3 step(toGroup * glm::dvec4(length, 0.0, 0.0, 0.0));
    return std::isfinite(glm::dot(step, step)) ? step : glm::dvec3(0.0);
}

Id duplicateObject(Scene& scene, Object copy) {
    // In its original's place a copy would go unseen.
    copy.transform.translation += stepIn(scene, copy.parent, worldBounds(scene, copy).extent().x * 1.1);
    return addObject(scene, std::move(copy));
}

Id duplicateLight(Scene& scene, Light copy) {
    const double step = glm::distance(scene.camera.position, scene.camera.target) * 0.1;
    if (copy.type != LightType::Directional)
        copy.position += stepIn(scene, copy.parent, step);
    return addLight(scene, std::move(copy));
}

EntityRef duplicate(Scene& scene, EntityRef entity) {
    switch (entity.kind) {
    case EntityKind::Object:
        if (const Object* object = scene.findObject(entity.id))
            return {entity.kind, duplicateObject(scene, *object)};
        break;
    case EntityKind::Light:
        if (const Light* light = scene.findLight(entity.id))
            return {entity.kind, duplicateLight(scene, *light)};
        break;
    case EntityKind::Material:
        if (const Material* material = scene.findMaterial(entity.id))
            return {entity.kind, addMaterial(scene, *material)};
        break;
    case EntityKind::Group:
        return {entity.kind, duplicateGroup(scene, entity.id)};
    default:
        break;
    }
    return {entity.kind, noId};
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    const auto last = text.find_last_not_of(" \t\r\n");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

template <class T>
Result<void> rename(CowList<T>& list, Id id, const std::string& name) {
    T* item = findEditable(list, id);
    if (!item)
        return failure("it is no longer in the scene");
    if (item->name == name)
        return {};
    item->name.clear(); // so that a name is not taken because of the item's own old one
    item->name = uniqueName(list, name);
    return {};
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double roundDown(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    return power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

double viewDistance(const Camera& camera) {
    const double distance = glm::distance(camera.position, camera.target);
    return std::isfinite(distance) && distance > 0.0 ? distance : 6.0;
}

/// Lower-case key of an enumeration's value: a good first name.
template <class Enum>
std::string keyOf(Enum value) {
    return std::string(choicesOf<Enum>()[static_cast<std::size_t>(value)].key);
}

} // namespace

int removeEntities(Scene& scene, std::span<const EntityRef> entities) {
    int removed = 0;
    for (const EntityRef& entity : withMembers(scene, entities)) {
        if (entity.kind == EntityKind::Object) {
            removed += removeById(scene.objects, entity.id) ? 1 : 0;
        } else if (entity.kind == EntityKind::Light) {
            removed += removeById(scene.lights, entity.id) ? 1 : 0;
        } else if (entity.kind == EntityKind::Group) {
            removed += removeById(scene.groups, entity.id) ? 1 : 0;
        } else if (entity.kind == EntityKind::Material && scene.findMaterial(entity.id)) {
            removeMaterial(scene, entity.id);
            ++removed;
        }
    }
    return removed;
}

std::vector<EntityRef> duplicateEntities(Scene& scene, std::span<const EntityRef> entities) {
    const auto carried = topmost(scene, entities);
    std::vector<EntityRef> copies;
    for (const EntityRef& entity : entities)
        if (entity.kind == EntityKind::Material || std::ranges::count(carried, entity) > 0)
            if (const EntityRef copy = duplicate(scene, entity); copy.id != noId)
                copies.push_back(copy);
    return copies;
}

Result<void> renameEntity(Scene& scene, EntityRef entity, const std::string& name) {
    const std::string wanted = trimmed(name);
    if (wanted.empty())
        return failure("a name must not be empty");
    switch (entity.kind) {
    case EntityKind::Object:
        return rename(scene.objects, entity.id, wanted);
    case EntityKind::Light:
        return rename(scene.lights, entity.id, wanted);
    case EntityKind::Material:
        return rename(scene.materials, entity.id, wanted);
    case EntityKind::Group:
        return rename(scene.groups, entity.id, wanted);
    default:
        return failure("it cannot be renamed");
    }
}

Id addPrimitive(Scene& scene, PrimitiveType type) {
    const double distance = viewDistance(scene.camera);
    Object object;
    object.name = keyOf(type);
    object.source.primitive = type;
    object.source.size = roundDown(distance / (type == PrimitiveType::Plane ? 1.0 : 5.0));
    object.mesh = makePrimitive(type, object.source.size);
    // On the ground, if the ground is near to what the camera looks at.
    const glm::dvec3& target = scene.camera.target;
    const double ground = std::abs(target.y) < distance ? 0.0 : target.y;
    object.transform.translation = {target.x, ground, target.z};
    if (object.mesh)
        object.transform.translation.y -= static_cast<double>(object.mesh->bounds.low.y);
    const Material* plain = scene.findMaterial("default");
    Material fresh;
    fresh.name = "default";
    object.materials.assign(object.mesh ? object.mesh->slots.size() : 1,
                            plain ? plain->id : addMaterial(scene, fresh));
    return addObject(scene, std::move(object));
}

Id addLight(Scene& scene, LightType type) {
    const double distance = viewDistance(scene.camera);
    const double scale = distance / 6.0; // the defaults suit a view from six units away
    Light light;
    light.name = keyOf(type);
    light.type = type;
    light.position =
        scene.camera.target + (glm::dvec3(0.0, 0.5, 0.0) + frameOf(scene.camera).right * 0.2) * distance;
    light.intensity *= scale * scale;
    light.size *= scale;
    light.radius *= scale;
    if (type == LightType::Directional)
        light.direction = glm::normalize(glm::dvec3(-0.3, -1.0, -0.4));
    return addLight(scene, std::move(light));
}

Id addMaterial(Scene& scene) {
    Material material;
    material.name = "material";
    return addMaterial(scene, std::move(material));
}

void assignMaterial(Scene& scene, std::span<const Id> objects, int slot, Id material) {
    for (const Id id : objects) {
        Object* object = findEditable(scene.objects, id);
        if (!object)
            continue;
        if (slot < 0)
            std::fill(object->materials.begin(), object->materials.end(), material);
        else if (slot < static_cast<int>(object->materials.size()))
            object->materials[static_cast<std::size_t>(slot)] = material;
    }
}

bool isWellInView(const Camera& camera, const DBounds& bounds, double aspect) {
    if (bounds.isEmpty())
        return false;
    const CameraFrame frame = frameOf(camera);
    const glm::dvec3 toCentre = bounds.centre() - camera.position;
    const double depth = glm::dot(toCentre, frame.forward);
    const double halfHeight = depth * std::tan(glm::radians(camera.fovY) * 0.5);
    if (depth <= 0.0 || std::abs(glm::dot(toCentre, frame.up)) > halfHeight ||
        std::abs(glm::dot(toCentre, frame.right)) > halfHeight * aspect)
        return false;
    const double share = glm::length(bounds.extent()) * 0.5 / halfHeight;
    return share > 0.05 && share < 2.0;
}

} // namespace prizma
