#pragma once

#include "core/compute/device.h"
#include "core/render/offline_render.h"
#include "core/scene/primitives.h"
#include "core/scene/scene.h"

#include <QtGlobal>

#include <glm/gtc/constants.hpp>

#include <memory>
#include <random>

namespace prizma::test {

/// An object of a primitive with one material.
inline Object primitiveObject(PrimitiveType type, double size, Id material, const glm::dvec3& place = {}) {
    Object object;
    object.name = "object";
    object.source.primitive = type;
    object.source.size = size;
    object.mesh = makePrimitive(type, size);
    object.materials.assign(object.mesh->slots.size(), material);
    object.transform.translation = place;
    return object;
}

/// White, purely diffuse.
inline Material lambert(double albedo = 1.0) {
    Material material;
    material.name = "lambert";
    material.baseColor = glm::dvec3(albedo);
    material.specular = 0.0;
    material.roughness = 1.0;
    return material;
}

/// A cylinder along Y that two bones bend: vertices below the middle follow the first, above the second, with
/// a smooth transition; one clip, "bend", turns the second bone back and forth about Z.
inline MeshPtr makeBendingMesh() {
    auto mesh = std::make_shared<Mesh>(*makePrimitive(PrimitiveType::Cylinder, 2.0));
    auto skeleton = std::make_shared<Skeleton>();
    Bone root{"root", -1, {}, glm::mat4(1.0f)};
    Bone tip{"tip", 0, {{0.0f, 0.25f, 0.0f}, glm::quat(1, 0, 0, 0), glm::vec3(1.0f)}, glm::mat4(1.0f)};
    tip.inverseBind[3] = glm::vec4(0.0f, -0.25f, 0.0f, 1.0f);
    skeleton->bones = {root, tip};
    mesh->skeleton = skeleton;
    mesh->firstInfluence = {0};
    for (const glm::vec3& position : mesh->positions) {
        const float share = glm::smoothstep(-0.6f, 0.6f, position.y);
        mesh->influences.push_back({0, 1.0f - share});
        mesh->influences.push_back({1, share});
        mesh->firstInfluence.push_back(static_cast<std::uint32_t>(mesh->influences.size()));
    }
    return mesh;
}

inline ClipPtr makeBendClip() {
    auto clip = std::make_shared<Clip>();
    clip->name = "bend";
    clip->fps = 10.0;
    clip->frameCount = 20;
    BoneTrack track{1, {}};
    for (int i = 0; i < clip->frameCount; ++i) {
        const float angle = 0.9f * std::sin(static_cast<float>(i) / 20.0f * glm::two_pi<float>());
        track.frames.push_back(
            {{0.0f, 0.25f, 0.0f}, glm::angleAxis(angle, glm::vec3(0, 0, 1)), glm::vec3(1.0f)});
    }
    clip->tracks.push_back(track);
    return clip;
}

/// A Dynamic object with that mesh and clip.
inline Object bendingObject() {
    Object object;
    object.name = "bender";
    object.mesh = makeBendingMesh();
    object.materials.assign(object.mesh->slots.size(), noId);
    object.dynamic = true;
    object.clips = {makeBendClip()};
    object.clip = "bend";
    return object;
}

/// A renderer, or null if there is no device. One that is there but does not work is a fault, not a skip.
inline std::unique_ptr<Renderer> makeRenderer(RendererOptions options) {
    if (listDevices().empty())
        return nullptr;
    auto made = Renderer::create(std::move(options));
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(*made);
}

/// The default device's renderer, or null if there is no device.
inline std::unique_ptr<Renderer> makeRenderer(std::optional<TreeLayout> layout = std::nullopt) {
    RendererOptions options;
    options.layout = layout;
    return makeRenderer(std::move(options));
}

/// A picture of the scene; rendering that fails, or a pixel that is no number, ends the test program.
inline OfflinePicture renderPicture(Renderer& renderer, const Scene& scene, int width, int height) {
    OfflineOptions options;
    options.width = width;
    options.height = height;
    auto picture = renderOffline(renderer, scene, options);
    if (!picture)
        qFatal("%s", picture.error().message.c_str());
    if (picture->nonFinitePixels != 0)
        qFatal("%u pixels are not finite", static_cast<unsigned>(picture->nonFinitePixels));
    return std::move(*picture);
}

/// Linear radiance of one pixel.
inline glm::dvec3 pixelOf(const OfflinePicture& picture, int x, int y) {
    const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(x));
    return {picture.radiance[i], picture.radiance[i + 1], picture.radiance[i + 2]};
}

} // namespace prizma::test
