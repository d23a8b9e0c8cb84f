#include "core/render/device_scene.h"

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
        return materials_.updateLights(context_, scene, anchor);
    case Stage::Poses:
        return poser_.pose(context_, scene, stage.objects, state.poses);
    case Stage::VertexShader:
        return poser_.shadeVertices(context_, kernels_, geometry_);
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
