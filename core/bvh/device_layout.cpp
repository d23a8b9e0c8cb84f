#include "core/bvh/device_layout.h"

#include "core/bvh/collapse.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

namespace prizma {
namespace {

constexpr std::uint32_t wideLeafSize = 8;
static_assert(sizeof(WideLeaf::primitive) / sizeof(DeviceUint) == wideLeafSize);
static_assert(std::tuple_size_v<decltype(CollapsedNode::children)> ==
              sizeof(WideNode::child) / sizeof(DeviceUint));
static_assert((wideLeafSize - 1) << PRIZMA_LEAF_COUNT_SHIFT <= ~(PRIZMA_LEAF_BIT | PRIZMA_LEAF_FIRST_MASK));

constexpr std::size_t grain = 256;

/// What refers to a child; `leaf` tells how a leaf is named.
template <class LeafReference>
DeviceUint reference(const CollapsedChild& child, const LeafReference& leaf) {
    return child.isLeaf ? leaf(child.index) : child.index;
}

/// The box of a node's i-th child; inside out if it has none.
Bounds boxOf(const Bvh& bvh, const CollapsedNode& node, std::uint32_t i) {
    return i < node.childCount ? bvh.nodes[node.children[i].source].bounds : Bounds{};
}

template <class LeafReference>
WideNode wideNode(const Bvh& bvh, const CollapsedNode& node, const LeafReference& leaf) {
    WideNode result;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const Bounds box = boxOf(bvh, node, i);
        for (int axis = 0; axis < 3; ++axis) {
            result.bounds[2 * axis][i] = box.low[axis];
            result.bounds[2 * axis + 1][i] = box.high[axis];
        }
        result.child[i] = i < node.childCount ? reference(node.children[i], leaf) : PRIZMA_NO_CHILD;
    }
    return result;
}

template <class LeafReference>
BinaryNode binaryNode(const Bvh& bvh, const CollapsedNode& node, const LeafReference& leaf) {
    BinaryNode result{};
    for (std::uint32_t i = 0; i < 2; ++i) {
        const Bounds box = boxOf(bvh, node, i);
        float* xy = i == 0 ? result.box0xy : result.box1xy;
        xy[0] = box.low.x;
        xy[1] = box.high.x;
        xy[2] = box.low.y;
        xy[3] = box.high.y;
        result.boxesZ[2 * i] = box.low.z;
        result.boxesZ[2 * i + 1] = box.high.z;
        result.child[i] = i < node.childCount ? reference(node.children[i], leaf) : PRIZMA_NO_CHILD;
    }
    return result;
}

WideLeaf wideLeaf(std::span<const std::uint32_t> primitives, const Mesh& mesh) {
    WideLeaf leaf;
    for (std::uint32_t lane = 0; lane < wideLeafSize; ++lane) {
        const std::uint32_t primitive = primitives[std::min<std::size_t>(lane, primitives.size() - 1)];
        const glm::uvec3 triangle = mesh.triangles[primitive];
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                leaf.corner[3 * corner + axis][lane] = mesh.positions[triangle[corner]][axis];
        leaf.primitive[lane] = primitive;
    }
    return leaf;
}

BinaryTriangle binaryTriangle(std::uint32_t primitive, const Mesh& mesh) {
    const glm::uvec3 triangle = mesh.triangles[primitive];
    const glm::vec3 a = mesh.positions[triangle.x];
    const glm::vec3 b = mesh.positions[triangle.y];
    const glm::vec3 c = mesh.positions[triangle.z];
    return {{a.x, a.y, a.z}, primitive, {b.x, b.y, b.z}, 0.0f, {c.x, c.y, c.z}, 0.0f};
}

/// Node indices by height above the leaves. Parents come before their children in `tree.nodes`.
std::vector<std::vector<std::uint32_t>> levelsOf(const CollapsedTree& tree) {
    std::vector<std::uint32_t> heights(tree.nodes.size(), 0);
    std::vector<std::vector<std::uint32_t>> levels;
    for (auto index = static_cast<std::uint32_t>(tree.nodes.size()); index-- > 0;) {
        const CollapsedNode& node = tree.nodes[index];
        for (const CollapsedChild& child : std::span(node.children).first(node.childCount))
            if (!child.isLeaf)
                heights[index] = std::max(heights[index], heights[child.index] + 1);
        if (heights[index] >= levels.size())
            levels.resize(heights[index] + 1);
        levels[heights[index]].push_back(index);
    }
    for (std::vector<std::uint32_t>& level : levels)
        std::reverse(level.begin(), level.end()); // in the order of memory
    return levels;
}

template <class Node, class Convert>
void convertNodes(const CollapsedTree& tree, std::vector<Node>& nodes, const Convert& convert) {
    nodes.resize(tree.nodes.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size(), grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            nodes[i] = convert(tree.nodes[i]);
    });
}

/// Fills in the nodes and what both levels have in common.
template <class LeafReference>
DeviceTree layOutNodes(const Bvh& bvh, const CollapsedTree& tree, TreeLayout layout,
                       const LeafReference& leaf) {
    DeviceTree result;
    result.layout = layout;
    result.depth = tree.depth;
    assert(result.depth <= PRIZMA_MAX_TREE_DEPTH);
    result.refitLevels = levelsOf(tree);
    if (layout == TreeLayout::Wide8)
        convertNodes(tree, result.wideNodes,
                     [&](const CollapsedNode& node) { return wideNode(bvh, node, leaf); });
    else
        convertNodes(tree, result.binaryNodes,
                     [&](const CollapsedNode& node) { return binaryNode(bvh, node, leaf); });
    return result;
}

DeviceTree layOutWide(const Bvh& bvh, const CollapsedTree& tree, const Mesh& mesh) {
    const auto reference = [](std::uint32_t leaf) { return PRIZMA_LEAF_BIT | leaf; };
    DeviceTree result = layOutNodes(bvh, tree, TreeLayout::Wide8, reference);
    result.wideLeaves.resize(tree.leaves.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.leaves.size(), grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const CollapsedLeaf& leaf = tree.leaves[i];
            result.wideLeaves[i] = wideLeaf(std::span(tree.primitives).subspan(leaf.first, leaf.count), mesh);
        }
    });
    return result;
}

DeviceTree layOutBinary(const Bvh& bvh, const CollapsedTree& tree, const Mesh& mesh) {
    const auto reference = [&tree](std::uint32_t index) {
        const CollapsedLeaf& leaf = tree.leaves[index];
        return PRIZMA_LEAF_BIT | (leaf.count - 1) << PRIZMA_LEAF_COUNT_SHIFT | leaf.first;
    };
    DeviceTree result = layOutNodes(bvh, tree, TreeLayout::Binary2, reference);
    result.binaryTriangles.resize(tree.primitives.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.primitives.size(), grain),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                              result.binaryTriangles[i] = binaryTriangle(tree.primitives[i], mesh);
                      });
    return result;
}

} // namespace

std::size_t nodeCount(const DeviceTree& tree) {
    return tree.layout == TreeLayout::Wide8 ? tree.wideNodes.size() : tree.binaryNodes.size();
}

std::size_t leafCount(const DeviceTree& tree) {
    return tree.layout == TreeLayout::Wide8 ? tree.wideLeaves.size() : tree.binaryTriangles.size();
}

DeviceTree layOutBottomLevel(const Bvh& bvh, const Mesh& mesh, TreeLayout layout) {
    assert(std::all_of(bvh.nodes.begin(), bvh.nodes.end(),
                       [](auto& node) { return node.count <= wideLeafSize; }));
    return layout == TreeLayout::Wide8 ? layOutWide(bvh, collapse(bvh, 8, wideLeafSize), mesh)
                                       : layOutBinary(bvh, collapse(bvh, 2, 0), mesh);
}

DeviceTree layOutTopLevel(const Bvh& bvh, TreeLayout layout) {
    assert(std::all_of(bvh.nodes.begin(), bvh.nodes.end(), [](auto& node) { return node.count <= 1; }));
    const CollapsedTree tree = collapse(bvh, layout == TreeLayout::Wide8 ? 8 : 2, 0);
    return layOutNodes(bvh, tree, layout, [&tree](std::uint32_t leaf) {
        return PRIZMA_LEAF_BIT | tree.primitives[tree.leaves[leaf].first];
    });
}

} // namespace prizma
