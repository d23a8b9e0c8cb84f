#include "core/scene/transform.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {

glm::dmat4 Transform::matrix() const {
    const double length = glm::length(rotation);
    const glm::dquat unit = length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
    return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(unit) *
           glm::scale(glm::dmat4(1.0), scale);
}

glm::dvec3 eulerDegrees(const glm::dquat& rotation) {
    const glm::dmat3 m = glm::mat3_cast(glm::normalize(rotation)); // m[column][row]
    const double sinY = std::clamp(-m[0][2], -1.0, 1.0);
    glm::dvec3 angles{0.0, std::asin(sinY), 0.0};
    if (std::abs(sinY) < 1.0 - 1e-12) {
        angles.x = std::atan2(m[1][2], m[2][2]);
        angles.z = std::atan2(m[0][1], m[0][0]);
    } else { // gimbal lock: X and Z turn about the same axis, give it all to X
        angles.x = std::atan2(-m[2][1], m[1][1]);
    }
    return glm::degrees(angles);
}

glm::dquat rotationFromEulerDegrees(const glm::dvec3& degrees) {
    const glm::dvec3 angles = glm::radians(degrees);
    return glm::angleAxis(angles.z, glm::dvec3(0, 0, 1)) * glm::angleAxis(angles.y, glm::dvec3(0, 1, 0)) *
           glm::angleAxis(angles.x, glm::dvec3(1, 0, 0));
}

} // namespace prizma
