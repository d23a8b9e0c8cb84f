#include "core/animation/clip_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prizma {
namespace {

// Files round: six decimals of a radian in SMD. Angles and places that differ by less are the same key.
constexpr float sameRotation = 5e-4f; // between unit quaternions: half of the angle
constexpr float sameShare = 1e-4f;    // of the lengths in the clip

/// q and -q are the same rotation.
bool isSameRotation(const glm::quat& a, const glm::quat& b) {
    const glm::quat from = glm::normalize(a);
    const glm::quat to = glm::normalize(b);
    return std::min(glm::length(from - to), glm::length(from + to)) <= sameRotation;
}

bool isSamePlace(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::vec3(tolerance)));
}

bool lastKeyRepeatsFirst(const Clip& clip) {
    float reach = 0.0f;
    for (const BoneTrack& track : clip.tracks)
        if (!track.frames.empty())
            reach = std::max(reach, glm::length(track.frames.front().translation));
    return std::all_of(clip.tracks.begin(), clip.tracks.end(), [&](const BoneTrack& track) {
        if (track.frames.empty())
            return true;
        const BonePose& first = track.frames.front();
        const BonePose& last = track.frames.back();
        return isSameRotation(first.rotation, last.rotation) &&
               isSamePlace(first.translation, last.translation, sameShare * reach) &&
               isSamePlace(first.scale, last.scale, sameShare);
    });
}

/// `frame` brought into [0, period).
double wrapped(double frame, double period) {
    const double inside = frame - std::floor(frame / period) * period;
    return inside >= 0.0 && inside < period ? inside : 0.0; // rounding, and numbers too large to have a phase
}

} // namespace

int keyCount(const Clip& clip) {
    std::size_t keys = static_cast<std::size_t>(std::max(clip.frameCount, 1));
    if (clip.frameCount <= 0)
        for (const BoneTrack& track : clip.tracks)
            keys = std::max(keys, track.frames.size());
    return static_cast<int>(keys);
}

int framesToRepeat(const Clip& clip) {
    const int keys = keyCount(clip);
    return keys > 1 && lastKeyRepeatsFirst(clip) ? keys - 1 : keys;
}

LoopMode loopMode(const Clip& clip, const Playback& playback) {
    if (playback.loop != LoopMode::AsClip)
        return playback.loop;
    return clip.loops ? LoopMode::Loop : LoopMode::Once;
}

double frameRate(const Clip& clip, const Playback& playback) {
    return playback.fps > 0.0 ? playback.fps : clip.fps;
}

double clipFrame(const Clip& clip, const Playback& playback, double seconds) {
    const double frame = (playback.offset + playback.speed * seconds) * frameRate(clip, playback);
    const int keys = keyCount(clip);
    if (!std::isfinite(frame) || keys < 2)
        return 0.0;
    const double last = keys - 1;
    switch (loopMode(clip, playback)) {
    case LoopMode::Loop:
        return wrapped(frame, framesToRepeat(clip));
    case LoopMode::PingPong: {
        const double inside = wrapped(frame, 2.0 * last);
        return inside <= last ? inside : 2.0 * last - inside;
    }
    default:
        return std::clamp(frame, 0.0, last);
    }
}

double playingSeconds(const Clip& clip, const Playback& playback) {
    const bool loops = loopMode(clip, playback) == LoopMode::Loop;
    const double frames = loops ? framesToRepeat(clip) : keyCount(clip) - 1;
    const double pace = frameRate(clip, playback) * std::abs(playback.speed);
    return pace > 0.0 ? frames / pace : std::numeric_limits<double>::infinity();
}

} // namespace prizma
