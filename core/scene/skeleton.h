#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace prizma {

/// A bone's place relative to its parent: scale, then rotate, then translate.
struct BonePose {
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};

    friend bool operator==(const BonePose&, const BonePose&) = default;
};

struct Bone {
    std::string name;
    int parent = -1; ///< Index of the parent bone, always less than the bone's own; -1 for a root.
    BonePose bind;   ///< Pose in which the mesh was bound.
    glm::mat4 inverseBind{1.0f}; ///< Object space of the bind pose to bone space.
};

/// Bones in an order in which parents come before children.
struct Skeleton {
    std::vector<Bone> bones;
};

using SkeletonPtr = std::shared_ptr<const Skeleton>;

/// How much one bone moves a vertex.
struct BoneInfluence {
    std::uint32_t bone = 0;
    float weight = 0.0f;
};

} // namespace prizma
