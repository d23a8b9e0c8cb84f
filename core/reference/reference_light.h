#pragma once

#include "core/reference/reference_tracer.h"
#include "core/scene/scene.h"

#include <optional>
#include <span>

namespace prizma::reference {

/// What a light sends to a point if nothing is in the way, all of it from one place.
struct ArrivingLight {
    glm::dvec3 direction{0.0};  ///< Unit, towards the light.
    double distance = 0.0;      ///< 1e300: from infinitely far.
    glm::dvec3 irradiance{0.0}; ///< On a surface that faces the light.
};

/// Rectangles and spheres send from their centre what they would from far: radiance times the area that is
/// seen from there. Nothing for lights that are off, and at the light itself.
std::optional<ArrivingLight> lightAt(const Light& light, const glm::dvec3& position);

/// A light that is seen itself.
struct SeenLight {
    double t = 0.0; ///< In lengths of the ray's direction.
    glm::dvec3 radiance{0.0};
};

/// The nearest rectangle (from its front) or sphere that the ray meets before `end`. `fromCamera`: lights
/// that are not `visible` are left out. The lights are in world space (lightsInWorld).
std::optional<SeenLight> nearestLight(std::span<const Light> lights, const Ray& ray, double end,
                                      bool fromCamera);

/// Radiance from outside the scene.
glm::dvec3 backgroundRadiance(const Background& background, const glm::dvec3& direction);

/// Its mean over all directions.
glm::dvec3 meanBackground(const Background& background);

} // namespace prizma::reference
