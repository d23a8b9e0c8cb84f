#pragma once

#include "core/scene/id.h"
#include "core/scene/transform.h"

#include <string>

namespace prizma {

/// A node without a shape that objects, lights and further groups hang under: they move, and hide, with it.
/// Groups form trees; a parent that does not exist counts as none.
struct Group {
    Id id = noId;
    std::string name;
    Id parent = noId;
    Transform transform; ///< To the space of its parent; without one, to world space.
    bool visible = true;

    friend bool operator==(const Group&, const Group&) = default;
};

} // namespace prizma
