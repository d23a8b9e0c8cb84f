#pragma once

#include "core/animation/pose_key.h"
#include "core/scene/scene.h"

namespace prizma {

/// The exact box of a mesh in a pose, in object space, computed on the host (about 10 ns a bone weight):
/// morph targets, then skinning, as VertexShader does it.
Bounds posedBounds(const Mesh& mesh, const PoseKey& key);

/// The world box of an object as it is at `seconds` of the timeline: in its pose if it is posed. Empty
/// without a mesh. `toWorld` is from its own space (worldMatrix in core/scene/hierarchy.h).
DBounds worldBounds(const Object& object, const glm::dmat4& toWorld, double seconds);

/// The same at the scene's own time and in its groups.
DBounds worldBounds(const Scene& scene, const Object& object);

/// World box of all shown objects that have a mesh, at the time of the timeline; empty if there is none.
DBounds worldBounds(const Scene& scene);

} // namespace prizma
