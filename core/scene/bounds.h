#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace prizma {

/// An axis-aligned box; empty until something was added.
template <class Vector>
struct BasicBounds {
    using Scalar = typename Vector::value_type;

    Vector low{std::numeric_limits<Scalar>::infinity()};
    Vector high{-std::numeric_limits<Scalar>::infinity()};

    bool isEmpty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    Vector centre() const { return (low + high) * Scalar(0.5); }
    Vector extent() const { return isEmpty() ? Vector(0) : high - low; }

    void add(const Vector& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const BasicBounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }

    /// Half of the surface area; 0 for an empty box.
    Scalar halfArea() const {
        const Vector e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }

    friend bool operator==(const BasicBounds&, const BasicBounds&) = default;
};

using Bounds = BasicBounds<glm::vec3>;
using DBounds = BasicBounds<glm::dvec3>;

} // namespace prizma
