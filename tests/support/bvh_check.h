#pragma once

#include "core/bvh/bvh.h"

#include <QString>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace prizma::test {

using Boxes = std::vector<Bounds>;

inline Boxes randomBoxes(std::size_t count, unsigned seed, float size = 0.01f) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::uniform_real_distribution<float> extent(0.0f, size);
    Boxes boxes(count);
    for (Bounds& box : boxes) {
        box.low = {place(random), place(random), place(random)};
        box.high = box.low + glm::vec3(extent(random), extent(random), extent(random));
    }
    return boxes;
}

/// What is wrong with a tree over `boxes`, of which `expected` belong into it; empty if nothing.
inline QString faultOf(const Bvh& bvh, const Boxes& boxes, std::size_t expected,
                       const BvhBuildOptions& options) {
    if (expected == 0)
        return bvh.nodes.empty() && bvh.primitives.empty() ? "" : "a tree over nothing";
    if (bvh.primitives.size() != expected)
        return QString("%1 primitives instead of %2").arg(bvh.primitives.size()).arg(expected);
    struct Step {
        std::uint32_t node;
        int depth;
    };
    std::vector<Step> steps{{0, 0}};
    std::vector<int> reached(bvh.nodes.size(), 0);
    std::vector<int> seen(boxes.size(), 0);
    int depth = 0;
    while (!steps.empty()) {
        const Step step = steps.back();
        steps.pop_back();
        if (step.node >= bvh.nodes.size() || ++reached[step.node] > 1)
            return "a node outside the tree or reached twice";
        depth = std::max(depth, step.depth);
        const BvhNode& node = bvh.nodes[step.node];
        Bounds content;
        if (!node.isLeaf()) {
            if (node.first <= step.node || node.first + 1 >= bvh.nodes.size())
                return "a child that does not come after its parent";
            for (const std::uint32_t child : {node.first, node.first + 1}) {
                content.add(bvh.nodes[child].bounds);
                steps.push_back({child, step.depth + 1});
            }
        } else {
            if (node.count > options.maxLeafSize)
                return QString("a leaf of %1").arg(node.count);
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                content.add(boxes.at(bvh.primitives.at(i)));
                ++seen[bvh.primitives[i]];
            }
        }
        if (!(content == node.bounds))
            return "a box that is not exactly around its content";
    }
    if (std::count(reached.begin(), reached.end(), 1) != static_cast<std::ptrdiff_t>(bvh.nodes.size()))
        return "a node that nothing refers to";
    if (*std::max_element(seen.begin(), seen.end()) > 1)
        return "a primitive in two leaves";
    if (depth != bvh.depth)
        return QString("depth %1 is said to be %2").arg(depth).arg(bvh.depth);
    return depth > options.maxDepth ? QString("depth %1").arg(depth) : QString();
}

inline Bvh build(const Boxes& boxes, const BvhBuildOptions& options = {}) {
    Progress progress;
    auto bvh = buildBvh(boxes, options, progress);
    return bvh ? *bvh : Bvh{};
}

/// Whether two trees are equal in every node and leaf.
inline bool areEqual(const Bvh& a, const Bvh& b) {
    return a.depth == b.depth && a.primitives == b.primitives &&
           std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const BvhNode& x, const BvhNode& y) {
                          return x.bounds == y.bounds && x.first == y.first && x.count == y.count;
                      });
}

} // namespace prizma::test
