#pragma once

#include "core/scene/clip.h"
#include "core/scene/playback.h"

namespace prizma {

/// Number of keys a clip has, each one frame after the other; at least 1.
int keyCount(const Clip& clip);

/// Frames after which a looping clip begins anew. Its last key leads to its first, which takes one more
/// frame, unless the last one repeats the first (as Valve's looping sequences do): then the two are one and
/// the same instant, or every round would pause there.
int framesToRepeat(const Clip& clip);

/// What the clip does beyond its ends when it is played so; never AsClip.
LoopMode loopMode(const Clip& clip, const Playback& playback);

/// Frames a second at which the clip is played, its speed left out.
double frameRate(const Clip& clip, const Playback& playback);

/// The frame of the clip that is shown at `seconds` of the timeline, as a real number in [0, keyCount): above
/// keyCount - 1 it lies between the last key and the first. Times before 0 and speeds below 0 run backwards;
/// what is no number counts as 0.
double clipFrame(const Clip& clip, const Playback& playback, double seconds);

/// Timeline seconds from the clip's first frame to its last (looping: to the first again), at the speed at
/// which it plays; infinity for speed 0.
double playingSeconds(const Clip& clip, const Playback& playback);

} // namespace prizma
