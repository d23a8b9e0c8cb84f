#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

template <class T>
const T* findById(const CowList<T>& list, Id id) {
    const auto found = std::find_if(list.begin(), list.end(), [id](const T& item) { return item.id == id; });
    return found == list.end() ? nullptr : &*found;
}

template <class T>
Id addItem(Scene& scene, CowList<T>& list, T item) {
    item.id = scene.newId();
    item.name = uniqueName(list, item.name);
    const Id id = item.id;
    list.edit().push_back(std::move(item));
    return id;
}

/// The name without a number that `uniqueName` put behind it earlier.
std::string stem(const std::string& name) {
    const auto space = name.find_last_of(' ');
    if (space == std::string::npos || space + 1 == name.size() || space == 0)
        return name;
    const bool number = std::all_of(name.begin() + static_cast<std::ptrdiff_t>(space) + 1, name.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    return number ? name.substr(0, space) : name;
}

} // namespace

const Object* Scene::findObject(Id id) const { return findById(objects, id); }
const Light* Scene::findLight(Id id) const { return findById(lights, id); }
const Material* Scene::findMaterial(Id id) const { return findById(materials, id); }

const Material* Scene::findMaterial(const std::string& name) const {
    const auto found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    return found == materials.end() ? nullptr : &*found;
}

Id addObject(Scene& scene, Object item) { return addItem(scene, scene.objects, std::move(item)); }
Id addLight(Scene& scene, Light item) { return addItem(scene, scene.lights, std::move(item)); }
Id addMaterial(Scene& scene, Material item) { return addItem(scene, scene.materials, std::move(item)); }

template <class T>
std::string uniqueName(const CowList<T>& list, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(list.begin(), list.end(), [&](const T& item) { return item.name == name; });
    };
    if (!taken(wanted))
        return wanted;
    const std::string base = stem(wanted);
    for (int number = 2;; ++number) {
        std::string name = base + " " + std::to_string(number);
        if (!taken(name))
            return name;
    }
}

template std::string uniqueName(const CowList<Object>&, const std::string&);
template std::string uniqueName(const CowList<Light>&, const std::string&);
template std::string uniqueName(const CowList<Material>&, const std::string&);

DBounds worldBounds(const Scene& scene) {
    DBounds bounds;
    for (const Object& object : scene.objects)
        if (object.visible)
            bounds.add(worldBounds(object));
    return bounds;
}

Camera frameBounds(Camera camera, const DBounds& bounds, double aspect) {
    if (bounds.isEmpty())
        return camera;
    constexpr double margin = 1.1;
    const double radius = std::max(glm::length(bounds.extent()) * 0.5, 1e-9);
    const double halfFovY = glm::radians(camera.fovY) * 0.5;
    const double halfFovX = std::atan(std::tan(halfFovY) * aspect);
    const double distance = margin * radius / std::sin(std::min(halfFovX, halfFovY));
    const glm::dvec3 forward = frameOf(camera).forward;
    camera.target = bounds.centre();
    camera.position = camera.target - forward * distance;
    return camera;
}

} // namespace prizma
