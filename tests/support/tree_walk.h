#pragma once

#include "core/bvh/device_layout.h"

#include <QString>

#include <algorithm>
#include <optional>
#include <vector>

namespace prizma::test {

/// A child of a node of either layout.
struct Child {
    Bounds box;
    std::uint32_t reference;

    bool isMissing() const { return reference == PRIZMA_NO_CHILD; }
    bool isLeaf() const { return !isMissing() && (reference & PRIZMA_LEAF_BIT) != 0; }
};

inline std::vector<Child> childrenOf(const DeviceTree& tree, std::size_t index) {
    std::vector<Child> children;
    if (tree.layout == TreeLayout::Wide8) {
        const WideNode& n = tree.wideNodes[index];
        for (int i = 0; i < 8; ++i)
            children.push_back({{{n.bounds[0][i], n.bounds[2][i], n.bounds[4][i]},
                                 {n.bounds[1][i], n.bounds[3][i], n.bounds[5][i]}},
                                n.child[i]});
        return children;
    }
    const BinaryNode& n = tree.binaryNodes[index];
    children.push_back(
        {{{n.box0xy[0], n.box0xy[2], n.boxesZ[0]}, {n.box0xy[1], n.box0xy[3], n.boxesZ[1]}}, n.child[0]});
    children.push_back(
        {{{n.box1xy[0], n.box1xy[2], n.boxesZ[2]}, {n.box1xy[1], n.box1xy[3], n.boxesZ[3]}}, n.child[1]});
    return children;
}

/// The mesh's triangles in a leaf; nothing if the leaf does not say the same as the mesh.
inline std::optional<std::vector<std::uint32_t>> trianglesOf(const DeviceTree& tree, const Child& child,
                                                             const Mesh& mesh) {
    std::vector<std::uint32_t> triangles;
    const auto matches = [&mesh](std::uint32_t triangle, const glm::vec3& a, const glm::vec3& b,
                                 const glm::vec3& c) {
        const glm::uvec3 t = mesh.triangles.at(triangle);
        return mesh.positions[t.x] == a && mesh.positions[t.y] == b && mesh.positions[t.z] == c;
    };
    if (tree.layout == TreeLayout::Binary2) {
        const std::uint32_t count = ((child.reference & ~PRIZMA_LEAF_BIT) >> PRIZMA_LEAF_COUNT_SHIFT) + 1;
        const std::uint32_t first = child.reference & PRIZMA_LEAF_FIRST_MASK;
        for (std::uint32_t i = first; i < first + count; ++i) {
            const BinaryTriangle& t = tree.binaryTriangles.at(i);
            if (!matches(t.primitive, {t.a[0], t.a[1], t.a[2]}, {t.b[0], t.b[1], t.b[2]},
                         {t.c[0], t.c[1], t.c[2]}))
                return std::nullopt;
            triangles.push_back(t.primitive);
        }
        return triangles;
    }
    const WideLeaf& leaf = tree.wideLeaves.at(child.reference & ~PRIZMA_LEAF_BIT);
    for (int lane = 0; lane < 8; ++lane) {
        const auto corner = [&](int k) {
            return glm::vec3(leaf.corner[3 * k][lane], leaf.corner[3 * k + 1][lane],
                             leaf.corner[3 * k + 2][lane]);
        };
        if (!matches(leaf.primitive[lane], corner(0), corner(1), corner(2)))
            return std::nullopt;
        if (triangles.empty() || triangles.back() != leaf.primitive[lane]) // places beyond the last repeat it
            triangles.push_back(leaf.primitive[lane]);
    }
    return triangles;
}

inline Bounds boundsOf(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    Bounds bounds;
    for (const std::uint32_t i : triangles)
        bounds.add(triangleBounds(mesh, i));
    return bounds;
}

/// Walks the tree. Every box must be exactly around what lies below it.
class Walk {
  public:
    Walk(const DeviceTree& tree, const Mesh& mesh)
        : tree_(tree), mesh_(mesh), seen(mesh.triangles.size(), 0) {
        visit(0, 1);
    }

    QString fault() const {
        if (!fault_.isEmpty())
            return fault_;
        if (nodes_ != nodeCount(tree_))
            return "nodes that nothing refers to";
        if (std::any_of(seen.begin(), seen.end(), [](int n) { return n != 1; }))
            return "a triangle that is not in exactly one leaf";
        return depth_ == tree_.depth ? QString()
                                     : QString("depth is %1 instead of %2").arg(tree_.depth).arg(depth_);
    }

  private:
    Bounds visit(std::uint32_t index, int depth) {
        depth_ = std::max(depth_, depth);
        ++nodes_;
        Bounds whole;
        bool missing = false;
        for (const Child& child : childrenOf(tree_, index)) {
            if (child.isMissing() != child.box.isEmpty() || (missing && !child.isMissing()))
                fault_ = "a missing child with a box, or before another child";
            missing = child.isMissing();
            if (missing)
                continue;
            const Bounds content = contentOf(child, index, depth);
            if (!(content == child.box))
                fault_ = "a box that is not exactly around its content";
            whole.add(content);
        }
        return whole;
    }

    Bounds contentOf(const Child& child, std::uint32_t parent, int depth) {
        if (!child.isLeaf()) {
            if (child.reference <= parent || child.reference >= nodeCount(tree_)) {
                fault_ = "a child that does not come after its parent";
                return {};
            }
            return visit(child.reference, depth + 1);
        }
        const auto triangles = trianglesOf(tree_, child, mesh_);
        if (!triangles) {
            fault_ = "a leaf that is not what the mesh is";
            return {};
        }
        for (const std::uint32_t i : *triangles)
            ++seen[i];
        return boundsOf(mesh_, *triangles);
    }

    const DeviceTree& tree_;
    const Mesh& mesh_;
    std::vector<int> seen;
    std::size_t nodes_ = 0;
    int depth_ = 0;
    QString fault_;
};

} // namespace prizma::test
