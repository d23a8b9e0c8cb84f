#include "core/animation/pose.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

glm::mat4 matrixOf(const BonePose& bone) {
    return glm::translate(glm::mat4(1.0f), bone.translation) * glm::mat4_cast(glm::normalize(bone.rotation)) *
           glm::scale(glm::mat4(1.0f), bone.scale);
}

BonePose blend(const BonePose& a, const BonePose& b, float share) {
    return {glm::mix(a.translation, b.translation, share), glm::slerp(a.rotation, b.rotation, share),
            glm::mix(a.scale, b.scale, share)};
}

/// Two keys and how far it is from the first to the second.
struct KeyPair {
    std::size_t from = 0, to = 0;
    float share = 0.0f;
};

KeyPair keysAt(std::size_t count, bool loops, double frame) {
    if (count < 2 || !std::isfinite(frame))
        return {};
    const auto last = static_cast<double>(count - 1);
    if (!loops)
        frame = std::clamp(frame, 0.0, last);
    else
        frame -= std::floor(frame / static_cast<double>(count)) * static_cast<double>(count);
    const auto from = std::min(static_cast<std::size_t>(frame), count - 1);
    const std::size_t to = from + 1 < count ? from + 1 : (loops ? 0 : from);
    return {from, to, static_cast<float>(frame - static_cast<double>(from))};
}

} // namespace

Pose bindPose(const Skeleton& skeleton) {
    Pose pose;
    pose.reserve(skeleton.bones.size());
    for (const Bone& bone : skeleton.bones)
        pose.push_back(bone.bind);
    return pose;
}

Pose evaluateClip(const Skeleton& skeleton, const Clip& clip, double seconds) {
    Pose pose = bindPose(skeleton);
    for (const BoneTrack& track : clip.tracks) {
        const auto bone = static_cast<std::size_t>(track.bone);
        if (track.bone < 0 || bone >= pose.size() || track.frames.empty())
            continue;
        const KeyPair keys = keysAt(track.frames.size(), clip.loops, seconds * clip.fps);
        pose[bone] = blend(track.frames[keys.from], track.frames[keys.to], keys.share);
    }
    return pose;
}

std::vector<glm::mat4> skinningMatrices(const Skeleton& skeleton, const Pose& pose) {
    std::vector<glm::mat4> toObject(pose.size());
    std::vector<glm::mat4> skinning(pose.size());
    for (std::size_t i = 0; i < pose.size(); ++i) {
        const int parent = skeleton.bones[i].parent;
        toObject[i] = matrixOf(pose[i]);
        if (parent >= 0)
            toObject[i] = toObject[static_cast<std::size_t>(parent)] * toObject[i];
        skinning[i] = toObject[i] * skeleton.bones[i].inverseBind;
    }
    return skinning;
}

} // namespace prizma
