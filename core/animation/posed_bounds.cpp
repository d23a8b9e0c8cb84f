#include "core/animation/posed_bounds.h"

#include "core/animation/pose.h"
#include "core/scene/hierarchy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace prizma {
namespace {

constexpr std::size_t grain = 2048; // vertices a task at least

std::vector<glm::vec3> morphedPositions(const Mesh& mesh, const std::vector<double>& weights) {
    std::vector<glm::vec3> positions = mesh.positions;
    for (std::size_t t = 0; t < weights.size(); ++t) {
        const MorphTarget& target = mesh.morphTargets[t];
        const auto weight = static_cast<float>(weights[t]);
        if (weight != 0.0f)
            for (std::size_t i = 0; i < target.vertices.size(); ++i)
                positions[target.vertices[i]] += weight * target.positionOffsets[i];
    }
    return positions;
}

Bounds boundsOf(const std::vector<glm::vec3>& positions) {
    Bounds bounds;
    for (const glm::vec3& position : positions)
        bounds.add(position);
    return bounds;
}

glm::vec3 skinned(const Mesh& mesh, const std::vector<glm::mat4>& matrices, std::size_t vertex,
                  const glm::vec3& position) {
    const std::uint32_t first = mesh.firstInfluence[vertex];
    const std::uint32_t end = mesh.firstInfluence[vertex + 1];
    if (first == end)
        return position;
    glm::vec4 sum(0.0f);
    for (std::uint32_t i = first; i < end; ++i)
        sum += mesh.influences[i].weight * (matrices[mesh.influences[i].bone] * glm::vec4(position, 1.0f));
    return glm::vec3(sum);
}

Bounds merged(Bounds a, const Bounds& b) {
    a.add(b);
    return a;
}

} // namespace

Bounds posedBounds(const Mesh& mesh, const PoseKey& key) {
    const bool morphs = !key.morphWeights.empty();
    const std::vector<glm::vec3> morphed =
        morphs ? morphedPositions(mesh, key.morphWeights) : std::vector<glm::vec3>();
    const std::vector<glm::vec3>& positions = morphs ? morphed : mesh.positions;
    if (!mesh.isSkinned())
        return morphs ? boundsOf(positions) : mesh.bounds;
    const auto matrices = skinningMatrices(*mesh.skeleton, evaluatePose(*mesh.skeleton, key));
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, positions.size(), grain), Bounds(),
        [&](const auto& range, Bounds bounds) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                bounds.add(skinned(mesh, matrices, i, positions[i]));
            return bounds;
        },
        merged);
}

DBounds worldBounds(const Object& object, const glm::dmat4& toWorld, double seconds) {
    if (!object.mesh)
        return {};
    return transformed(isPosed(object) ? posedBounds(*object.mesh, poseKeyOf(object, seconds))
                                       : object.mesh->bounds,
                       toWorld);
}

DBounds worldBounds(const Scene& scene, const Object& object) {
    return worldBounds(object, worldMatrix(scene, object), scene.timeline.seconds());
}

DBounds worldBounds(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    DBounds bounds;
    for (const Object& object : scene.objects)
        if (hierarchy.isShown(object))
            bounds.add(worldBounds(object, hierarchy.worldMatrix(object), scene.timeline.seconds()));
    return bounds;
}

} // namespace prizma
