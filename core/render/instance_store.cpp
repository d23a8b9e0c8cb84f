#include "core/render/instance_store.h"

#include "core/render/render_plan.h"

#include <cmath>

namespace prizma {
namespace {

bool storeRows(float (&rows)[12], const glm::dmat4& matrix) {
    bool finite = true;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) {
            const auto value = static_cast<float>(matrix[column][row]);
            rows[4 * row + column] = value;
            finite = finite && std::isfinite(value);
        }
    return finite;
}

/// The box of a transformed box, grown by what rounding to float and the ray's transform may move it by.
Bounds conservativeBox(const Bounds& box, const glm::dmat4& toAnchor) {
    DBounds result;
    double magnitude = glm::length(glm::dvec3(toAnchor[3]));
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point{(corner & 1) != 0 ? box.high.x : box.low.x,
                               (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z, 1.0};
        const glm::dvec3 moved(toAnchor * point);
        magnitude = std::max(magnitude, glm::length(moved));
        result.add(moved);
    }
    constexpr double roundings = 16.0 * 5.96e-8;
    const glm::dvec3 margin(magnitude * roundings);
    return {glm::vec3(result.low - margin), glm::vec3(result.high + margin)};
}

} // namespace

void InstanceStore::append(const Object& object, const glm::dmat4& toWorld, const ObjectPlace& place,
                           const MaterialStore& materials, const glm::dvec3& anchor) {
    glm::dmat4 toAnchor = toWorld;
    toAnchor[3] -= glm::dvec4(anchor, 0.0);
    const double determinant = glm::determinant(glm::dmat3(toAnchor));
    if (!std::isfinite(determinant) || determinant == 0.0)
        return;
    DeviceInstance instance{};
    if (!storeRows(instance.objectToWorld, toAnchor) ||
        !storeRows(instance.worldToObject, glm::inverse(toAnchor)))
        return;
    const Mesh& mesh = *place.mesh->mesh;
    instance.nodeBase = place.posed ? place.posed->nodeBase : place.mesh->nodeBase;
    instance.leafBase = place.posed ? place.posed->leafBase : place.mesh->leafBase;
    instance.vertexBase = place.posed ? place.posed->vertexBase : place.mesh->vertexBase;
    instance.triangleBase = place.mesh->triangleBase;
    instance.slotBase = static_cast<std::uint32_t>(slotTable_.size());
    instance.hasTexCoords = mesh.texCoords.empty() ? 0u : 1u;
    for (std::size_t slot = 0; slot < mesh.slots.size(); ++slot)
        slotTable_.push_back(
            materials.indexOf(slot < object.materials.size() ? object.materials[slot] : noId));
    instanceTable_.push_back(instance);
    boxes_.push_back(conservativeBox(place.posed ? place.posed->bounds : mesh.bounds, toAnchor));
    objects_.push_back(object.id);
    triangleCount_ += mesh.triangles.size();
}

Result<void> InstanceStore::buildTop(Context& context) {
    Progress progress;
    BvhBuildOptions options;
    options.maxLeafSize = 1;
    const auto bvh = buildBvh(boxes_, options, progress);
    if (!bvh)
        return std::unexpected(bvh.error());
    const DeviceTree tree = layOutTopLevel(*bvh, layout_);
    if (layout_ == TreeLayout::Wide8)
        return wideNodes_.assign(context, tree.wideNodes, "top level");
    return binaryNodes_.assign(context, tree.binaryNodes, "top level");
}

Result<void> InstanceStore::update(Context& context, const Scene& scene, const GeometryStore& geometry,
                                   const MaterialStore& materials, const glm::dvec3& anchor) {
    instanceTable_.clear();
    slotTable_.clear();
    boxes_.clear();
    objects_.clear();
    triangleCount_ = 0;
    const Hierarchy hierarchy(scene);
    for (const Object& object : scene.objects)
        if (const ObjectPlace place = geometry.placeOf(object.id); isDrawn(hierarchy, object) && place.mesh)
            append(object, hierarchy.worldMatrix(object), place, materials, anchor);
    Bounds all;
    for (const Bounds& box : boxes_)
        all.add(box);
    radius_ = all.isEmpty() ? 1.0 : std::max(0.5 * static_cast<double>(glm::length(all.extent())), 1e-30);
    if (auto ok = instances_.assign(context, instanceTable_, "objects"); !ok)
        return ok;
    if (auto ok = slots_.assign(context, slotTable_, "material slots"); !ok)
        return ok;
    return buildTop(context);
}

cl_mem InstanceStore::topNodes() const {
    return layout_ == TreeLayout::Wide8 ? wideNodes_.get() : binaryNodes_.get();
}

} // namespace prizma
