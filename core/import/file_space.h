#pragma once

#include "core/scene/object.h"

#include <glm/glm.hpp>

namespace prizma {

/// The matrix that takes points of a model file into object space: turns the axis that is up to Y and scales
/// to scene units. Its inverse takes an object's points back into its file's own space.
glm::dmat4 fileToObject(UpAxis upAxis, double unitScale);

} // namespace prizma
