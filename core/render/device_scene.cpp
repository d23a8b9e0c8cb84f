#include "core/render/device_scene.h"

#include "core/animation/pose.h"

namespace prizma {
namespace {

constexpr std::size_t geometryGroupSize = 64;

std::size_t leafPlaces(const DeviceTree& tree) {
    return tree.layout == TreeLayout::Wide8 ? tree.wideLeaves.size() * 8 : tree.binaryTriangles.size();
}

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
        return shadeTriangles(stage);
    case Stage::RefitTreeShader:
        return refit(stage);
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

Result<void> DeviceScene::shadeTriangles(const PlannedStage& stage) {
    for (const Id id : stage.objects) {
        const ObjectPlace place = geometry_.placeOf(id);
        const auto places = static_cast<std::uint32_t>(leafPlaces(*place.mesh->tree));
        Kernel& kernel = kernels_.triangleShader;
        kernel.setArguments(geometry_.leaves(), place.posed->leafBase, places, geometry_.triangles(),
                            place.mesh->triangleBase, geometry_.positions(), place.posed->vertexBase);
        if (const auto launched = kernel.launch(context_, places, geometryGroupSize); !launched)
            return std::unexpected(launched.error());
    }
    return {};
}

Result<void> DeviceScene::refit(const PlannedStage& stage) {
    // Levels of all objects concatenated: one launch a level, however many objects move.
    std::vector<DeviceRefitEntry> entries;
    std::vector<std::size_t> levelEnds;
    for (std::size_t level = 0;; ++level) {
        const std::size_t before = entries.size();
        for (const Id id : stage.objects) {
            const ObjectPlace place = geometry_.placeOf(id);
            const auto& levels = place.mesh->tree->refitLevels;
            if (level < levels.size())
                for (const std::uint32_t node : levels[level])
                    entries.push_back({node, place.posed->nodeBase, place.posed->leafBase});
        }
        if (entries.size() == before)
            break;
        levelEnds.push_back(entries.size());
    }
    if (auto ok = refitEntries_.assign(context_, entries, "refit levels"); !ok)
        return ok;
    std::size_t first = 0;
    for (const std::size_t end : levelEnds) {
        Kernel& kernel = kernels_.refitTreeShader;
        kernel.setArguments(geometry_.nodes(), geometry_.leaves(), refitEntries_,
                            static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first));
        if (const auto launched = kernel.launch(context_, end - first, geometryGroupSize); !launched)
            return std::unexpected(launched.error());
        first = end;
    }
    return readRootBounds(stage);
}

Result<void> DeviceScene::readRootBounds(const PlannedStage& stage) {
    std::vector<std::uint32_t> roots;
    for (const Id id : stage.objects)
        roots.push_back(geometry_.placeOf(id).posed->nodeBase);
    if (auto ok = roots_.assign(context_, roots, "roots"); !ok)
        return ok;
    if (auto ok = rootBounds_.reserve(context_, 6 * roots.size(), "bounds"); !ok)
        return ok;
    Kernel& kernel = kernels_.gatherRootBounds;
    kernel.setArguments(geometry_.nodes(), roots_, rootBounds_, static_cast<std::uint32_t>(roots.size()));
    if (const auto launched = kernel.launch(context_, roots.size(), geometryGroupSize); !launched)
        return std::unexpected(launched.error());
    std::vector<float> values(6 * roots.size());
    if (auto ok = rootBounds_.read(context_, values, 0, "bounds"); !ok)
        return ok;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const float* v = &values[6 * i];
        geometry_.posedPlaceOf(stage.objects[i])->bounds = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
    }
    return {};
}

} // namespace prizma
