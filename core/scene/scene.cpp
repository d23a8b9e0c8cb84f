#include "core/scene/scene.h"

#include <algorithm>
#include <charconv>
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

const Object* Scene::findObject(Id id) const {
    return findById(objects, id);
}
const Light* Scene::findLight(Id id) const {
    return findById(lights, id);
}
const Material* Scene::findMaterial(Id id) const {
    return findById(materials, id);
}

const Shader* Scene::findShader(Id id) const {
    return findById(shaders, id);
}

const Material* Scene::findMaterial(const std::string& name) const {
    const auto found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    return found == materials.end() ? nullptr : &*found;
}

Id addObject(Scene& scene, Object item) {
    return addItem(scene, scene.objects, std::move(item));
}
Id addLight(Scene& scene, Light item) {
    return addItem(scene, scene.lights, std::move(item));
}
Id addMaterial(Scene& scene, Material item) {
    return addItem(scene, scene.materials, std::move(item));
}
Id addShader(Scene& scene, Shader item) {
    return addItem(scene, scene.shaders, std::move(item));
}

template <class T>
std::string uniqueName(const CowList<T>& list, const std::string& wanted) {
    if (std::none_of(list.begin(), list.end(), [&](const T& item) { return item.name == wanted; }))
        return wanted;
    const std::string start = stem(wanted) + ' ';
    std::vector<bool> taken(list.size() + 3, false); // numbers; one of them is free
    for (const T& item : list) {
        if (!item.name.starts_with(start))
            continue;
        const char* const first = item.name.data() + start.size();
        const char* const end = item.name.data() + item.name.size();
        std::size_t number = 0;
        const auto read = std::from_chars(first, end, number);
        if (read.ec == std::errc{} && read.ptr == end && *first != '0' && number < taken.size())
            taken[number] = true;
    }
    const auto free = std::find(taken.begin() + 2, taken.end(), false);
    return start + std::to_string(free - taken.begin());
}

template std::string uniqueName(const CowList<Object>&, const std::string&);
template std::string uniqueName(const CowList<Light>&, const std::string&);
template std::string uniqueName(const CowList<Material>&, const std::string&);
template std::string uniqueName(const CowList<Shader>&, const std::string&);
template std::string uniqueName(const CowList<Group>&, const std::string&);

Camera frameBounds(Camera camera, const DBounds& bounds, double aspect) {
    if (bounds.isEmpty())
        return camera;
    constexpr double margin = 1.08;
    const CameraFrame frame = frameOf(camera);
    const double tanY = std::tan(glm::radians(camera.fovY) * 0.5) / margin;
    const double tanX = tanY * aspect;
    const glm::dvec3 half = bounds.extent() * 0.5;
    double distance = std::max(glm::length(half), 1e-9) * 0.1;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 toCorner{(corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                                  (corner & 4) != 0 ? half.z : -half.z};
        const double sideways = std::max(std::abs(glm::dot(toCorner, frame.right)) / tanX,
                                         std::abs(glm::dot(toCorner, frame.up)) / tanY);
        distance = std::max(distance, sideways - glm::dot(toCorner, frame.forward));
    }
    camera.target = bounds.centre();
    camera.position = camera.target - frame.forward * distance;
    return camera;
}

} // namespace prizma
