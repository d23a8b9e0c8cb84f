#pragma once

#include "core/scene/mesh.h"

#include <cstdint>
#include <vector>

namespace prizma {

inline constexpr std::uint32_t noSourceVertex = 0xFFFFFFFF;

/// Triangles as importers gather them: every corner has values of its own.
struct TriangleSoup {
    std::vector<glm::vec3> positions; ///< Three a triangle, as the next three.
    std::vector<glm::vec3> normals;   ///< Zero where the file has none.
    std::vector<glm::vec2> texCoords;
    /// Corners with different numbers stay different vertices even if all else is equal (they may be bound to
    /// other bones); noSourceVertex: nothing to keep apart.
    std::vector<std::uint32_t> sourceVertices;
    std::vector<std::uint32_t> slots; ///< One a triangle.
    bool hasTexCoords = false;

    void reserve(std::size_t triangles);
    std::size_t triangleCount() const { return slots.size(); }
};

/// A mesh and, for each of its vertices, the number of the source vertex it came from.
struct BuiltMesh {
    Mesh mesh; ///< Its slots' names are not filled in.
    std::vector<std::uint32_t> sourceVertices;
};

/// Joins equal corners into vertices. Normals that the soup lacks are averaged over the faces round a point
/// whose own normals differ by less than `creaseDegrees`, weighted by the angle each face has there.
BuiltMesh buildMesh(const TriangleSoup& soup, double creaseDegrees);

} // namespace prizma
