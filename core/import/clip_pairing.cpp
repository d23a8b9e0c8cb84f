#include "core/import/clip_pairing.h"

#include "core/import/fault_tally.h"

#include <algorithm>
#include <unordered_map>

namespace prizma {
namespace {

/// assimp puts nodes of its own ("<MD5_Root>") above those of some formats, others with a model than without.
bool isInvented(std::string_view name) {
    return name.starts_with('<') && name.ends_with('>');
}

/// Empty for a root.
std::string_view parentName(const Skeleton& skeleton, const Bone& bone) {
    if (bone.parent < 0)
        return {};
    const std::string_view name = skeleton.bones[static_cast<std::size_t>(bone.parent)].name;
    return isInvented(name) ? std::string_view() : name;
}

} // namespace

BonePairing::BonePairing(const Skeleton& animation, const Skeleton& model)
    : modelBones_(animation.bones.size(), -1) {
    std::unordered_map<std::string_view, int> byName;
    for (std::size_t i = 0; i < model.bones.size(); ++i)
        byName.try_emplace(model.bones[i].name, static_cast<int>(i));
    std::vector<bool> paired(model.bones.size(), false);
    for (std::size_t i = 0; i < animation.bones.size(); ++i) {
        const Bone& bone = animation.bones[i];
        const auto found = byName.find(bone.name);
        if (found == byName.end() || paired[static_cast<std::size_t>(found->second)]) {
            if (!isInvented(bone.name))
                excess_.push_back(bone.name);
            continue;
        }
        const auto index = static_cast<std::size_t>(found->second);
        modelBones_[i] = found->second;
        paired[index] = true;
        ++pairs_;
        if (!isInvented(bone.name) && parentName(animation, bone) != parentName(model, model.bones[index]))
            elsewhere_.push_back(bone.name);
    }
    for (std::size_t i = 0; i < model.bones.size(); ++i)
        if (!paired[i] && !isInvented(model.bones[i].name))
            lacking_.push_back(model.bones[i].name);
}

Clip BonePairing::apply(Clip clip) const {
    std::vector<BoneTrack> kept;
    for (BoneTrack& track : clip.tracks) {
        track.bone = modelBones_[static_cast<std::size_t>(track.bone)];
        if (track.bone >= 0)
            kept.push_back(std::move(track));
    }
    clip.tracks = std::move(kept);
    return clip;
}

Diagnostics BonePairing::warnings(const std::string& file) const {
    Diagnostics warnings;
    const auto add = [&](const std::vector<std::string>& bones, const char* what) {
        if (!bones.empty())
            warnings.push_back({Severity::Warning, what + listOf(bones) + ".", file, 0});
    };
    add(lacking_, "The animation lacks bones of the model, which keep their bind pose: ");
    add(excess_, "The animation has bones that the model lacks, which were ignored: ");
    add(elsewhere_, "Bones hang on another bone in the animation than in the model and may be misplaced: ");
    return warnings;
}

std::string freeClipName(const std::vector<ClipPtr>& clips, const std::string& wanted) {
    std::string name = wanted;
    const auto taken = [&](const ClipPtr& clip) { return clip->name == name; };
    for (int number = 2; std::ranges::any_of(clips, taken); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

} // namespace prizma
