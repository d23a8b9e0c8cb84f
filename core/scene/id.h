#pragma once

#include <cstdint>

namespace prizma {

/// Names an object, light or material for as long as its scene lives; never used again after it was removed.
using Id = std::uint64_t;

inline constexpr Id noId = 0;

} // namespace prizma
