#include "core/animation/pose.h"

#include "core/animation/clip_time.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// Scale, then rotate, then translate.
glm::mat4 matrixOf(const BonePose& bone) {
    glm::mat4 matrix = glm::mat4_cast(glm::normalize(bone.rotation));
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis] *= bone.scale[axis];
    matrix[3] = glm::vec4(bone.translation, 1.0f);
    return matrix;
}

BonePose blend(const BonePose& a, const BonePose& b, float share) {
    return {glm::mix(a.translation, b.translation, share), glm::slerp(a.rotation, b.rotation, share),
            glm::mix(a.scale, b.scale, share)};
}

/// Of one bone, between the two keys about `frame`. Short tracks hold their last key.
BonePose keyAt(const BoneTrack& track, double frame, std::size_t keys) {
    const auto last = track.frames.size() - 1;
    const auto from = static_cast<std::size_t>(frame);
    const auto to = from + 1 < keys ? from + 1 : 0;
    const auto share = static_cast<float>(frame - static_cast<double>(from));
    const BonePose& first = track.frames[std::min(from, last)];
    return share > 0.0f ? blend(first, track.frames[std::min(to, last)], share) : first;
}

} // namespace

Pose bindPose(const Skeleton& skeleton) {
    Pose pose;
    pose.reserve(skeleton.bones.size());
    for (const Bone& bone : skeleton.bones)
        pose.push_back(bone.bind);
    return pose;
}

Pose poseAtFrame(const Skeleton& skeleton, const Clip& clip, double frame) {
    Pose pose = bindPose(skeleton);
    const auto keys = static_cast<std::size_t>(keyCount(clip));
    const double inside = frame > 0.0 ? std::min(frame, static_cast<double>(keys)) : 0.0;
    for (const BoneTrack& track : clip.tracks) {
        const auto bone = static_cast<std::size_t>(track.bone);
        if (track.bone >= 0 && bone < pose.size() && !track.frames.empty())
            pose[bone] = keyAt(track, inside, keys);
    }
    return pose;
}

Pose blend(const Pose& a, const Pose& b, double share) {
    Pose pose(std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < pose.size(); ++i)
        pose[i] = blend(a[i], b[i], static_cast<float>(share));
    return pose;
}

Pose evaluatePose(const Skeleton& skeleton, const PoseKey& key) {
    const auto at = [&](const ClipMoment& moment) {
        return moment.clip ? poseAtFrame(skeleton, *moment.clip, moment.frame) : bindPose(skeleton);
    };
    return key.share < 1.0 ? blend(at(key.before), at(key.now), key.share) : at(key.now);
}

std::vector<glm::mat4> boneToObject(const Skeleton& skeleton, const Pose& pose) {
    std::vector<glm::mat4> toObject(pose.size());
    for (std::size_t i = 0; i < pose.size(); ++i) {
        const int parent = skeleton.bones[i].parent;
        toObject[i] = matrixOf(pose[i]);
        if (parent >= 0)
            toObject[i] = toObject[static_cast<std::size_t>(parent)] * toObject[i];
    }
    return toObject;
}

std::vector<glm::mat4> skinningMatrices(const Skeleton& skeleton, const Pose& pose) {
    std::vector<glm::mat4> matrices = boneToObject(skeleton, pose);
    for (std::size_t i = 0; i < matrices.size(); ++i)
        matrices[i] = matrices[i] * skeleton.bones[i].inverseBind;
    return matrices;
}

} // namespace prizma
