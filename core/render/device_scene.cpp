#include "core/render/device_scene.h"

#include "core/animation/pose.h"

namespace prizma {
namespace {

constexpr std::size_t geometryGroupSize = 64;

std::vector<float> boneRows(const std::vector<glm::mat4>& matrices) {
    std::vector<float> rows;
    rows.reserve(matrices.size() * 12);
    for (const glm::mat4& m : matrices)
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                rows.push_back(m[column][row]);
    return rows;
}

} // namespace

Result<void> DeviceScene::run(const PlannedStage& stage, const Scene& scene, const glm::dvec3& anchor,
                              TreeStore& trees, DeviceState& state) {
    switch (stage.stage) {
    case Stage::Geometry:
        return uploadGeometry(stage, scene, trees, state);
    case Stage::Textures:
        return materials_.updateTextures(context_, scene);
    case Stage::Materials:
        return materials_.updateMaterials(context_, scene);
    case Stage::Lights:
        return materials_.updateLights(context_, scene, anchor);
    case Stage::Poses:
        return pose(stage, scene, state);
    case Stage::VertexShader:
        return shadeVertices(stage);
    case Stage::TriangleShader:
        return refitter_.shadeTriangles(context_, kernels_, geometry_, stage.objects);
    case Stage::RefitTreeShader:
        return refitter_.refit(context_, kernels_, geometry_, stage.objects);
    case Stage::TopLevel:
        return instances_.update(context_, scene, geometry_, materials_, anchor);
    default:
        return {};
    }
}

void DeviceScene::removeAllBut(const std::set<Id>& objects) {
    geometry_.removeAllBut(objects);
    std::erase_if(bones_, [&](const auto& entry) { return !objects.contains(entry.first); });
}

Result<void> DeviceScene::ensure() {
    return geometry_.ensure(context_);
}

void DeviceScene::setSceneArguments(Kernel& kernel) const {
    kernel.setArguments(instances_.topNodes(), instances_.count(), instances_.instances(), geometry_.nodes(),
                        geometry_.leaves(), geometry_.positions(), geometry_.normals(), geometry_.texCoords(),
                        geometry_.triangles(), instances_.slots(), materials_.materials(),
                        materials_.textures(), materials_.texels(), materials_.lights(),
                        materials_.lightCount());
}

Result<std::vector<glm::vec3>> DeviceScene::posedPositions(Id object) const {
    return geometry_.readPosedPositions(context_, object);
}

Result<void> DeviceScene::uploadGeometry(const PlannedStage& stage, const Scene& scene, TreeStore& trees,
                                         DeviceState& state) {
    for (const Id id : stage.objects) {
        const Object* object = scene.findObject(id);
        const DeviceTreePtr tree = trees.request(object->mesh);
        if (!tree)
            return failure("The tree of \"" + object->name + "\" is not ready.");
        if (auto ok = geometry_.add(context_, *object, tree); !ok)
            return ok;
        state.resident.insert(id);
        state.poses.erase(id);
    }
    return {};
}

Result<void> DeviceScene::pose(const PlannedStage& stage, const Scene& scene, DeviceState& state) {
    for (const Id id : stage.objects) {
        const Object& object = *scene.findObject(id);
        const Skeleton& skeleton = *object.mesh->skeleton;
        PoseKey key = poseKeyOf(object, scene.timeline.seconds());
        const Pose pose = evaluatePose(skeleton, key);
        if (auto ok = bones_[id].assign(context_, boneRows(skinningMatrices(skeleton, pose)), "pose"); !ok)
            return ok;
        state.poses[id] = std::move(key);
    }
    return {};
}

Result<void> DeviceScene::shadeVertices(const PlannedStage& stage) {
    for (const Id id : stage.objects) {
        const ObjectPlace place = geometry_.placeOf(id);
        const auto count = static_cast<std::uint32_t>(place.mesh->mesh->positions.size());
        Kernel& kernel = kernels_.vertexShader;
        kernel.setArguments(geometry_.positions(), geometry_.normals(), place.mesh->vertexBase,
                            place.posed->vertexBase, count, geometry_.firstInfluences(),
                            place.mesh->firstInfluenceBase, geometry_.influences(), place.mesh->influenceBase,
                            bones_.at(id));
        if (const auto launched = kernel.launch(context_, count, geometryGroupSize); !launched)
            return std::unexpected(launched.error());
    }
    return {};
}

} // namespace prizma
