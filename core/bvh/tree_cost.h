#pragma once

#include "core/bvh/device_layout.h"

namespace prizma {

/// What a tree costs a ray: the half areas of all its boxes, relative to that of the whole tree's box. That
/// is how many nodes and leaves a random ray that meets the tree visits, beside the root (MacDonald and Booth
/// 1990). Refitting moves boxes about; by how much this grows says how worn a tree is. 0 for a tree without
/// area.
double treeCost(const DeviceTree& tree);

/// The same from the sum of the half areas. Not finite where the numbers overflow.
double treeCost(double areaSum, const Bounds& whole);

} // namespace prizma
