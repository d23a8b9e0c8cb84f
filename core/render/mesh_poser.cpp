#include "core/render/mesh_poser.h"

#include "core/animation/pose.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace prizma {
namespace {

constexpr std::size_t groupSize = 64;
constexpr std::size_t fewBones = 256; ///< Evaluated faster than other threads are woken: about 30 µs.

} // namespace

Result<void> MeshPoser::pose(Context& context, const Scene& scene, const std::vector<Id>& objects,
                             std::map<Id, PoseKey>& poses) {
    std::vector<const Object*> posed;
    std::vector<PoseKey> keys;
    std::uint32_t bones = 0;
    parts_.clear();
    weights_.clear();
    for (const Id id : objects) {
        const Object& object = *scene.findObject(id);
        PoseKey key = poseKeyOf(object, scene.timeline.seconds());
        Part part{id, bones, PRIZMA_NO_WEIGHTS};
        if (object.mesh->isSkinned())
            bones += static_cast<std::uint32_t>(object.mesh->skeleton->bones.size());
        if (!key.morphWeights.empty()) {
            part.weightBase = static_cast<std::uint32_t>(weights_.size());
            for (const double weight : key.morphWeights)
                weights_.push_back(static_cast<float>(weight));
        }
        posed.push_back(&object);
        keys.push_back(std::move(key));
        parts_.push_back(part);
    }
    matrices_.resize(bones);
    const auto evaluate = [&](std::size_t i) {
        const Mesh& mesh = *posed[i]->mesh;
        if (mesh.isSkinned())
            std::ranges::copy(skinningMatrices(*mesh.skeleton, evaluatePose(*mesh.skeleton, keys[i])),
                              matrices_.begin() + parts_[i].boneBase);
    };
    if (bones <= fewBones)
        for (std::size_t i = 0; i < posed.size(); ++i)
            evaluate(i);
    else
        tbb::parallel_for(std::size_t{0}, posed.size(), evaluate);
    if (auto ok = deviceMatrices_.assign(context, matrices_, "pose"); !ok)
        return ok;
    if (auto ok = deviceWeights_.assign(context, weights_, "morph weights"); !ok)
        return ok;
    for (std::size_t i = 0; i < objects.size(); ++i)
        poses[objects[i]] = std::move(keys[i]);
    return {};
}

Result<void> MeshPoser::loadBlocks(Context& context, const GeometryStore& geometry) {
    if (parts_ == blocksOf_ && blocksRevision_ == geometry.posedRevision())
        return {};
    blocksOf_.clear(); // should the upload fail
    std::vector<DeviceVertexBlock> blocks;
    for (const Part& part : parts_) {
        const ObjectPlace place = geometry.placeOf(part.object);
        const auto count = static_cast<std::uint32_t>(place.mesh->mesh->positions.size());
        for (std::uint32_t first = 0; first < count; first += PRIZMA_VERTICES_A_BLOCK)
            blocks.push_back({place.mesh->skin.vertexBase + first, place.posed->vertexBase + first,
                              std::min(count - first, PRIZMA_VERTICES_A_BLOCK), part.boneBase,
                              part.weightBase});
    }
    if (auto ok = blocks_.assign(context, blocks, "list of vertices"); !ok)
        return ok;
    blockCount_ = blocks.size();
    blocksOf_ = parts_;
    blocksRevision_ = geometry.posedRevision();
    return {};
}

Result<void> MeshPoser::shadeVertices(Context& context, KernelSet& kernels, const GeometryStore& geometry) {
    if (auto ok = loadBlocks(context, geometry); !ok)
        return ok;
    const SkinStore& skins = geometry.skins();
    Kernel& kernel = kernels.vertexShader;
    kernel.setArguments(geometry.positions(), geometry.normals(), blocks_, skins.vertices(), skins.quads(),
                        skins.offsets(), deviceMatrices_, deviceWeights_);
    if (const auto launched = kernel.launch(context, blockCount_ * groupSize, groupSize); !launched)
        return std::unexpected(launched.error());
    return {};
}

} // namespace prizma
