#include "core/animation/pose_key.h"

#include "core/animation/clip_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prizma {
namespace {

ClipMoment momentOf(const Object& object, const std::string& clipName, double seconds) {
    ClipPtr clip = findClip(object, clipName);
    if (!clip)
        return {};
    const double frame = clipFrame(*clip, object.playback, seconds);
    return {std::move(clip), frame};
}

/// How far the fade has come: it sets out and arrives at rest (3t² - 2t³), so that no limb starts with a
/// jerk.
double fadeShare(const Playback& playback, double seconds) {
    if (!(playback.fadeSeconds > 0.0))
        return 1.0;
    const double t = std::clamp((seconds - playback.fadeStart) / playback.fadeSeconds, 0.0, 1.0);
    return std::isfinite(t) ? t * t * (3.0 - 2.0 * t) : 1.0;
}

std::vector<double> weightsOf(const Object& object) {
    std::vector<double> weights;
    if (!object.mesh || object.morphWeights.empty())
        return weights;
    const auto& targets = object.mesh->morphTargets;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto found = object.morphWeights.find(targets[i].name);
        if (found == object.morphWeights.end() || found->second == 0.0)
            continue;
        weights.resize(targets.size());
        weights[i] = found->second;
    }
    return weights;
}

} // namespace

bool isPosed(const Object& object) {
    return object.dynamic && object.mesh && object.mesh->canBePosed();
}

ClipPtr findClip(const Object& object, const std::string& name) {
    const auto found = std::find_if(object.clips.begin(), object.clips.end(),
                                    [&](const ClipPtr& clip) { return clip->name == name; });
    return found == object.clips.end() || name.empty() ? nullptr : *found;
}

PoseKey poseKeyOf(const Object& object, double seconds) {
    PoseKey key;
    key.morphWeights = weightsOf(object);
    if (!object.mesh || !object.mesh->isSkinned())
        return key;
    key.now = momentOf(object, object.clip, seconds);
    key.share = fadeShare(object.playback, seconds);
    if (key.share < 1.0)
        key.before = momentOf(object, object.playback.fadeFrom, seconds);
    if (key.share == 0.0) { // the same pose has the same key
        key.now = std::exchange(key.before, {});
        key.share = 1.0;
    }
    return key;
}

void changeClip(Object& object, const std::string& clip, double seconds, double fadeSeconds) {
    object.playback.fadeFrom = fadeSeconds > 0.0 ? object.clip : std::string();
    object.playback.fadeStart = fadeSeconds > 0.0 ? seconds : 0.0;
    object.playback.fadeSeconds = std::max(fadeSeconds, 0.0);
    object.clip = clip;
}

} // namespace prizma
