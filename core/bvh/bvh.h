#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"
#include "core/scene/bounds.h"
#include "core/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace prizma {

/// A node of a binary bounding volume hierarchy. Children of an inner node stand side by side.
struct BvhNode {
    Bounds bounds;
    std::uint32_t first = 0; ///< Inner: index of the left child. Leaf: first entry in `Bvh::primitives`.
    std::uint32_t count = 0; ///< Primitives of a leaf; 0 for an inner node.

    bool isLeaf() const { return count > 0; }
};

struct Bvh {
    std::vector<BvhNode> nodes;            ///< nodes[0] is the root; empty only without primitives.
    std::vector<std::uint32_t> primitives; ///< Leaves refer to ranges of this permutation.
    int depth = 0;                         ///< Edges on the longest way from the root to a leaf.
};

struct BvhBuildOptions {
    std::uint32_t maxLeafSize = 8;
    /// Bounds the stack of every traversal; held even for hostile input, unless so many primitives cannot
    /// fit.
    int maxDepth = 60;
    float traversalCost = 1.0f; ///< SAH: cost of a node ...
    float intersectionCost =
        1.0f; ///< ... and of a step in a leaf, which tests `leafWidth` primitives at a time.
    std::uint32_t leafWidth = 8; ///< Rounded up to a power of two.
};

/// Parallel binned SAH build (Wald 2007) over the primitives' boxes. Errors: cancelled.
/// Boxes that are empty or not finite are left out of the tree. Equal input gives an equal tree, whatever the
/// number of threads.
Result<Bvh> buildBvh(std::span<const Bounds> primitives, const BvhBuildOptions& options, Progress& progress);

/// The box of one of a mesh's triangles; not a number where a corner is not finite.
Bounds triangleBounds(const Mesh& mesh, std::uint32_t triangle);

/// The same over a mesh's triangles, without a list of their boxes in between.
Result<Bvh> buildBvh(const Mesh& mesh, const BvhBuildOptions& options, Progress& progress);

/// Expected cost of a random ray that meets the root's box, in units of a node visit (MacDonald and Booth
/// 1990).
double sahCost(const Bvh& bvh, const BvhBuildOptions& options);

} // namespace prizma
