#include "core/scene/starter_scene.h"

#include "core/animation/posed_bounds.h"
#include "core/scene/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prizma {
namespace {

/// From the middle of what is shown: `azimuth` turns from the front (+Z) to the right (+X).
glm::dvec3 towards(double azimuthDegrees, double elevationDegrees) {
    const double azimuth = glm::radians(azimuthDegrees);
    const double elevation = glm::radians(elevationDegrees);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

/// A point light that gives a white diffuse surface at `centre` the radiance `radiance`.
Light pointLight(const std::string& name, const glm::dvec3& centre, const glm::dvec3& offset, double radiance,
                 const glm::dvec3& color) {
    Light light;
    light.name = name;
    light.position = centre + offset;
    light.color = color;
    light.intensity = radiance * std::numbers::pi * glm::dot(offset, offset);
    return light;
}

} // namespace

void addThreeLights(Scene& scene, const DBounds& bounds) {
    const DBounds shown = bounds.isEmpty() ? DBounds{{-1, -1, -1}, {1, 1, 1}} : bounds;
    const glm::dvec3 centre = shown.centre();
    // Far enough away that the near side of the model is not much brighter than the far side.
    const double distance = 5.0 * std::max(glm::length(shown.extent()) * 0.5, 1e-6);
    addLight(scene, pointLight("key", centre, towards(-35, 45) * distance, 0.8, {1.0, 0.97, 0.92}));
    addLight(scene, pointLight("fill", centre, towards(65, 18) * distance, 0.22, {0.86, 0.92, 1.0}));
    addLight(scene, pointLight("rim", centre, towards(155, 40) * distance, 0.4, {1.0, 1.0, 1.0}));
}

Scene makeStarterScene() {
    Scene scene;
    Material floor;
    floor.name = "ground";
    floor.baseColor = glm::dvec3(0.45);
    floor.specular = 0.0;
    Object ground;
    ground.name = "ground";
    ground.source.primitive = PrimitiveType::Plane;
    ground.source.size = 10.0;
    ground.mesh = makePrimitive(ground.source.primitive, ground.source.size);
    ground.materials = {addMaterial(scene, floor)};
    ground.transform.translation.y = -0.001; // models that stand on y = 0 do not share a plane with it
    addObject(scene, ground);
    addThreeLights(scene, {{-1, 0, -1}, {1, 2, 1}});
    scene.camera.target = {0.0, 0.5, 0.0};
    scene.camera.position = scene.camera.target + towards(25, 18) * 6.5;
    return scene;
}

void presentModel(Scene& scene, double aspect) {
    const DBounds bounds = worldBounds(scene);
    addThreeLights(scene, bounds);
    scene.background.color = {0.06, 0.065, 0.075};
    scene.camera.position = scene.camera.target + towards(25, 15);
    scene.camera = frameBounds(scene.camera, bounds, aspect);
}

} // namespace prizma
