#include "core/reference/thesis_triangle.h"

#include <cmath>

namespace prizma::reference {
namespace {

constexpr float smallestCosine = 0.001f;
constexpr float smallestDistance = 0.001f;
constexpr float largestWeightSum = 1.0001f;

/// "The point is on the good side" of the edge: both normals lie within 90 degrees.
bool isInside(const glm::vec3& from, const glm::vec3& to, const glm::vec3& point, const glm::vec3& normal) {
    return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0f;
}

float area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return 0.5f * glm::length(glm::cross(b - a, c - a));
}

} // namespace

std::optional<ThesisHit> intersectAsInThesis(const glm::vec3& origin, const glm::vec3& direction,
                                             const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const float cosine = glm::dot(-normal, direction);
    if (!(std::abs(cosine) > smallestCosine))
        return std::nullopt;
    ThesisHit hit;
    hit.t = glm::dot(origin - a, normal) / cosine;
    if (!(hit.t >= smallestDistance))
        return std::nullopt;
    hit.point = origin + direction * hit.t;
    if (!isInside(a, b, hit.point, normal) || !isInside(b, c, hit.point, normal) ||
        !isInside(c, a, hit.point, normal))
        return std::nullopt;
    const float whole = area(a, b, c);
    hit.u = area(hit.point, b, c) / whole;
    hit.v = area(hit.point, c, a) / whole;
    hit.w = area(hit.point, a, b) / whole;
    return hit.u + hit.v + hit.w <= largestWeightSum ? std::optional(hit) : std::nullopt;
}

} // namespace prizma::reference
