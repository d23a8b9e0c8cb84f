#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace prizma {

/// Point `index` of the two-dimensional Sobol' sequence in [0, 1)², shifted so that the first point is the
/// middle: every power of two of points in a row is evenly spread.
glm::vec2 sobolPoint(std::uint32_t index);

} // namespace prizma
