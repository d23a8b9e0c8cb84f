#include "core/bench/deforming_scene.h"

#include "core/animation/pose.h"
#include "core/render/render_plan.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace prizma::bench {
namespace {

constexpr int bendFrames = 64;
constexpr float bendAngle = 0.1f; ///< Radians, to either side.

int longestAxis(const Bounds& bounds) {
    const glm::vec3 e = bounds.extent();
    return e.x >= e.y && e.x >= e.z ? 0 : (e.y >= e.z ? 1 : 2);
}

Bone boneAt(const std::string& name, int parent, const glm::vec3& place) {
    Bone bone{name, parent, {place, glm::quat(1, 0, 0, 0), glm::vec3(1.0f)}, glm::mat4(1.0f)};
    bone.inverseBind[3] = glm::vec4(-place, 1.0f);
    return bone;
}

MeshPtr bendingMesh(const Mesh& mesh) {
    auto result = std::make_shared<Mesh>(mesh);
    const int axis = longestAxis(mesh.bounds);
    auto skeleton = std::make_shared<Skeleton>();
    skeleton->bones = {boneAt("root", -1, glm::vec3(0.0f)), boneAt("tip", 0, mesh.bounds.centre())};
    result->skeleton = skeleton;
    result->influences.clear();
    result->firstInfluence = {0};
    for (const glm::vec3& position : mesh.positions) {
        const float share = glm::smoothstep(mesh.bounds.low[axis], mesh.bounds.high[axis], position[axis]);
        result->influences.push_back({0, 1.0f - share});
        result->influences.push_back({1, share});
        result->firstInfluence.push_back(static_cast<std::uint32_t>(result->influences.size()));
    }
    return result;
}

ClipPtr bendClip(const Mesh& mesh) {
    auto clip = std::make_shared<Clip>();
    clip->name = "bend";
    clip->frameCount = bendFrames;
    BoneTrack track{1, {}};
    glm::vec3 about(0.0f);
    about[(longestAxis(mesh.bounds) + 1) % 3] = 1.0f;
    for (int frame = 0; frame < bendFrames; ++frame) {
        const float phase = static_cast<float>(frame) / bendFrames * glm::two_pi<float>();
        track.frames.push_back(
            {mesh.bounds.centre(), glm::angleAxis(bendAngle * std::sin(phase), about), glm::vec3(1.0f)});
    }
    clip->tracks.push_back(track);
    return clip;
}

/// Random points in a box: a shard is what lies nearest to one.
std::vector<glm::vec3> shardCentres(const Bounds& bounds, int parts, std::mt19937& random) {
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    std::vector<glm::vec3> centres;
    for (int i = 0; i < parts; ++i)
        centres.push_back(bounds.low +
                          bounds.extent() * glm::vec3(share(random), share(random), share(random)));
    return centres;
}

std::uint32_t nearest(const std::vector<glm::vec3>& centres, const glm::vec3& point) {
    const auto distance = [&](const glm::vec3& centre) { return glm::dot(centre - point, centre - point); };
    const auto found = std::min_element(centres.begin(), centres.end(), [&](const auto& a, const auto& b) {
        return distance(a) < distance(b);
    });
    return static_cast<std::uint32_t>(found - centres.begin());
}

/// Every triangle gets vertices of its own, which follow its shard's bone alone.
MeshPtr shatteredMesh(const Mesh& mesh, const std::vector<glm::vec3>& centres) {
    auto result = std::make_shared<Mesh>();
    result->slots = mesh.slots;
    result->triangleSlots = mesh.triangleSlots;
    result->bounds = mesh.bounds;
    result->firstInfluence = {0};
    for (const glm::uvec3& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(result->positions.size());
        const glm::vec3 middle =
            (mesh.positions[triangle.x] + mesh.positions[triangle.y] + mesh.positions[triangle.z]) / 3.0f;
        const std::uint32_t shard = nearest(centres, middle);
        for (int corner = 0; corner < 3; ++corner) {
            result->positions.push_back(mesh.positions[triangle[corner]]);
            result->normals.push_back(mesh.normals[triangle[corner]]);
            if (!mesh.texCoords.empty())
                result->texCoords.push_back(mesh.texCoords[triangle[corner]]);
            result->influences.push_back({shard, 1.0f});
            result->firstInfluence.push_back(static_cast<std::uint32_t>(result->influences.size()));
        }
        result->triangles.emplace_back(first, first + 1, first + 2);
    }
    auto skeleton = std::make_shared<Skeleton>();
    for (const glm::vec3& centre : centres)
        skeleton->bones.push_back(boneAt("shard", -1, centre));
    result->skeleton = skeleton;
    return result;
}

ClipPtr flightClip(const std::vector<glm::vec3>& centres, float distance, std::mt19937& random) {
    std::normal_distribution<float> normal;
    const auto direction = [&] {
        return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)) + glm::vec3(1e-6f));
    };
    auto clip = std::make_shared<Clip>();
    clip->name = "fly apart";
    clip->frameCount = flightFrames;
    clip->loops = false;
    for (std::size_t shard = 0; shard < centres.size(); ++shard) {
        BoneTrack track{static_cast<int>(shard), {}};
        const glm::vec3 flight = direction() * distance;
        const glm::vec3 about = direction();
        for (int frame = 0; frame < flightFrames; ++frame) {
            const float share = static_cast<float>(frame) / (flightFrames - 1);
            track.frames.push_back(
                {centres[shard] + flight * share, glm::angleAxis(2.0f * share, about), glm::vec3(1.0f)});
        }
        clip->tracks.push_back(std::move(track));
    }
    return clip;
}

template <class Deform>
Scene deformed(const Scene& scene, const Deform& deform) {
    Scene result = scene;
    for (Object& object : result.objects.edit()) {
        if (!object.mesh || object.mesh->triangles.empty())
            continue;
        object.dynamic = true;
        deform(object);
        object.clip = object.clips.front()->name;
    }
    result.timeline = {};
    return result;
}

MeshPtr frozenMesh(const Mesh& mesh, const std::vector<glm::mat4>& bones) {
    auto result = std::make_shared<Mesh>(mesh);
    result->skeleton = nullptr;
    result->influences.clear();
    result->firstInfluence.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        glm::dvec4 sum(0.0);
        for (auto k = mesh.firstInfluence[i]; k < mesh.firstInfluence[i + 1]; ++k)
            sum += static_cast<double>(mesh.influences[k].weight) *
                   (glm::dmat4(bones[mesh.influences[k].bone]) * glm::dvec4(mesh.positions[i], 1.0));
        result->positions[i] = glm::vec3(sum);
    }
    updateBounds(*result);
    return result;
}

} // namespace

Scene frozen(const Scene& scene) {
    Scene result = scene;
    for (Object& object : result.objects.edit()) {
        if (!isPosed(object) || !object.mesh->isSkinned())
            continue;
        const Skeleton& skeleton = *object.mesh->skeleton;
        const Pose pose = evaluatePose(skeleton, poseKeyOf(object, scene.timeline.seconds()));
        object.mesh = frozenMesh(*object.mesh, skinningMatrices(skeleton, pose));
        object.dynamic = false;
    }
    return result;
}

Scene makeBending(const Scene& scene) {
    return deformed(scene, [](Object& object) {
        object.clips = {bendClip(*object.mesh)};
        object.mesh = bendingMesh(*object.mesh);
    });
}

Scene makeFlyingApart(const Scene& scene, int parts, double distance) {
    std::mt19937 random(7);
    return deformed(scene, [&](Object& object) {
        const Mesh& mesh = *object.mesh;
        const auto centres = shardCentres(mesh.bounds, parts, random);
        const float size = glm::length(mesh.bounds.extent());
        object.clips = {flightClip(centres, size * static_cast<float>(distance), random)};
        object.mesh = shatteredMesh(mesh, centres);
    });
}

} // namespace prizma::bench
