#include "core/render/worn_trees.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr int pauseFactor = 8; ///< At most a ninth of the time goes into building.

bool isFinite(const std::vector<glm::vec3>& positions) {
    return std::all_of(positions.begin(), positions.end(), [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

/// What a build needs of a mesh, in another pose.
MeshPtr posedMesh(const Mesh& mesh, std::vector<glm::vec3> positions) {
    auto posed = std::make_shared<Mesh>();
    posed->positions = std::move(positions);
    posed->triangles = mesh.triangles;
    return posed;
}

} // namespace

Result<void> WornTrees::watch(Context& context, const GeometryStore& geometry, const std::vector<Id>& objects,
                              TreeStore& trees) {
    for (const Id id : objects) {
        const ObjectPlace place = geometry.placeOf(id);
        // A wear that is no number comes of boxes too large for one: there is nothing to win then.
        if (!place.posed || !(place.posed->wear() > limit) || !std::isfinite(place.posed->wear()))
            continue;
        Renewal& renewal = renewals_[id];
        if (renewal.posed || Clock::now() < renewal.pausedUntil)
            continue;
        auto positions = geometry.readPosedPositions(context, id);
        if (!positions)
            return std::unexpected(positions.error());
        if (!isFinite(*positions)) // a build leaves such triangles out, and they may come back
            continue;
        renewal.posed = posedMesh(*place.mesh->mesh, std::move(*positions));
        renewal.worn = place.posed->tree;
        renewal.started = Clock::now();
        trees.request(renewal.posed);
    }
    return {};
}

std::set<Id> WornTrees::ready(const GeometryStore& geometry, TreeStore& trees) {
    std::erase_if(renewals_, [&](const auto& item) {
        const auto& [id, renewal] = item;
        const ObjectPlace place = geometry.placeOf(id);
        return !place.posed || (renewal.posed && place.posed->tree != renewal.worn);
    });
    std::set<Id> objects;
    for (const auto& [id, renewal] : renewals_)
        if (renewal.posed && trees.request(renewal.posed))
            objects.insert(id);
    return objects;
}

std::vector<MeshPtr> WornTrees::meshes() const {
    std::vector<MeshPtr> meshes;
    for (const auto& [id, renewal] : renewals_)
        if (renewal.posed)
            meshes.push_back(renewal.posed);
    return meshes;
}

Result<void> WornTrees::replace(Context& context, GeometryStore& geometry, Id object, TreeStore& trees) {
    const auto found = renewals_.find(object);
    if (found == renewals_.end() || !found->second.posed)
        return {};
    Renewal& renewal = found->second;
    const ObjectPlace place = geometry.placeOf(object);
    const DeviceTreePtr tree = trees.request(renewal.posed);
    if (tree && place.posed && place.posed->tree == renewal.worn)
        if (const auto replaced = geometry.replaceTree(context, object, tree); !replaced)
            return std::unexpected(replaced.error());
    renewal.pausedUntil = Clock::now() + pauseFactor * (Clock::now() - renewal.started);
    renewal.posed.reset();
    renewal.worn.reset();
    return {};
}

} // namespace prizma
