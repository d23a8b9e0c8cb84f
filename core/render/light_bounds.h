#pragma once

#include "core/scene/bounds.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace prizma {

/// Directions within `angle` (radians) of a unit axis; pi: all of them.
struct Cone {
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    float angle = glm::pi<float>();
};

/// The smallest cone that holds both.
Cone unite(const Cone& a, const Cone& b);

/// Where one or several emitters are, how strong they are and which way they shine (Conty Estevez and Kulla
/// 2018).
struct LightBounds {
    Bounds box;
    float power = 0.0f;                     ///< Sum of the greatest radiant intensities.
    Cone normals;                           ///< Of all emitters.
    float emission = glm::half_pi<float>(); ///< How far from its normal an emitter shines, radians.
    bool twoSided = false;                  ///< Some emitter shines against its normal as well.
    bool moves = false; ///< Some emitter is posed: it may be anywhere, and shine anywhere.
    bool isMet = false; ///< Some emitter is met by rays without being a triangle.
};

LightBounds unite(LightBounds a, const LightBounds& b);

/// The orientation's part of the cost of a node: the solid angle that it shines into, weighted by the cosine.
float orientationMeasure(const LightBounds& bounds);

} // namespace prizma
