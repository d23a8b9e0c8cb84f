#pragma once

#include "core/bvh/bvh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace prizma {

struct CollapsedChild {
    std::uint32_t source = 0; ///< The node of the binary tree whose box it has.
    std::uint32_t index = 0;  ///< Inner: in CollapsedTree::nodes. Leaf: in CollapsedTree::leaves.
    bool isLeaf = false;
};

struct CollapsedNode {
    std::array<CollapsedChild, 8> children;
    std::uint32_t childCount = 0;
};

/// Primitives [first, first + count) of CollapsedTree::primitives.
struct CollapsedLeaf {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct CollapsedTree {
    /// [0] is the root. Depth first, but the inner children of a node stand side by side; parents come first.
    std::vector<CollapsedNode> nodes;
    std::vector<CollapsedLeaf> leaves; ///< In the order of the nodes.
    std::vector<std::uint32_t> primitives;
    int depth = 0; ///< Nodes on the longest way from the root to a leaf.
};

/// Turns a binary tree into one of up to `width` children a node (2 to 8), choosing the nodes that stay so
/// that the expected cost is least (Ylitie et al. 2017, section 3.1). Subtrees of up to `leafSize` primitives
/// may become one leaf. There is always a root, if only one without children.
CollapsedTree collapse(const Bvh& bvh, std::uint32_t width, std::uint32_t leafSize);

} // namespace prizma
