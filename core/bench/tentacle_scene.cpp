#include "core/bench/tentacle_scene.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace prizma::bench {
namespace {

constexpr int bones = 60;
constexpr int rings = 501;
constexpr int segments = 100; // (rings - 1) * segments * 2 triangles
constexpr int frames = 60;
constexpr float boneLength = 0.1f;
constexpr float length = bones * boneLength;

float radiusAt(float share) {
    return 0.35f * (1.0f - 0.8f * share);
}

/// The four bones next to a height along the tube, by a cubic B-spline: weights are smooth and sum to 1.
void addInfluences(Mesh& mesh, float height) {
    const float place = std::clamp(height / boneLength - 0.5f, 0.0f, static_cast<float>(bones - 1));
    const int before = static_cast<int>(place);
    const float t = place - static_cast<float>(before);
    const float s = 1.0f - t;
    const std::array weights{s * s * s / 6.0f, (3 * t * t * t - 6 * t * t + 4) / 6.0f,
                             (3 * s * s * s - 6 * s * s + 4) / 6.0f, t * t * t / 6.0f};
    for (int i = 0; i < 4; ++i)
        mesh.influences.push_back({static_cast<std::uint32_t>(std::clamp(before - 1 + i, 0, bones - 1)),
                                   weights[static_cast<std::size_t>(i)]});
    mesh.firstInfluence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
}

SkeletonPtr makeSkeleton() {
    auto skeleton = std::make_shared<Skeleton>();
    for (int i = 0; i < bones; ++i) {
        Bone bone{"bone " + std::to_string(i), i - 1, {}, glm::mat4(1.0f)};
        bone.bind.translation.y = i == 0 ? 0.0f : boneLength;
        bone.inverseBind[3].y = -static_cast<float>(i) * boneLength;
        skeleton->bones.push_back(bone);
    }
    return skeleton;
}

MeshPtr makeTentacle() {
    auto mesh = std::make_shared<Mesh>();
    mesh->slots = {"skin"};
    mesh->firstInfluence = {0};
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const float share = static_cast<float>(ring) / (rings - 1);
            const float angle = static_cast<float>(segment) / segments * glm::two_pi<float>();
            const glm::vec3 outward(std::cos(angle), 0.0f, std::sin(angle));
            mesh->positions.push_back(outward * radiusAt(share) + glm::vec3(0, share * length, 0));
            mesh->normals.push_back(outward);
            addInfluences(*mesh, share * length);
        }
    for (int ring = 0; ring + 1 < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const auto low = static_cast<std::uint32_t>(ring * segments);
            const auto a = low + static_cast<std::uint32_t>(segment);
            const auto b = low + static_cast<std::uint32_t>((segment + 1) % segments);
            mesh->triangles.emplace_back(a, a + segments, b);
            mesh->triangles.emplace_back(b, a + segments, b + segments);
        }
    mesh->triangleSlots.assign(mesh->triangles.size(), 0);
    mesh->skeleton = makeSkeleton();
    updateBounds(*mesh);
    return mesh;
}

ClipPtr makeClip() {
    auto clip = std::make_shared<Clip>();
    clip->name = "writhe";
    clip->frameCount = frames;
    for (int bone = 0; bone < bones; ++bone) {
        BoneTrack track{bone, {}};
        for (int frame = 0; frame < frames; ++frame) {
            const float phase = static_cast<float>(frame) / frames * glm::two_pi<float>();
            const float along = static_cast<float>(bone) * 0.2f;
            const glm::quat turn = glm::angleAxis(0.08f * std::sin(phase + along), glm::vec3(0, 0, 1)) *
                                   glm::angleAxis(0.06f * std::cos(phase - along), glm::vec3(1, 0, 0));
            track.frames.push_back({{0.0f, bone == 0 ? 0.0f : boneLength, 0.0f}, turn, glm::vec3(1.0f)});
        }
        clip->tracks.push_back(std::move(track));
    }
    return clip;
}

} // namespace

Scene makeTentacleScene() {
    Scene scene;
    Object object;
    object.name = "tentacle";
    object.mesh = makeTentacle();
    object.dynamic = true;
    object.clips = {makeClip()};
    object.clip = object.clips.front()->name;
    object.materials = {noId};
    addObject(scene, std::move(object));
    return scene;
}

} // namespace prizma::bench
