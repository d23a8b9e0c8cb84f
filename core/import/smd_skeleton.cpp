#include "core/import/smd_skeleton.h"

#include "core/import/fault_tally.h"
#include "core/import/file_space.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// A file may leave out bones that do not move, and become longer when it is read; this much, or four times
/// its own size, is let pass.
constexpr std::size_t mostFilledPoses = 2'000'000;

glm::dquat rotationOf(const glm::vec3& angles) {
    return glm::angleAxis(static_cast<double>(angles.z), glm::dvec3(0, 0, 1)) *
           glm::angleAxis(static_cast<double>(angles.y), glm::dvec3(0, 1, 0)) *
           glm::angleAxis(static_cast<double>(angles.x), glm::dvec3(1, 0, 0));
}

struct Place {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

/// The place of a bone in object space's units, with the turn if it is a root.
class Placer {
  public:
    explicit Placer(const SmdSpace& space)
        : turn_(glm::quat_cast(glm::dmat3(fileToObject(space.upAxis, 1.0)))), scale_(space.scale) {}

    Place at(const SmdKey& key, bool isRoot) const {
        const Place place{glm::dvec3(key.position) * scale_, rotationOf(key.angles)};
        return isRoot ? Place{turn_ * place.position, turn_ * place.rotation} : place;
    }
    Place unmoved(bool isRoot) const { return isRoot ? Place{glm::dvec3(0.0), turn_} : Place{}; }

  private:
    glm::dquat turn_;
    double scale_;
};

BonePose poseOf(const Place& place) {
    BonePose pose;
    pose.translation = glm::vec3(place.position);
    pose.rotation = glm::quat(glm::normalize(place.rotation));
    return pose;
}

glm::dmat4 matrixOf(const Place& place) {
    glm::dmat4 matrix = glm::mat4_cast(place.rotation);
    matrix[3] = glm::dvec4(place.position, 1.0);
    return matrix;
}

bool isFinite(const glm::mat4& matrix) {
    bool finite = true;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            finite = finite && std::isfinite(matrix[column][row]);
    return finite;
}

void warnOfBones(Diagnostics& warnings, const std::string& file, const std::vector<std::string>& bones,
                 const std::string& what) {
    if (!bones.empty())
        warnings.push_back({Severity::Warning, what + ": " + listOf(bones) + ".", file, 0});
}

/// The first key of each bone; null where there is none.
std::vector<const SmdKey*> firstKeys(const SmdFile& smd) {
    std::vector<const SmdKey*> firsts(smd.bones.size(), nullptr);
    for (const SmdKey& key : smd.keys)
        if (!firsts[key.bone])
            firsts[key.bone] = &key;
    return firsts;
}

/// Lays the keys of a file out as one pose a frame for each bone that has any.
class TrackFiller {
  public:
    TrackFiller(const SmdFile& smd, const std::vector<const SmdKey*>& firsts)
        : smd_(smd), trackOfBone_(smd.bones.size()), hasGaps_(smd.bones.size(), false) {
        for (std::size_t bone = 0; bone < smd.bones.size(); ++bone) {
            if (!firsts[bone])
                continue;
            trackOfBone_[bone] = tracks_.size();
            BoneTrack& track = tracks_.emplace_back();
            track.bone = static_cast<int>(bone);
            track.frames.reserve(static_cast<std::size_t>(smd.frameCount));
        }
    }

    void add(const SmdKey& key, BonePose pose) {
        BoneTrack& track = tracks_[trackOfBone_[key.bone]];
        auto& frames = track.frames;
        // Until it first appears a bone stands where it does so; later it stays where it was.
        fillUpTo(track, key.frame, frames.empty() ? pose : frames.back());
        if (!frames.empty() && glm::dot(pose.rotation, frames.back().rotation) < 0.0F)
            pose.rotation = -pose.rotation; // the same, and the short way from the frame before
        if (frames.size() > key.frame)
            frames[key.frame] = pose; // given twice: the last one counts
        else
            frames.push_back(pose);
    }

    std::vector<BoneTrack> finish() {
        for (BoneTrack& track : tracks_)
            fillUpTo(track, static_cast<std::size_t>(smd_.frameCount), track.frames.back());
        return std::move(tracks_);
    }

    std::vector<std::string> bonesWithGaps() const {
        std::vector<std::string> names;
        for (std::size_t bone = 0; bone < hasGaps_.size(); ++bone)
            if (hasGaps_[bone])
                names.push_back(smd_.bones[bone].name);
        return names;
    }

  private:
    void fillUpTo(BoneTrack& track, std::size_t count, const BonePose& pose) {
        if (track.frames.size() >= count)
            return;
        hasGaps_[static_cast<std::size_t>(track.bone)] = true;
        track.frames.resize(count, pose);
    }

    const SmdFile& smd_;
    std::vector<BoneTrack> tracks_;
    std::vector<std::size_t> trackOfBone_;
    std::vector<bool> hasGaps_;
};

} // namespace

Result<SmdSkeleton> makeSmdSkeleton(const SmdFile& smd, const SmdSpace& space, const std::string& file,
                                    Diagnostics& warnings) {
    const Placer placer(space);
    const auto firsts = firstKeys(smd);
    std::vector<std::string> late;
    std::vector<std::string> lost;
    SmdSkeleton result;
    for (std::size_t i = 0; i < smd.bones.size(); ++i) {
        const SmdBone& source = smd.bones[i];
        const SmdKey* key = firsts[i];
        if (!key)
            lost.push_back(source.name);
        else if (key->frame > 0)
            late.push_back(source.name);
        const bool isRoot = source.parent < 0;
        const Place place = key ? placer.at(*key, isRoot) : placer.unmoved(isRoot);
        glm::dmat4 global = matrixOf(place);
        if (!isRoot)
            global = result.globals[static_cast<std::size_t>(source.parent)] * global;
        Bone bone;
        bone.name = source.name;
        bone.parent = source.parent;
        bone.bind = poseOf(place);
        bone.inverseBind = glm::mat4(glm::affineInverse(global));
        if (!isFinite(bone.inverseBind) || !isFinite(glm::mat4(global)))
            return failure("The bone \"" + source.name + "\" is too far away to compute with.", file);
        result.globals.push_back(global);
        result.skeleton.bones.push_back(std::move(bone));
    }
    warnOfBones(warnings, file, late, "The first frame lacks bones, which were put where they first appear");
    warnOfBones(warnings, file, lost, "The skeleton lacks bones, which were put where their parents are");
    return result;
}

Result<Clip> makeSmdClip(const SmdFile& smd, const SmdSpace& space, const std::string& file,
                         Diagnostics& warnings) {
    if (smd.frameCount == 0)
        return failure("There are no frames in it.", file);
    const auto firsts = firstKeys(smd);
    const auto moved = static_cast<std::size_t>(
        std::ranges::count_if(firsts, [](const SmdKey* key) { return key != nullptr; }));
    const std::size_t poses = moved * static_cast<std::size_t>(smd.frameCount);
    if (poses > std::max(mostFilledPoses, 4 * smd.keys.size()))
        return failure("It has " + std::to_string(smd.frameCount) + " frames of " + std::to_string(moved) +
                           " bones, but the places of hardly any: it cannot be what it says.",
                       file);
    const Placer placer(space);
    TrackFiller filler(smd, firsts);
    for (const SmdKey& key : smd.keys) {
        const BonePose pose = poseOf(placer.at(key, smd.bones[key.bone].parent < 0));
        if (!std::isfinite(glm::length(pose.translation)))
            return failure("A bone is too far away to compute with.", file);
        filler.add(key, pose);
    }
    Clip clip;
    clip.frameCount = smd.frameCount;
    clip.tracks = filler.finish();
    warnOfBones(warnings, file, filler.bonesWithGaps(), "Bones that some frames lack stay where they were");
    return clip;
}

} // namespace prizma
