#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace prizma::reference {

/// Where the thesis' test says that a ray meets a triangle.
struct ThesisHit {
    float t = 0.0f;
    glm::vec3 point{0.0f};
    float u = 0.0f, v = 0.0f, w = 0.0f; ///< Weights of A, B and C, by areas.
};

/// The ray/triangle test of the thesis (section 4.2.1), kept for comparison: the distance of the origin from
/// the triangle's plane, along the ray, the point there, and three cross products that say on which side of
/// each edge it lies. Single precision, with the absolute epsilons of the program that the thesis describes;
/// these make it lose grazing rays (|cos| <= 0.001), near hits (t < 0.001) and whatever is small, and
/// neighbouring triangles may both miss a ray through their common edge. `direction` has unit length.
std::optional<ThesisHit> intersectAsInThesis(const glm::vec3& origin, const glm::vec3& direction,
                                             const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

} // namespace prizma::reference
