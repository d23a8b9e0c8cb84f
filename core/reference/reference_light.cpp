#include "core/reference/reference_light.h"

#include "core/reference/reference_texture.h"

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

} // namespace

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
