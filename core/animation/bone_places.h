#pragma once

#include "core/scene/object.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace prizma {

/// Where a bone is in world space.
struct BonePlace {
    glm::dvec3 joint{0.0}; ///< What the bone turns about.
    /// The far end of a bone without children: a skeleton does not say where that is, so it is drawn on as
    /// the bone that leads to it, half as long. Other bones reach to the joints of their children.
    std::optional<glm::dvec3> tip;
};

/// The bones of an object at `seconds` of the timeline in the pose in which it is drawn, in the skeleton's
/// order. Empty without a skeleton. `toWorld` is from the object's own space to world space.
std::vector<BonePlace> bonePlaces(const Object& object, const glm::dmat4& toWorld, double seconds);

} // namespace prizma
