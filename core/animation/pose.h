#pragma once

#include "core/scene/clip.h"
#include "core/scene/skeleton.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace prizma {

/// A pose: one entry a bone, each relative to its parent.
using Pose = std::vector<BonePose>;

Pose bindPose(const Skeleton& skeleton);

/// The pose `seconds` after the clip's start: slerp and lerp between its keys. A looping clip repeats without
/// a pop (the last key blends into the first); another one holds its last key. Bones without a track keep the
/// bind pose.
Pose evaluateClip(const Skeleton& skeleton, const Clip& clip, double seconds);

/// For each bone, the matrix that takes a vertex from the bind pose to `pose`, both in object space: what the
/// weighted sum of skinning is made of.
std::vector<glm::mat4> skinningMatrices(const Skeleton& skeleton, const Pose& pose);

} // namespace prizma
