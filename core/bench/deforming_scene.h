#pragma once

#include "core/scene/scene.h"

namespace prizma::bench {

/// `scene` with every object Dynamic and skinned to two bones; a clip of 64 frames bends it slightly along
/// its longest axis, back and forth, so that no two frames next to each other are alike.
Scene makeBending(const Scene& scene);

/// Frames of the clip of makeFlyingApart.
inline constexpr int flightFrames = 64;

/// `scene` with every object Dynamic and cut into `parts` shards (cells about random points). In the clip's
/// first frame they are together; they tumble and fly apart, each in a direction of its own, to
/// `distance` times the object's size in the last frame: what ruins a tree that is only refitted.
Scene makeFlyingApart(const Scene& scene, int parts, double distance);

/// `scene` with every skinned Dynamic object replaced by a rigid one in the pose that it has at the
/// timeline's time, as the host works it out.
Scene frozen(const Scene& scene);

} // namespace prizma::bench
