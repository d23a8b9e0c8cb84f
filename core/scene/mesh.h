#pragma once

#include "core/scene/bounds.h"
#include "core/scene/skeleton.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace prizma {

/// A shape that a mesh can be blended towards (a flex of the Source engine): how far the vertices it moves go
/// at weight 1, in object space.
struct MorphTarget {
    std::string name;
    std::vector<std::uint32_t> vertices;    ///< The moved vertices, ascending.
    std::vector<glm::vec3> positionOffsets; ///< One a moved vertex.
    std::vector<glm::vec3> normalOffsets;   ///< One a moved vertex; the sum is to be normalised.
};

/// Triangles in object space (for a skinned mesh: the bind pose). Never changed once shared.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< One a vertex, unit length.
    std::vector<glm::vec2> texCoords; ///< One a vertex, or empty. (0, 0) is the picture's bottom left corner.

    std::vector<glm::uvec3> triangles;        ///< Vertex indices, counter-clockwise seen from outside.
    std::vector<std::uint32_t> triangleSlots; ///< One a triangle: which material slot.
    std::vector<std::string> slots;           ///< Names of the material slots; at least one.

    SkeletonPtr skeleton; ///< Null for a rigid mesh.
    /// Influences of vertex i: influences[firstInfluence[i] .. firstInfluence[i + 1]). Both empty for a rigid
    /// mesh.
    std::vector<std::uint32_t> firstInfluence;
    std::vector<BoneInfluence> influences;

    std::vector<MorphTarget> morphTargets;

    Bounds bounds; ///< Of all positions.

    bool isSkinned() const { return skeleton && !influences.empty(); }
    bool canBePosed() const { return isSkinned() || !morphTargets.empty(); }
};

using MeshPtr = std::shared_ptr<const Mesh>;

/// What is wrong with `mesh`, or an empty string: arrays of unequal length, indices out of range, values that
/// are not finite. Every mesh that enters the scene has passed this.
std::string findFault(const Mesh& mesh);

/// Fills in `bounds`.
void updateBounds(Mesh& mesh);

} // namespace prizma
