#include "core/scene/camera.h"

#include <cmath>

namespace prizma {
namespace {

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& fallback) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? v / length : fallback;
}

} // namespace

CameraFrame frameOf(const Camera& camera) {
    const glm::dvec3 forward = unitOr(camera.target - camera.position, {0.0, 0.0, -1.0});
    glm::dvec3 side = glm::cross(forward, unitOr(camera.up, {0.0, 1.0, 0.0}));
    if (glm::length(side) < 1e-9) {
        // Looking along the up vector: take the axis that is furthest from the view instead.
        const glm::dvec3 other = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
        side = glm::cross(forward, other);
    }
    const glm::dvec3 right = glm::normalize(side);
    return {right, glm::cross(right, forward), forward};
}

double focusDistanceOf(const Camera& camera) {
    if (camera.focusDistance > 0.0)
        return camera.focusDistance;
    const double distance = glm::length(camera.target - camera.position);
    return distance > 0.0 ? distance : 1.0;
}

} // namespace prizma
