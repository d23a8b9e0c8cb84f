#include "core/reference/reference_light.h"

#include "core/reference/reference_texture.h"

#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prizma::reference {
namespace {

constexpr double pi = std::numbers::pi;

/// 1 up to the inner angle, 0 from the outer one on, smooth in the cosine.
double spotShare(const Light& light, const glm::dvec3& travels) {
    const double inner = std::cos(glm::radians(light.innerAngle));
    const double outer = std::cos(glm::radians(std::max(light.outerAngle, light.innerAngle)));
    const double cosine = glm::dot(travels, glm::normalize(light.direction));
    if (cosine >= inner)
        return 1.0;
    if (cosine <= outer)
        return 0.0;
    return glm::smoothstep(outer, inner, cosine);
}

/// Radiant intensity, without the light's colour, towards `travels`.
double intensityTowards(const Light& light, const glm::dvec3& travels) {
    switch (light.type) {
    case LightType::Point:
        return light.intensity;
    case LightType::Spot:
        return light.intensity * spotShare(light, travels);
    case LightType::Rectangle: {
        const glm::dvec3 faces = glm::normalize(light.rotation) * glm::dvec3(0.0, -1.0, 0.0);
        return light.radiance * light.size.x * light.size.y * std::max(glm::dot(faces, travels), 0.0);
    }
    case LightType::Sphere:
        return light.radiance * pi * light.radius * light.radius;
    case LightType::Directional:
        break;
    }
    return 0.0;
}

/// Where the ray meets the light's own shape.
std::optional<double> meet(const Light& light, const Ray& ray) {
    // In the light's axes, in which a rectangle lies in y = 0 and faces -y.
    const glm::dquat toLight = glm::conjugate(glm::normalize(light.rotation));
    const glm::dvec3 origin = toLight * (ray.origin - light.position);
    const glm::dvec3 direction = toLight * ray.direction;
    if (light.type == LightType::Rectangle) {
        const double t = -origin.y / direction.y;
        const glm::dvec3 place = origin + direction * t;
        const bool isMet = direction.y > 0.0 && t > ray.tMin && std::abs(place.x) <= light.size.x / 2.0 &&
                           std::abs(place.z) <= light.size.y / 2.0;
        return isMet ? std::optional(t) : std::nullopt;
    }
    if (light.type != LightType::Sphere)
        return std::nullopt;
    // |origin + t direction|² = radius²
    const double a = glm::dot(direction, direction);
    const double b = glm::dot(origin, direction);
    const double discriminant = b * b - a * (glm::dot(origin, origin) - light.radius * light.radius);
    if (discriminant < 0.0)
        return std::nullopt;
    for (const double t : {(-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a})
        if (t > ray.tMin)
            return t;
    return std::nullopt;
}

} // namespace

std::optional<SeenLight> nearestLight(std::span<const Light> lights, const Ray& ray, double end,
                                      bool fromCamera) {
    std::optional<SeenLight> nearest;
    for (const Light& light : lights) {
        const glm::dvec3 radiance = light.color * light.radiance;
        if (!light.enabled || (fromCamera && !light.visible) || !(glm::compMax(radiance) > 0.0))
            continue;
        const auto t = meet(light, ray);
        if (t && *t < (nearest ? nearest->t : end))
            nearest = SeenLight{*t, radiance};
    }
    return nearest;
}

std::optional<ArrivingLight> lightAt(const Light& light, const glm::dvec3& position) {
    if (!light.enabled)
        return std::nullopt;
    if (light.type == LightType::Directional)
        return ArrivingLight{-glm::normalize(light.direction), 1e300, light.color * light.irradiance};
    const glm::dvec3 way = light.position - position;
    const double distance = glm::length(way);
    if (distance == 0.0)
        return std::nullopt;
    const glm::dvec3 direction = way / distance;
    return ArrivingLight{direction, distance,
                         light.color * (intensityTowards(light, -direction) / (distance * distance))};
}

glm::dvec3 backgroundRadiance(const Background& background, const glm::dvec3& direction) {
    if (!background.image.image)
        return background.color * background.intensity;
    const Image& image = *background.image.image;
    // The picture's middle looks along -Z and is turned about +Y, counter-clockwise from above.
    const double turn = glm::radians(background.rotation);
    const double azimuth = std::atan2(direction.x, -direction.z) + turn;
    const double height = std::atan2(direction.y, std::hypot(direction.x, direction.z));
    // Around it repeats; beyond the poles there is nothing to go on with.
    const double halfRow = 0.5 / image.height;
    const glm::dvec2 place(0.5 + azimuth / (2.0 * pi), std::clamp(0.5 + height / pi, halfRow, 1.0 - halfRow));
    return glm::dvec3(sampleImage(image, place, Reading::Color)) * background.intensity;
}

glm::dvec3 meanBackground(const Background& background) {
    if (!background.image.image)
        return background.color * background.intensity;
    const Image& image = *background.image.image;
    glm::dvec3 sum(0.0);
    double whole = 0.0;
    for (int row = 0; row < image.height; ++row) {
        const double weight = std::sin((row + 0.5) / image.height * pi);
        for (int column = 0; column < image.width; ++column)
            sum += weight * glm::dvec3(sampleImage(
                                image, {(column + 0.5) / image.width, 1.0 - (row + 0.5) / image.height},
                                Reading::Color));
        whole += weight * image.width;
    }
    return sum / whole * background.intensity;
}

} // namespace prizma::reference
