#include "core/render/light_bounds.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr float pi = glm::pi<float>();

/// Angle between unit vectors; exact for neighbours.
float angleBetween(const glm::vec3& a, const glm::vec3& b) {
    return 2.0f * std::atan2(glm::length(a - b), glm::length(a + b));
}

} // namespace

Cone unite(const Cone& a, const Cone& b) {
    if (a.angle >= pi || (b.angle == a.angle && b.axis == a.axis))
        return a;
    if (b.angle >= pi)
        return b;
    const float between = angleBetween(a.axis, b.axis);
    if (between + b.angle <= a.angle)
        return a;
    if (between + a.angle <= b.angle)
        return b;
    const float angle = 0.5f * (a.angle + between + b.angle);
    const glm::vec3 across = b.axis - a.axis * glm::dot(a.axis, b.axis);
    const float length = glm::length(across);
    if (angle >= pi || length < 1e-6f)
        return angle >= pi ? Cone{} : Cone{a.axis, std::min(between + std::max(a.angle, b.angle), pi)};
    const float turn = angle - a.angle;
    return {glm::normalize(a.axis * std::cos(turn) + across * (std::sin(turn) / length)), angle};
}

LightBounds unite(LightBounds a, const LightBounds& b) {
    if (b.power == 0.0f)
        return a;
    if (a.power == 0.0f)
        return b;
    a.box.add(b.box);
    Cone other = b.normals;
    if (a.twoSided && b.twoSided && glm::dot(a.normals.axis, other.axis) < 0.0f)
        other.axis = -other.axis;
    a.normals = unite(a.normals, other);
    a.emission = std::max(a.emission, b.emission);
    a.power += b.power;
    a.twoSided = a.twoSided || b.twoSided;
    a.moves = a.moves || b.moves;
    a.isMet = a.isMet || b.isMet;
    return a;
}

float orientationMeasure(const LightBounds& bounds) {
    const float cone = bounds.moves ? pi : bounds.normals.angle;
    const float reach = std::min(cone + bounds.emission, pi);
    const float sine = std::sin(cone);
    const float measure = 2.0f * pi * (1.0f - std::cos(cone)) +
                          glm::half_pi<float>() * (2.0f * reach * sine - std::cos(cone - 2.0f * reach) -
                                                   2.0f * cone * sine + std::cos(cone));
    return bounds.twoSided ? std::min(2.0f * measure, 4.0f * pi) : measure;
}

} // namespace prizma
