#pragma once

#include "core/render/light_bounds.h"
#include "kernels/device_types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace prizma {

/// A binary tree over emitters, one a leaf, from which kernels/light_tree.clh chooses.
struct LightTree {
    std::vector<DeviceLightNode> nodes; ///< [0] is the root; empty without emitters.
    std::vector<std::uint32_t> leafOf;  ///< Each emitter's node.
};

/// Splits where the surface area orientation heuristic of Conty Estevez and Kulla (2018) says. All emitters
/// have a power above 0 and a finite box. Uses several threads; the tree does not depend on how many.
LightTree buildLightTree(std::span<const LightBounds> emitters);

} // namespace prizma
