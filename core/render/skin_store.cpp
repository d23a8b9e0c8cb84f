#include "core/render/skin_store.h"

#include <algorithm>

namespace prizma {
namespace {

/// All vertices' influences in fours, padded with weight 0, so that the device reads whole vectors and
/// branches once a four; `first` gets each vertex's first one, and the end.
std::vector<DeviceInfluenceQuad> quadsOf(const Mesh& mesh, std::vector<std::uint32_t>& first) {
    std::vector<DeviceInfluenceQuad> quads;
    first.reserve(mesh.positions.size() + 1);
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        first.push_back(static_cast<std::uint32_t>(quads.size()));
        const std::uint32_t end = mesh.firstInfluence[vertex + 1];
        for (std::uint32_t i = mesh.firstInfluence[vertex]; i < end; i += 4) {
            DeviceInfluenceQuad quad{};
            for (std::uint32_t k = 0; k < std::min(end - i, 4u); ++k) {
                quad.bone[k] = mesh.influences[i + k].bone;
                quad.weight[k] = mesh.influences[i + k].weight;
            }
            quads.push_back(quad);
        }
    }
    first.push_back(static_cast<std::uint32_t>(quads.size()));
    return quads;
}

/// The offsets of all morph targets vertex by vertex, so that each vertex gathers its own.
std::vector<DeviceMorphOffset> offsetsOf(const Mesh& mesh, std::vector<std::uint32_t>& first) {
    first.assign(mesh.positions.size() + 1, 0);
    for (const MorphTarget& target : mesh.morphTargets)
        for (const std::uint32_t vertex : target.vertices)
            ++first[vertex + 1];
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<DeviceMorphOffset> offsets(first.back());
    std::vector<std::uint32_t> next = first;
    for (std::uint32_t t = 0; t < mesh.morphTargets.size(); ++t) {
        const MorphTarget& target = mesh.morphTargets[t];
        for (std::size_t i = 0; i < target.vertices.size(); ++i) {
            const glm::vec3& p = target.positionOffsets[i];
            const glm::vec3& n = target.normalOffsets[i];
            offsets[next[target.vertices[i]]++] = {{p.x, p.y, p.z}, t, {n.x, n.y, n.z}, 0};
        }
    }
    return offsets;
}

/// Bind pose and places, with one more vertex that ends the last one's lists.
std::vector<DeviceSkinVertex> verticesOf(const Mesh& mesh, const SkinPlace& place,
                                         const std::vector<std::uint32_t>& firstQuad,
                                         const std::vector<std::uint32_t>& firstOffset) {
    std::vector<DeviceSkinVertex> vertices(mesh.positions.size() + 1);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i].firstQuad = place.quadBase + firstQuad[i];
        vertices[i].firstOffset = place.offsetBase + firstOffset[i];
        if (i == mesh.positions.size())
            break;
        for (int axis = 0; axis < 3; ++axis) {
            vertices[i].position[axis] = mesh.positions[i][axis];
            vertices[i].normal[axis] = mesh.normals[i][axis];
        }
    }
    return vertices;
}

} // namespace

Result<SkinPlace> SkinStore::add(Context& context, const Mesh& mesh) {
    std::vector<std::uint32_t> firstQuad(mesh.positions.size() + 1, 0);
    std::vector<std::uint32_t> firstOffset;
    std::vector<DeviceInfluenceQuad> quads;
    if (mesh.isSkinned()) {
        firstQuad.clear();
        quads = quadsOf(mesh, firstQuad);
    }
    const std::vector<DeviceMorphOffset> offsets = offsetsOf(mesh, firstOffset);
    SkinPlace place;
    const auto quadBase = quads_.add(context, quads);
    if (!quadBase)
        return std::unexpected(quadBase.error());
    place.quadBase = *quadBase;
    place.quads = quads.size();
    const auto offsetBase = offsets_.add(context, offsets);
    if (!offsetBase) {
        release(place);
        return std::unexpected(offsetBase.error());
    }
    place.offsetBase = *offsetBase;
    place.offsets = offsets.size();
    const auto vertexBase = vertices_.add(context, verticesOf(mesh, place, firstQuad, firstOffset));
    if (!vertexBase) {
        release(place);
        return std::unexpected(vertexBase.error());
    }
    place.vertexBase = *vertexBase;
    place.vertices = mesh.positions.size() + 1;
    return place;
}

void SkinStore::release(const SkinPlace& place) {
    vertices_.release(place.vertexBase, place.vertices);
    quads_.release(place.quadBase, place.quads);
    offsets_.release(place.offsetBase, place.offsets);
}

Result<void> SkinStore::ensure(Context& context) {
    if (auto ok = vertices_.ensure(context); !ok)
        return ok;
    if (auto ok = quads_.ensure(context); !ok)
        return ok;
    return offsets_.ensure(context);
}

} // namespace prizma
