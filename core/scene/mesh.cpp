#include "core/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace prizma {
namespace {

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string findSkinningFault(const Mesh& mesh) {
    if (!mesh.isSkinned())
        return {};
    if (mesh.firstInfluence.size() != mesh.positions.size() + 1)
        return "the list of bone weights does not match the number of vertices";
    if (mesh.firstInfluence.front() != 0 || mesh.firstInfluence.back() != mesh.influences.size() ||
        !std::is_sorted(mesh.firstInfluence.begin(), mesh.firstInfluence.end()))
        return "the list of bone weights is out of order";
    const auto boneCount = mesh.skeleton->bones.size();
    for (const BoneInfluence& influence : mesh.influences)
        if (influence.bone >= boneCount || !std::isfinite(influence.weight))
            return "a vertex is bound to a bone that does not exist";
    for (std::size_t i = 0; i < boneCount; ++i)
        if (mesh.skeleton->bones[i].parent >= static_cast<int>(i))
            return "a bone comes before its parent";
    return {};
}

std::string findMorphFault(const MorphTarget& target, std::size_t vertexCount) {
    if (target.positionOffsets.size() != target.vertices.size() ||
        target.normalOffsets.size() != target.vertices.size())
        return "a morph target's offsets do not match the vertices it moves";
    if (std::ranges::adjacent_find(target.vertices, std::ranges::greater_equal{}) != target.vertices.end())
        return "a morph target's vertices are out of order";
    if (!target.vertices.empty() && target.vertices.back() >= vertexCount)
        return "a morph target moves a vertex that does not exist";
    if (!std::all_of(target.positionOffsets.begin(), target.positionOffsets.end(), isFinite) ||
        !std::all_of(target.normalOffsets.begin(), target.normalOffsets.end(), isFinite))
        return "a morph target's offset is not a finite number";
    return {};
}

} // namespace

std::string findFault(const Mesh& mesh) {
    const auto vertexCount = mesh.positions.size();
    if (mesh.triangles.empty())
        return "there are no triangles in it";
    if (mesh.normals.size() != vertexCount)
        return "the number of normals does not match the number of vertices";
    if (!mesh.texCoords.empty() && mesh.texCoords.size() != vertexCount)
        return "the number of texture coordinates does not match the number of vertices";
    if (mesh.triangleSlots.size() != mesh.triangles.size() || mesh.slots.empty())
        return "the triangles have no materials";
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), isFinite))
        return "a vertex position is not a finite number";
    for (const glm::uvec3& t : mesh.triangles)
        if (t.x >= vertexCount || t.y >= vertexCount || t.z >= vertexCount)
            return "a triangle refers to a vertex that does not exist";
    for (const std::uint32_t slot : mesh.triangleSlots)
        if (slot >= mesh.slots.size())
            return "a triangle refers to a material that does not exist";
    for (const MorphTarget& target : mesh.morphTargets)
        if (std::string fault = findMorphFault(target, vertexCount); !fault.empty())
            return fault;
    return findSkinningFault(mesh);
}

void updateBounds(Mesh& mesh) {
    mesh.bounds = {};
    for (const glm::vec3& position : mesh.positions)
        mesh.bounds.add(position);
}

} // namespace prizma
