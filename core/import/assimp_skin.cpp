#include "core/import/assimp_skin.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double clipFps = 30.0;
constexpr int mostFrames = 100'000;

BonePose decompose(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    glm::dvec3 scale(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
    if (glm::determinant(linear) < 0.0)
        scale.x = -scale.x;
    const auto column = [&](int i) { return scale[i] != 0.0 ? linear[i] / scale[i] : glm::dvec3(0.0); };
    const glm::dquat rotation = glm::quat_cast(glm::dmat3(column(0), column(1), column(2)));
    const double length = glm::length(rotation);
    BonePose pose;
    pose.translation = glm::vec3(glm::dvec3(matrix[3]));
    if (std::isfinite(length) && length > 0.0)
        pose.rotation = glm::quat(rotation / length);
    pose.scale = glm::vec3(scale);
    return pose;
}

glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
    glm::dmat4 matrix = glm::mat4_cast(rotation);
    for (int i = 0; i < 3; ++i)
        matrix[i] *= scale[i];
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

/// The inverse, or the identity of a matrix that has none.
glm::dmat4 safeInverse(const glm::dmat4& matrix) {
    const double determinant = glm::determinant(matrix);
    return std::isfinite(determinant) && determinant != 0.0 ? glm::inverse(matrix) : glm::dmat4(1.0);
}

/// The keys on both sides of `time`, and how far it is from the first to the second.
template <class Key>
struct Between {
    const Key* before;
    const Key* after;
    double part;
};

template <class Key>
Between<Key> findKeys(const Key* keys, unsigned count, double time) {
    const Key* end = keys + count;
    const Key* after =
        std::upper_bound(keys, end, time, [](double t, const Key& key) { return t < key.mTime; });
    if (after == keys)
        return {keys, keys, 0.0};
    if (after == end)
        return {end - 1, end - 1, 0.0};
    const double span = after->mTime - (after - 1)->mTime;
    return {after - 1, after, span > 0.0 ? (time - (after - 1)->mTime) / span : 0.0};
}

glm::dvec3 sample(const aiVectorKey* keys, unsigned count, double time, const glm::dvec3& otherwise) {
    if (count == 0)
        return otherwise;
    const auto found = findKeys(keys, count, time);
    const auto& a = found.before->mValue;
    const auto& b = found.after->mValue;
    return glm::mix(glm::dvec3(a.x, a.y, a.z), glm::dvec3(b.x, b.y, b.z), found.part);
}

glm::dquat sample(const aiQuatKey* keys, unsigned count, double time, const glm::dquat& otherwise) {
    if (count == 0)
        return otherwise;
    const auto found = findKeys(keys, count, time);
    const auto& a = found.before->mValue;
    const auto& b = found.after->mValue;
    return glm::normalize(
        glm::slerp(glm::dquat(a.w, a.x, a.y, a.z), glm::dquat(b.w, b.x, b.y, b.z), found.part));
}

BoneTrack readTrack(const aiNodeAnim& channel, int bone, const BonePose& rest, const glm::dmat4& before,
                    int frameCount, double ticksPerFrame) {
    BoneTrack track;
    track.bone = bone;
    for (int frame = 0; frame < frameCount; ++frame) {
        const double time = frame * ticksPerFrame;
        const auto t =
            sample(channel.mPositionKeys, channel.mNumPositionKeys, time, glm::dvec3(rest.translation));
        const auto r =
            sample(channel.mRotationKeys, channel.mNumRotationKeys, time, glm::dquat(rest.rotation));
        const auto s = sample(channel.mScalingKeys, channel.mNumScalingKeys, time, glm::dvec3(rest.scale));
        track.frames.push_back(decompose(before * compose(t, r, s)));
    }
    return track;
}

} // namespace

glm::dmat4 toGlm(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1, m.d1},
            {m.a2, m.b2, m.c2, m.d2},
            {m.a3, m.b3, m.c3, m.d3},
            {m.a4, m.b4, m.c4, m.d4}};
}

AssimpSkin::AssimpSkin(const aiScene& scene, const glm::dmat4& toObject) : toObject_(toObject) {
    std::vector<const aiNode*> nodes{scene.mRootNode};
    for (std::size_t i = 0; i < nodes.size(); ++i) { // breadth first: parents come before children
        const aiNode& node = *nodes[i];
        const auto parent = boneOfNode_.find(node.mParent);
        const bool isRoot = parent == boneOfNode_.end();
        const glm::dmat4 local =
            isRoot ? toObject * toGlm(node.mTransformation) : toGlm(node.mTransformation);
        Bone bone;
        bone.name = node.mName.C_Str();
        bone.parent = isRoot ? -1 : parent->second;
        bone.bind = decompose(local);
        globals_.push_back(isRoot ? local : globals_[static_cast<std::size_t>(parent->second)] * local);
        bone.inverseBind = glm::mat4(safeInverse(globals_.back()));
        boneOfNode_.emplace(&node, static_cast<int>(i));
        boneOfName_.emplace(bone.name, static_cast<int>(i));
        skeleton_.bones.push_back(std::move(bone));
        nodes.insert(nodes.end(), node.mChildren, node.mChildren + node.mNumChildren);
    }
    inverseBindKnown_.assign(skeleton_.bones.size(), false);
}

bool AssimpSkin::isNeeded(const aiScene& scene) {
    return scene.mNumAnimations > 0 || std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                                                   [](const aiMesh* mesh) { return mesh->HasBones(); });
}

glm::dmat4 AssimpSkin::global(const aiNode& node) const {
    return globals_[static_cast<std::size_t>(boneOfNode_.at(&node))];
}

AssimpSkin::Binding AssimpSkin::bind(const aiMesh& mesh, const aiNode& node) {
    const auto first = static_cast<std::uint32_t>(weights_.size());
    weights_.resize(weights_.size() + mesh.mNumVertices);
    Binding binding{global(node), first};
    bool placed = false;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& source = *mesh.mBones[b];
        const auto found = boneOfName_.find(source.mName.C_Str());
        if (found == boneOfName_.end())
            continue;
        const auto bone = static_cast<std::size_t>(found->second);
        const glm::dmat4 offset = toGlm(source.mOffsetMatrix);
        // The first bone says where the mesh is, by the place that this bone has, or had with an earlier
        // mesh.
        if (!placed)
            binding.toObject =
                (inverseBindKnown_[bone] ? safeInverse(glm::dmat4(skeleton_.bones[bone].inverseBind))
                                         : globals_[bone]) *
                offset;
        placed = true;
        if (!inverseBindKnown_[bone])
            skeleton_.bones[bone].inverseBind = glm::mat4(offset * safeInverse(binding.toObject));
        inverseBindKnown_[bone] = true;
        for (unsigned w = 0; w < source.mNumWeights; ++w)
            if (const auto [vertex, weight] = source.mWeights[w]; vertex < mesh.mNumVertices && weight > 0.0F)
                weights_[first + vertex].push_back({static_cast<std::uint32_t>(bone), weight});
    }
    const BoneInfluence rigid{static_cast<std::uint32_t>(boneOfNode_.at(&node)), 1.0F};
    for (std::size_t vertex = first; vertex < weights_.size(); ++vertex)
        if (weights_[vertex].empty())
            weights_[vertex].push_back(rigid);
    return binding;
}

void AssimpSkin::apply(BuiltMesh& built) {
    Mesh& mesh = built.mesh;
    mesh.firstInfluence.assign(1, 0);
    for (const std::uint32_t source : built.sourceVertices) {
        float sum = 0.0F;
        for (const BoneInfluence& influence : weights_[source])
            sum += influence.weight;
        for (const BoneInfluence& influence : weights_[source])
            mesh.influences.push_back({influence.bone, influence.weight / sum});
        mesh.firstInfluence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
    }
    mesh.skeleton = std::make_shared<Skeleton>(skeleton_);
}

std::vector<ClipPtr> AssimpSkin::clips(const aiScene& scene) const {
    std::vector<ClipPtr> clips;
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        const aiAnimation& source = *scene.mAnimations[a];
        const double ticksPerSecond = source.mTicksPerSecond > 0.0 ? source.mTicksPerSecond : 25.0;
        const double frames = source.mDuration / ticksPerSecond * clipFps;
        auto clip = std::make_shared<Clip>();
        clip->name = source.mName.length > 0 ? source.mName.C_Str() : "clip " + std::to_string(a + 1);
        clip->fps = clipFps;
        clip->frameCount =
            frames > 0.0 ? static_cast<int>(std::min<double>(std::round(frames) + 1, mostFrames)) : 1;
        for (unsigned c = 0; c < source.mNumChannels; ++c) {
            const aiNodeAnim& channel = *source.mChannels[c];
            const auto found = boneOfName_.find(channel.mNodeName.C_Str());
            if (found == boneOfName_.end())
                continue;
            const Bone& bone = skeleton_.bones[static_cast<std::size_t>(found->second)];
            const glm::dmat4 before = bone.parent < 0 ? toObject_ : glm::dmat4(1.0);
            clip->tracks.push_back(readTrack(channel, found->second, bone.bind, before, clip->frameCount,
                                             ticksPerSecond / clipFps));
        }
        clips.push_back(std::move(clip));
    }
    return clips;
}

} // namespace prizma
