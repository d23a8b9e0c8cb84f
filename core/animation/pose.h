#pragma once

#include "core/animation/pose_key.h"
#include "core/scene/clip.h"
#include "core/scene/skeleton.h"

#include <glm/glm.hpp>

#include <vector>

namespace prizma {

/// A pose: one entry a bone, each relative to its parent.
using Pose = std::vector<BonePose>;

Pose bindPose(const Skeleton& skeleton);

/// The pose at a frame in [0, keyCount), as `clipFrame` gives it: slerp (the short way) and lerp between its
/// keys, from the last one to the first. Bones without a track keep the bind pose.
Pose poseAtFrame(const Skeleton& skeleton, const Clip& clip, double frame);

/// Bone by bone: slerp and lerp from `a` (share 0) to `b` (share 1).
Pose blend(const Pose& a, const Pose& b, double share);

/// The pose that `key` stands for.
Pose evaluatePose(const Skeleton& skeleton, const PoseKey& key);

/// For each bone, the matrix from bone space to object space: column 3 is where its joint is.
std::vector<glm::mat4> boneToObject(const Skeleton& skeleton, const Pose& pose);

/// For each bone, the matrix that takes a vertex from the bind pose to `pose`, both in object space: what the
/// weighted sum of skinning is made of.
std::vector<glm::mat4> skinningMatrices(const Skeleton& skeleton, const Pose& pose);

} // namespace prizma
