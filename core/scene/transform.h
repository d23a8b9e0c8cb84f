#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace prizma {

/// Object space to world space: scale, then rotate, then translate. Double precision, because worlds are
/// large.
struct Transform {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< (w, x, y, z) in GLM's constructor; normalised when used.
    glm::dvec3 scale{1.0};

    glm::dmat4 matrix() const;

    friend bool operator==(const Transform&, const Transform&) = default;
};

/// Degrees about X, then Y, then Z (the matrix is Rz·Ry·Rx), as people type rotations, and back.
glm::dvec3 eulerDegrees(const glm::dquat& rotation);
glm::dquat rotationFromEulerDegrees(const glm::dvec3& degrees);

} // namespace prizma
