#pragma once

#include "core/scene/bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace prizma {

/// Four floats that the compiler keeps in one vector register on every target (GCC and Clang).
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

// Written so that one instruction comes out on x86 (minps, maxps). Not a number in `a` gives `b`.
inline Float4 minOf(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline Float4 maxOf(Float4 a, Float4 b) {
    return a > b ? a : b;
}

inline Float4 splat(float value) {
    return Float4{value, value, value, value};
}

/// A box in two vector registers; the fourth lanes mean nothing.
struct Box4 {
    Float4 low = splat(std::numeric_limits<float>::infinity());
    Float4 high = splat(-std::numeric_limits<float>::infinity());

    /// Ignores lanes that are not a number.
    void add(Float4 pointLow, Float4 pointHigh) {
        low = minOf(pointLow, low);
        high = maxOf(pointHigh, high);
    }
    static Box4 of(const Bounds& box) {
        return {Float4{box.low.x, box.low.y, box.low.z, 0.0f},
                Float4{box.high.x, box.high.y, box.high.z, 0.0f}};
    }

    void add(const Box4& other) { add(other.low, other.high); }

    Bounds bounds() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// x·y + y·z + z·x of an extent.
inline float halfAreaOf(Float4 extent) {
    const Float4 products = extent * __builtin_shufflevector(extent, extent, 1, 2, 0, 3);
    return products[0] + products[1] + products[2];
}

/// A power of two that brings the box's extents to about one, so that their products neither overflow nor
/// vanish.
inline float areaScale(const Box4& box) {
    const Float4 halfExtent = box.high * 0.5f - box.low * 0.5f;
    const float largest = std::max({halfExtent[0], halfExtent[1], halfExtent[2]});
    if (!(largest > 0.0f))
        return 1.0f;
    return std::ldexp(1.0f, std::clamp(-std::ilogb(largest), -126, 126));
}

/// Half the surface of a box after scaling.
inline float scaledHalfArea(const Box4& box, float scale) {
    return halfAreaOf(box.high * scale - box.low * scale);
}

} // namespace prizma
