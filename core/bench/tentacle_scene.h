#pragma once

#include "core/scene/scene.h"

namespace prizma::bench {

/// One Dynamic object: a tube of 100,000 triangles and 50,000 vertices with four weights each, bound to a
/// chain of 60 bones, and a looping clip of 60 frames in which it writhes. What skeletal animation is
/// measured with.
Scene makeTentacleScene();

} // namespace prizma::bench
