#include "core/render/device_scene.h"

#include <algorithm>

namespace prizma {

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
        return lights_.updateLights(context_, scene, anchor);
    case Stage::NewTrees:
        return replaceTrees(stage, trees, state);
    case Stage::Poses:
        return poser_.pose(context_, scene, stage.objects, state.poses);
    case Stage::VertexShader:
        return poser_.shadeVertices(context_, kernels_, geometry_);
    case Stage::TriangleShader:
        return refitter_.shadeTriangles(context_, kernels_, geometry_, stage.objects);
    case Stage::RefitTreeShader:
        return refit(stage, trees);
    case Stage::TopLevel:
        return updateTopLevel(scene, anchor);
    case Stage::LightTree:
        return lights_.updateTree(context_, scene, instances_, anchor);
    case Stage::Background:
        return lights_.updateBackground(context_, scene);
    default:
        return {};
    }
}

Result<void> DeviceScene::updateTopLevel(const Scene& scene, const glm::dvec3& anchor) {
    if (auto ok = instances_.update(context_, scene, geometry_, materials_, anchor); !ok)
        return ok;
    return lights_.updateInstances(context_, instances_);
}

Result<void> DeviceScene::refit(const PlannedStage& stage, TreeStore& trees) {
    if (auto ok = refitter_.refit(context_, kernels_, geometry_, stage.objects); !ok)
        return ok;
    return renewTrees_ ? wornTrees_.watch(context_, geometry_, stage.objects, trees) : Result<void>{};
}

Result<void> DeviceScene::replaceTrees(const PlannedStage& stage, TreeStore& trees, DeviceState& state) {
    for (const Id id : stage.objects) {
        if (auto ok = wornTrees_.replace(context_, geometry_, id, trees); !ok)
            return ok;
        state.newTrees.erase(id);
    }
    return {};
}

std::set<Id> DeviceScene::newTrees(TreeStore& trees, std::vector<MeshPtr>& inWork) {
    const std::set<Id> objects = wornTrees_.ready(geometry_, trees);
    for (const MeshPtr& mesh : wornTrees_.meshes())
        inWork.push_back(mesh);
    return objects;
}

double DeviceScene::treeWear() const {
    if (geometry_.posedPlaces().empty())
        return 1.0;
    double wear = 0.0;
    for (const auto& [id, posed] : geometry_.posedPlaces())
        wear = std::max(wear, posed.wear());
    return wear;
}

void DeviceScene::removeAllBut(const std::set<Id>& objects) {
    geometry_.removeAllBut(objects);
}

Result<void> DeviceScene::ensure() {
    if (auto ok = geometry_.ensure(context_); !ok)
        return ok;
    return lights_.ensure(context_);
}

void DeviceScene::setSceneArguments(Kernel& kernel) const {
    kernel.setArguments(instances_.topNodes(), instances_.count(), instances_.instances(), geometry_.nodes(),
                        geometry_.leaves(), geometry_.positions(), geometry_.normals(), geometry_.texCoords(),
                        geometry_.triangles(), instances_.slots(), materials_.materials(),
                        materials_.textures(), materials_.texels(), materials_.hasHoles() ? 1u : 0u);
    lights_.addArguments(kernel);
}

Result<std::vector<glm::vec3>> DeviceScene::posedPositions(Id object) const {
    return geometry_.readPosedPositions(context_, object);
}

Result<ObjectVertices> DeviceScene::vertices(Id object) const {
    return geometry_.readVertices(context_, object);
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

} // namespace prizma
