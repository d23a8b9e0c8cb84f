#pragma once

#include "core/scene/scene.h"

namespace prizma {

/// The lights that an empty scene starts with and a bare model is shown in: a key, a fill and a rim light
/// whose places and strengths fit `bounds`.
void addThreeLights(Scene& scene, const DBounds& bounds);

/// What "New" opens: three lights, a ground plane, a camera that looks at it.
Scene makeStarterScene();

/// Lights and camera for a scene that holds a bare model: three lights, the camera framing it from the front,
/// a little from the right and above. `aspect` is width / height.
void presentModel(Scene& scene, double aspect);

} // namespace prizma
