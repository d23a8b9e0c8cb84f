#include "core/render/emissive_objects.h"

#include "core/animation/pose_key.h"
#include "core/render/render_plan.h"

#include <cmath>
#include <unordered_map>

namespace prizma {
namespace {

using Slot = EmissiveObject::Slot;

constexpr float leastPower = 1e-30f;

std::unordered_map<Id, Slot> shiningMaterials(const Scene& scene) {
    std::unordered_map<Id, Slot> shining;
    for (const Material& material : scene.materials) {
        const glm::dvec3 radiance = glm::max(material.emission * material.emissionStrength, glm::dvec3(0.0));
        const double sum = glm::dot(radiance, glm::dvec3(1.0));
        if (sum > 0.0 && std::isfinite(sum))
            shining[material.id] = {radiance, material.emissionTexture.image,
                                    material.doubleSided || material.transmission != 0.0};
    }
    return shining;
}

/// The box of a triangle as floats, wider than rounding can have moved its corners.
Bounds boxOf(const std::array<glm::dvec3, 3>& corners) {
    Bounds box;
    for (const glm::dvec3& corner : corners)
        box.add(glm::vec3(corner));
    const glm::vec3 margin = glm::max(glm::abs(box.low), glm::abs(box.high)) * 1e-6f;
    return {box.low - margin, box.high + margin};
}

class Collector {
  public:
    Collector(const glm::dvec3& anchor, const std::function<double(const ImagePtr&)>& meanOf)
        : anchor_(anchor), meanOf_(meanOf) {}

    void add(const EmissiveObject& object, std::uint32_t index) {
        glm::dmat4 toAnchor = object.toWorld;
        toAnchor[3] -= glm::dvec4(anchor_, 0.0);
        const double determinant = glm::determinant(glm::dmat3(toAnchor));
        if (!std::isfinite(determinant) || determinant == 0.0)
            return; // such objects are not drawn
        std::vector<double> strengths;
        for (const Slot& slot : object.slots)
            strengths.push_back(slot.shines() ? strengthOf(slot) : 0.0);
        const DBounds whole = transformed(object.mesh->bounds, toAnchor);
        const Mesh& mesh = *object.mesh;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const std::uint32_t slot = mesh.triangleSlots[i];
            if (slot >= strengths.size() || !(strengths[slot] > 0.0))
                continue;
            std::array<glm::dvec3, 3> corners;
            for (int k = 0; k < 3; ++k)
                corners[static_cast<std::size_t>(k)] =
                    glm::dvec3(toAnchor * glm::dvec4(mesh.positions[mesh.triangles[i][k]], 1.0));
            LightBounds bounds = boundsOf(corners, determinant < 0.0, strengths[slot]);
            bounds.twoSided = object.slots[slot].bothSides;
            if (object.posed) {
                bounds.moves = true;
                bounds.box = {glm::vec3(whole.low), glm::vec3(whole.high)};
            }
            if (bounds.power > 0.0f || object.posed) {
                bounds.power = std::max(bounds.power, leastPower);
                out_.triangles.push_back({index, static_cast<std::uint32_t>(i)});
                out_.bounds.push_back(bounds);
            }
        }
    }

    Emitters take() { return std::move(out_); }

  private:
    double strengthOf(const Slot& slot) const {
        const double mean = slot.texture ? meanOf_(slot.texture) : 1.0;
        return glm::dot(slot.radiance, glm::dvec3(1.0 / 3.0)) * mean;
    }

    static LightBounds boundsOf(const std::array<glm::dvec3, 3>& corners, bool mirrored, double strength) {
        const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(across);
        LightBounds bounds;
        bounds.box = boxOf(corners);
        const double power = 0.5 * length * strength;
        if (!(power > 0.0) || !std::isfinite(power))
            return bounds;
        bounds.power = std::max(static_cast<float>(std::min(power, 1e30)), leastPower);
        bounds.normals = {glm::vec3(across * ((mirrored ? -1.0 : 1.0) / length)), 0.0f};
        return bounds;
    }

    const glm::dvec3 anchor_;
    const std::function<double(const ImagePtr&)>& meanOf_;
    Emitters out_;
};

} // namespace

std::vector<EmissiveObject> emissiveObjects(const Scene& scene) {
    std::vector<EmissiveObject> found;
    const auto shining = shiningMaterials(scene);
    if (shining.empty())
        return found;
    const Hierarchy hierarchy(scene);
    for (const Object& object : scene.objects) {
        if (!isDrawn(hierarchy, object))
            continue;
        EmissiveObject emissive{object.id, object.mesh, hierarchy.worldMatrix(object), isPosed(object), {}};
        emissive.slots.resize(std::min(object.materials.size(), object.mesh->slots.size()));
        bool shines = false;
        for (std::size_t i = 0; i < emissive.slots.size(); ++i)
            if (const auto material = shining.find(object.materials[i]); material != shining.end()) {
                emissive.slots[i] = material->second;
                shines = true;
            }
        if (shines)
            found.push_back(std::move(emissive));
    }
    return found;
}

Emitters collectEmitters(const std::vector<EmissiveObject>& objects, const glm::dvec3& anchor,
                         const std::function<double(const ImagePtr&)>& meanOf) {
    Collector collector(anchor, meanOf);
    for (std::size_t i = 0; i < objects.size(); ++i)
        collector.add(objects[i], static_cast<std::uint32_t>(i));
    return collector.take();
}

} // namespace prizma
