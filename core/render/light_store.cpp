#include "core/render/light_store.h"

#include "core/render/environment_table.h"
#include "core/render/light_tree.h"
#include "core/scene/hierarchy.h"
#include "core/scene/srgb.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double pi = glm::pi<double>();

void store(float (&target)[3], const glm::dvec3& value) {
    for (int i = 0; i < 3; ++i)
        target[i] = static_cast<float>(value[i]);
}

glm::vec3 load(const float (&source)[3]) {
    return {source[0], source[1], source[2]};
}

glm::dvec3 unitOrDown(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? v / length : glm::dvec3(0.0, -1.0, 0.0);
}

double strengthOf(const Light& light) {
    switch (light.type) {
    case LightType::Point:
    case LightType::Spot:
        return light.intensity;
    case LightType::Directional:
        return light.irradiance;
    case LightType::Rectangle:
    case LightType::Sphere:
        return light.radiance;
    }
    return 0.0;
}

double areaOf(const Light& light) {
    if (light.type == LightType::Rectangle)
        return light.size.x * light.size.y;
    return light.type == LightType::Sphere ? light.radius : 1.0;
}

/// Lights that are on and give light. Those without an area, or beyond what floats reach, give none.
bool shines(const Light& light, const glm::dvec3& anchor) {
    constexpr double furthest = 1e15;
    const glm::dvec3 strength = light.color * strengthOf(light);
    const double area = areaOf(light);
    return light.enabled && (strength.x > 0.0 || strength.y > 0.0 || strength.z > 0.0) &&
           std::isfinite(glm::dot(strength, glm::dvec3(1.0))) && area > 0.0 && area < furthest * furthest &&
           glm::length(light.position - anchor) < furthest;
}

DeviceLight deviceLight(const Light& light, const glm::dvec3& anchor) {
    DeviceLight out{};
    out.type = static_cast<std::uint32_t>(light.type);
    store(out.position, light.position - anchor);
    store(out.strength, light.color * strengthOf(light));
    glm::dvec3 direction = unitOrDown(light.direction);
    if (light.type == LightType::Rectangle) {
        const glm::dquat rotation = glm::normalize(light.rotation);
        direction = rotation * glm::dvec3(0.0, -1.0, 0.0);
        store(out.halfU, rotation * glm::dvec3(light.size.x * 0.5, 0.0, 0.0));
        store(out.halfV, rotation * glm::dvec3(0.0, 0.0, light.size.y * 0.5));
    }
    store(out.direction, direction);
    const double outer = std::max(light.outerAngle, light.innerAngle);
    out.cosInner = static_cast<float>(std::cos(glm::radians(light.innerAngle)));
    out.cosOuter = static_cast<float>(std::cos(glm::radians(outer)));
    out.radius = static_cast<float>(light.radius);
    out.visible = light.visible ? 1 : 0;
    return out;
}

/// How much of each colour there is; the eye's weights would leave blue lights to chance.
float brightness(const float (&strength)[3]) {
    return (std::max(strength[0], 0.0f) + std::max(strength[1], 0.0f) + std::max(strength[2], 0.0f)) / 3.0f;
}

LightBounds rectangleBounds(const DeviceLight& light) {
    const glm::vec3 reach = glm::abs(load(light.halfU)) + glm::abs(load(light.halfV));
    LightBounds bounds;
    bounds.box = {-reach, reach};
    bounds.power =
        brightness(light.strength) * 4.0f * glm::length(load(light.halfU)) * glm::length(load(light.halfV));
    bounds.normals = {load(light.direction), 0.0f};
    bounds.isMet = true;
    return bounds;
}

LightBounds sphereBounds(const DeviceLight& light) {
    LightBounds bounds;
    bounds.box = {glm::vec3(-light.radius), glm::vec3(light.radius)};
    bounds.power = brightness(light.strength) * static_cast<float>(pi) * light.radius * light.radius;
    bounds.isMet = true;
    return bounds;
}

LightBounds spotBounds(const DeviceLight& light) {
    constexpr float margin = 1e-3f; // radians; rounding must not dim the cone's edge
    LightBounds bounds;
    bounds.box = {glm::vec3(0.0f), glm::vec3(0.0f)};
    bounds.power = brightness(light.strength);
    bounds.normals = {load(light.direction), std::acos(std::clamp(light.cosInner, -1.0f, 1.0f)) + margin};
    bounds.emission =
        std::acos(std::clamp(light.cosOuter, -1.0f, 1.0f)) - bounds.normals.angle + 2.0f * margin;
    return bounds;
}

/// As the tree sees a light that is not directional.
LightBounds boundsOf(const DeviceLight& light) {
    LightBounds bounds;
    if (light.type == PRIZMA_LIGHT_RECTANGLE) {
        bounds = rectangleBounds(light);
    } else if (light.type == PRIZMA_LIGHT_SPHERE) {
        bounds = sphereBounds(light);
    } else if (light.type == PRIZMA_LIGHT_SPOT) {
        bounds = spotBounds(light);
    } else {
        bounds.box = {glm::vec3(0.0f), glm::vec3(0.0f)};
        bounds.power = brightness(light.strength);
    }
    const glm::vec3 place = load(light.position);
    const glm::vec3 margin =
        light.type == PRIZMA_LIGHT_RECTANGLE || light.type == PRIZMA_LIGHT_SPHERE
            ? (glm::abs(place) + bounds.box.high) * 1e-6f // what rounding may have moved its edge by
            : glm::vec3(0.0f);
    bounds.box = {place + bounds.box.low - margin, place + bounds.box.high + margin};
    bounds.power = std::max(bounds.power, 1e-30f);
    return bounds;
}

/// Mean of all channels, as the emission's factor.
double textureMean(const Image& image) {
    double sum = 0.0;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = image.bytes.empty() ? static_cast<double>(image.floats[4 * i + c])
                                                     : decodeSrgb(image.bytes[4 * i + c] / 255.0);
            sum += std::isfinite(value) ? std::max(value, 0.0) : 0.0;
        }
    return count > 0 ? sum / (3.0 * static_cast<double>(count)) : 0.0;
}

} // namespace

Result<void> LightStore::updateLights(Context& context, const Scene& scene, const glm::dvec3& anchor) {
    table_.clear();
    for (const Light& light : lightsInWorld(scene))
        if (shines(light, anchor))
            table_.push_back(deviceLight(light, anchor));
    return lights_.assign(context, table_, "lights");
}

double LightStore::meanOf(const ImagePtr& image) {
    const auto [found, isNew] = textureMeans_.try_emplace(image, 0.0);
    if (isNew)
        found->second = textureMean(*image);
    return found->second;
}

Result<void> LightStore::updateTree(Context& context, const Scene& scene, const InstanceStore& instances,
                                    const glm::dvec3& anchor) {
    objects_ = emissiveObjects(scene);
    std::erase_if(textureMeans_, [&](const auto& entry) {
        return std::ranges::none_of(objects_, [&](const EmissiveObject& object) {
            return std::ranges::count(object.slots, entry.first, &EmissiveObject::Slot::texture) > 0;
        });
    });
    const Emitters emitters =
        collectEmitters(objects_, anchor, [this](const ImagePtr& image) { return meanOf(image); });
    std::vector<LightBounds> bounds;
    std::vector<std::uint32_t> treeLights; // places in the table
    for (std::uint32_t i = 0; i < lightCount(); ++i)
        if (table_[i].type != PRIZMA_LIGHT_DIRECTIONAL) {
            bounds.push_back(boundsOf(table_[i]));
            treeLights.push_back(i);
        }
    bounds.insert(bounds.end(), emitters.bounds.begin(), emitters.bounds.end());
    LightTree tree = buildLightTree(bounds);
    for (DeviceLightNode& node : tree.nodes)
        if ((node.child & PRIZMA_LEAF_BIT) != 0) {
            const std::uint32_t leaf = node.child & ~PRIZMA_LEAF_BIT;
            const auto lights = static_cast<std::uint32_t>(treeLights.size());
            node.child = PRIZMA_LEAF_BIT | (leaf < lights ? treeLights[leaf] : lightCount() + leaf - lights);
        }
    set_.nodeCount = static_cast<std::uint32_t>(tree.nodes.size());
    set_.emitterCount = static_cast<std::uint32_t>(emitters.triangles.size());
    if (auto ok = nodes_.assign(context, tree.nodes, "light tree"); !ok)
        return ok;
    if (auto ok = emitters_.assign(context, emitters.triangles, "emissive triangles"); !ok)
        return ok;
    if (auto ok = uploadLeaves(context, tree.leafOf, treeLights, emitters); !ok)
        return ok;
    if (auto ok = updateInstances(context, instances); !ok)
        return ok;
    return updateFarLights(context);
}

Result<void> LightStore::uploadLeaves(Context& context, const std::vector<std::uint32_t>& leafOf,
                                      const std::vector<std::uint32_t>& treeLights,
                                      const Emitters& emitters) {
    leafBases_.clear();
    std::size_t size = table_.size();
    for (const EmissiveObject& object : objects_) {
        leafBases_.push_back(static_cast<std::uint32_t>(size));
        size += object.mesh->triangles.size();
    }
    std::vector<std::uint32_t> leaves(size, PRIZMA_NO_HIT);
    for (std::size_t i = 0; i < treeLights.size(); ++i)
        leaves[treeLights[i]] = leafOf[i];
    for (std::size_t i = 0; i < emitters.triangles.size(); ++i) {
        const DeviceEmitter& emitter = emitters.triangles[i];
        leaves[leafBases_[emitter.object] + emitter.primitive] = leafOf[treeLights.size() + i];
    }
    return emitterLeaves_.assign(context, leaves, "light tree's leaves");
}

Result<void> LightStore::updateInstances(Context& context, const InstanceStore& instances) {
    std::vector<std::uint32_t> table;
    if (!objects_.empty()) {
        table.assign(instances.count() + objects_.size(), PRIZMA_NO_HIT);
        std::map<Id, std::uint32_t> instanceOf;
        for (std::uint32_t i = 0; i < instances.count(); ++i)
            instanceOf[instances.objectOf(i)] = i;
        for (std::size_t k = 0; k < objects_.size(); ++k)
            if (const auto found = instanceOf.find(objects_[k].id); found != instanceOf.end()) {
                table[found->second] = leafBases_[k];
                table[instances.count() + k] = found->second;
            }
    }
    if (table == indexTable_)
        return {};
    indexTable_ = std::move(table);
    return emitterIndex_.assign(context, indexTable_, "emissive objects");
}

Result<void> LightStore::updateBackground(Context& context, const Scene& scene) {
    const Background& background = scene.background;
    constexpr double checkerboardMean = 0.5; // about; it stands in for a picture that is missing
    if (environmentImage_ != background.image.image) {
        environmentImage_ = background.image.image;
        const EnvironmentTable table =
            environmentImage_ ? makeEnvironmentTable(*environmentImage_) : EnvironmentTable{};
        set_.environmentWidth = table.width;
        set_.environmentHeight = table.height;
        environmentMean_ = table.mean;
        if (auto ok = environment_.assign(context, table.cumulative, "background's table"); !ok)
            return ok;
    }
    double mean = glm::dot(glm::max(background.color, glm::dvec3(0.0)), glm::dvec3(1.0 / 3.0));
    if (background.image.isSet())
        mean = environmentImage_ ? environmentMean_ : checkerboardMean;
    const double irradiance = pi * mean * background.intensity;
    backgroundIrradiance_ = std::isfinite(irradiance) && irradiance > 0.0 ? std::max(irradiance, 1e-30) : 0.0;
    return updateFarLights(context);
}

Result<void> LightStore::updateFarLights(Context& context) {
    std::vector<DeviceFarLight> lights;
    std::vector<double> irradiances;
    for (std::uint32_t i = 0; i < lightCount(); ++i)
        if (table_[i].type == PRIZMA_LIGHT_DIRECTIONAL) {
            lights.push_back({0.0f, 0.0f, i});
            irradiances.push_back(std::max(static_cast<double>(brightness(table_[i].strength)), 1e-30));
        }
    if (backgroundIrradiance_ > 0.0) {
        lights.push_back({0.0f, 0.0f, PRIZMA_CHOICE_BACKGROUND});
        irradiances.push_back(backgroundIrradiance_);
    }
    double sum = 0.0;
    for (const double irradiance : irradiances)
        sum += irradiance;
    // A half goes by the estimates, a half evenly: what is faint on the whole may be all there is in a
    // shadow.
    double end = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double begin = end;
        end += 0.5 * irradiances[i] / sum + 0.5 / static_cast<double>(lights.size());
        lights[i].end = i + 1 == lights.size() ? 1.0f : static_cast<float>(end);
        lights[i].probability = lights[i].end - static_cast<float>(i == 0 ? 0.0 : begin);
    }
    set_.farCount = static_cast<std::uint32_t>(lights.size());
    set_.farIrradiance = static_cast<float>(std::min(sum, 1e30));
    return farLights_.assign(context, lights, "directional lights");
}

void LightStore::addArguments(Kernel& kernel) const {
    kernel.addArgument(lights_);
    kernel.addArgument(lightCount());
    kernel.addArgument(nodes_);
    kernel.addArgument(emitters_);
    kernel.addArgument(emitterIndex_);
    kernel.addArgument(emitterLeaves_);
    kernel.addArgument(farLights_);
    kernel.addArgument(environment_);
    kernel.addArgument(set_);
}

Result<void> LightStore::ensure(Context& context) {
    Result<void> ok;
    const auto make = [&](auto& buffer, const char* what) {
        if (ok)
            ok = buffer.reserve(context, 1, what);
    };
    make(lights_, "lights");
    make(nodes_, "light tree");
    make(emitters_, "emissive triangles");
    make(emitterIndex_, "emissive objects");
    make(emitterLeaves_, "light tree's leaves");
    make(farLights_, "directional lights");
    make(environment_, "background's table");
    return ok;
}

} // namespace prizma
