#pragma once

#include "core/bvh/device_layout.h"

namespace prizma {

/// What a tree costs rays from anywhere: the half areas of all its boxes below the root, added up. The number
/// of nodes and leaves that a random ray visits goes with it (MacDonald and Booth 1990). It is not taken
/// relative to the whole tree's box, as SAH cost is: a part that flies away makes that box grow, which would
/// hide what it does to the tree. By how much this grows under refitting says how worn a tree is.
double treeCost(const DeviceTree& tree);

} // namespace prizma
