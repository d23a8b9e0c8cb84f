#pragma once

#include "core/diagnostic.h"
#include "core/scene/hierarchy.h"

#include <span>
#include <vector>

namespace prizma {

/// Edits of what hangs under what. Objects, lights and groups take part; whatever else is named is passed
/// over, as are ids that the scene does not have.

/// The transform whose matrix is `matrix`. A shear, which no transform has, is lost: the first axis keeps its
/// direction, the second its plane, all three their lengths.
Transform transformOf(const glm::dmat4& matrix);

/// Those of `entities` that hang under no other one of them: moving, copying or removing them takes the rest
/// along.
std::vector<EntityRef> topmost(const Scene& scene, std::span<const EntityRef> entities);

/// `entities` and everything in groups among them, however deep, each once.
std::vector<EntityRef> withMembers(const Scene& scene, std::span<const EntityRef> entities);

/// Hangs the topmost of `entities` under `group`, or under none if it is noId. They keep their places in the
/// world (as far as a transform can say it: see transformOf). Errors: the group does not exist, or it is or
/// hangs under one of `entities`.
Result<void> reparent(Scene& scene, std::span<const EntityRef> entities, Id group);

/// Puts the topmost of `entities` into a new group, at their middle, under the nearest group that all of them
/// hang under. Gives its id, or noId if there is nothing to group.
Id groupEntities(Scene& scene, std::span<const EntityRef> entities);

/// Removes the groups among `entities`; what was in them hangs where they hung, in its old place, and hidden
/// if they hid it. Gives what was in them.
std::vector<EntityRef> ungroupEntities(Scene& scene, std::span<const EntityRef> entities);

/// Copies a group and all that is in it, beside the original. Gives the copy's id.
Id duplicateGroup(Scene& scene, Id group);

/// World box of what the entities show: objects in their pose, lights as points, groups with their members.
DBounds worldBounds(const Scene& scene, std::span<const EntityRef> entities);

} // namespace prizma
