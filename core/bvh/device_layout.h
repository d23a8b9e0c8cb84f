#pragma once

#include "core/bvh/bvh.h"
#include "core/scene/mesh.h"
#include "kernels/device_types.h"

#include <span>
#include <vector>

namespace prizma {

/// How trees lie in device memory: see kernels/device_types.h.
enum class TreeLayout {
    Wide8,   ///< For CPU devices: 8-wide nodes, eight triangles a leaf, in structure-of-arrays form.
    Binary2, ///< For GPU devices: 64-byte nodes that hold both children's boxes.
};

/// A tree as the device wants it. Indices inside are relative to its own first node and leaf, so that it can
/// be placed anywhere in a larger buffer. Only the arrays of one layout are filled.
struct DeviceTree {
    TreeLayout layout = TreeLayout::Wide8;
    std::vector<WideNode> wideNodes; ///< [0] is the root.
    std::vector<WideLeaf> wideLeaves;
    std::vector<BinaryNode> binaryNodes;
    std::vector<BinaryTriangle> binaryTriangles;
    int depth = 0; ///< Of the device tree; at most maxTreeDepth of kernels/device_types.h.

    /// Node indices by height: level 0 holds the nodes whose children are leaves only, each later level those
    /// whose inner children are all in earlier levels. Refit runs one level after the other.
    std::vector<std::vector<std::uint32_t>> refitLevels;
};

std::size_t nodeCount(const DeviceTree& tree);

/// Items of its leaf array: leaves in Wide8, triangles in Binary2.
std::size_t leafCount(const DeviceTree& tree);

/// Lays a tree over a mesh's triangles out for tracing; for Wide8 the binary nodes are collapsed to the
/// eight-wide ones of least expected cost (Ylitie et al. 2017). `bvh` was built over `mesh`, with leaves of
/// up to 8 triangles.
DeviceTree layOutBottomLevel(const Bvh& bvh, const Mesh& mesh, TreeLayout layout);

/// Lays a tree over instances out: leaves hold one instance index each, no leaf array is filled.
/// `bvh` was built with maxLeafSize 1.
DeviceTree layOutTopLevel(const Bvh& bvh, TreeLayout layout);

} // namespace prizma
