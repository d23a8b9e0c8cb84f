#pragma once

#include "core/scene/bounds.h"
#include "core/scene/properties.h"

#include <span>

namespace prizma {

/// World box of the objects and lights among `selection`; empty if none of them has a place.
DBounds selectionBounds(const Scene& scene, std::span<const EntityRef> selection);

} // namespace prizma
