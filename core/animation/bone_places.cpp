#include "core/animation/bone_places.h"

#include "core/animation/pose.h"

namespace prizma {
namespace {

/// Where the bone comes from, in its own space: as it was bound, so that it turns with the bone.
glm::vec3 wayBack(const Skeleton& skeleton, const std::vector<glm::mat4>& bind, std::size_t bone) {
    const int parent = skeleton.bones[bone].parent;
    if (parent < 0)
        return glm::vec3(0.0f);
    return glm::vec3(glm::inverse(bind[bone]) * bind[static_cast<std::size_t>(parent)][3]);
}

} // namespace

std::vector<BonePlace> bonePlaces(const Object& object, const glm::dmat4& toWorld, double seconds) {
    std::vector<BonePlace> places;
    if (!object.mesh || !object.mesh->skeleton)
        return places;
    const Skeleton& skeleton = *object.mesh->skeleton;
    const Pose bound = bindPose(skeleton);
    const auto bind = boneToObject(skeleton, bound);
    const auto posed =
        isPosed(object) ? boneToObject(skeleton, evaluatePose(skeleton, poseKeyOf(object, seconds))) : bind;
    std::vector<bool> isLeaf(posed.size(), true);
    for (const Bone& bone : skeleton.bones)
        if (bone.parent >= 0)
            isLeaf[static_cast<std::size_t>(bone.parent)] = false;
    for (std::size_t i = 0; i < posed.size(); ++i) {
        BonePlace place{glm::dvec3(toWorld * glm::dvec4(posed[i][3])), {}};
        const glm::vec3 back = isLeaf[i] ? wayBack(skeleton, bind, i) : glm::vec3(0.0f);
        if (glm::length(back) > 0.0f)
            place.tip = glm::dvec3(toWorld * glm::dvec4(posed[i] * glm::vec4(back * -0.5f, 1.0f)));
        places.push_back(place);
    }
    return places;
}

} // namespace prizma
