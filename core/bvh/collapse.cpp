#include "core/bvh/collapse.h"

#include "core/bvh/float4.h"

#include <algorithm>
#include <limits>
#include <span>

namespace prizma {
namespace {

constexpr std::uint32_t maxWidth = 8;
constexpr float nodeCost = 1.0f; ///< Of visiting a wide node, ...
constexpr float leafCost = 1.0f; ///< ... and a leaf, which is tested as a whole.

/// A node of the binary tree: [i - 1] is the least cost of standing for it with at most i wide children.
using Costs = std::array<float, maxWidth>;

class Collapser {
  public:
    Collapser(const Bvh& bvh, std::uint32_t width, std::uint32_t leafSize)
        : bvh_(bvh), width_(width), leafSize_(leafSize) {}

    CollapsedTree run();

  private:
    void computeCosts();
    Costs costsOf(const BvhNode& node, float visit) const;
    void gather(std::uint32_t source, std::uint32_t slots);
    void gatherBelow(std::uint32_t source, std::uint32_t slots);
    void sortChildren();
    void layOut();
    std::uint32_t emitLeaf(std::uint32_t source);

    const Bvh& bvh_;
    std::uint32_t width_;
    std::uint32_t leafSize_;
    float areaScale_ = 1.0f;
    std::vector<Costs> costs_;
    std::vector<std::uint32_t> primitiveCounts_; ///< Below each node.
    std::vector<std::uint8_t> isLeaf_;           ///< Whether a node is a leaf if it is a child.
    CollapsedTree tree_;
    std::array<std::uint32_t, maxWidth> children_{}; ///< Of the node in work, as nodes of the binary tree.
    std::uint32_t childCount_ = 0;
};

/// Costs of an inner node that stays inner.
Costs Collapser::costsOf(const BvhNode& node, float visit) const {
    constexpr float none = std::numeric_limits<float>::infinity();
    // shared[i]: both children together with at most i + 1 places.
    std::array<float, maxWidth> shared;
    shared.fill(none);
    const Costs& left = costs_[node.first];
    const Costs& right = costs_[node.first + 1];
    for (std::uint32_t l = 0; l + 1 < width_; ++l)
        for (std::uint32_t r = 0; l + r + 1 < width_; ++r)
            shared[l + r + 1] = std::min(shared[l + r + 1], left[l] + right[r]);
    Costs costs;
    costs[0] = visit + shared[width_ - 1];
    for (std::uint32_t i = 1; i < maxWidth; ++i)
        costs[i] = std::min(costs[i - 1], shared[i]);
    return costs;
}

/// From the leaves to the root: children come after their parents in `bvh_.nodes`.
void Collapser::computeCosts() {
    areaScale_ = areaScale(Box4::of(bvh_.nodes.front().bounds));
    costs_.resize(bvh_.nodes.size());
    primitiveCounts_.resize(bvh_.nodes.size());
    isLeaf_.resize(bvh_.nodes.size());
    for (std::size_t i = bvh_.nodes.size(); i-- > 0;) {
        const BvhNode& node = bvh_.nodes[i];
        const float area = scaledHalfArea(Box4::of(node.bounds), areaScale_);
        const float asLeaf = area * leafCost;
        if (node.isLeaf()) {
            isLeaf_[i] = true;
            primitiveCounts_[i] = node.count;
            costs_[i].fill(asLeaf);
            continue;
        }
        primitiveCounts_[i] = primitiveCounts_[node.first] + primitiveCounts_[node.first + 1];
        costs_[i] = costsOf(node, area * nodeCost);
        if (primitiveCounts_[i] <= leafSize_ && asLeaf <= costs_[i][0]) {
            isLeaf_[i] = true;
            for (float& cost : costs_[i])
                cost = std::min(cost, asLeaf);
        }
    }
}

/// Adds what stands for a node of the binary tree in at most `slots` children.
void Collapser::gather(std::uint32_t source, std::uint32_t slots) {
    const Costs& costs = costs_[source];
    // Where there is no surface at all, costs say nothing: then as wide as possible.
    const bool isCheaper =
        slots > 1 && (costs[slots - 1] < costs[0] || (costs[0] == 0.0f && isLeaf_[source] == 0));
    const bool opens = !bvh_.nodes[source].isLeaf() && isCheaper;
    if (opens)
        gatherBelow(source, slots);
    else
        children_[childCount_++] = source;
}

/// Hands `slots` children out to both children of an inner node, at the least cost.
void Collapser::gatherBelow(std::uint32_t source, std::uint32_t slots) {
    const std::uint32_t left = bvh_.nodes[source].first;
    std::uint32_t best = 1;
    for (std::uint32_t i = 2; i < slots; ++i)
        if (costs_[left][i - 1] + costs_[left + 1][slots - i - 1] <
            costs_[left][best - 1] + costs_[left + 1][slots - best - 1])
            best = i;
    gather(left, best);
    gather(left + 1, slots - best);
}

std::uint32_t Collapser::emitLeaf(std::uint32_t source) {
    const auto first = static_cast<std::uint32_t>(tree_.primitives.size());
    std::array<std::uint32_t, 64> waiting; // a leaf's subtree has at most leafSize_ nodes with primitives
    std::uint32_t count = 1;
    waiting[0] = source;
    while (count > 0) {
        const BvhNode& node = bvh_.nodes[waiting[--count]];
        if (node.isLeaf()) {
            const auto begin = bvh_.primitives.begin() + node.first;
            tree_.primitives.insert(tree_.primitives.end(), begin, begin + node.count);
        } else {
            waiting[count++] = node.first + 1;
            waiting[count++] = node.first;
        }
    }
    tree_.leaves.push_back({first, primitiveCounts_[source]});
    return static_cast<std::uint32_t>(tree_.leaves.size() - 1);
}

/// Rays that end at their first hit visit children as they stand: inner ones first, the larger before the
/// smaller, as what holds most is most likely to end them. For all other rays distances decide.
void Collapser::sortChildren() {
    struct Place {
        bool isInner;
        float area;
        std::uint32_t child;
    };
    std::array<Place, maxWidth> order;
    for (std::uint32_t i = 0; i < childCount_; ++i) {
        const std::uint32_t child = children_[i];
        order[i] = {isLeaf_[child] == 0, scaledHalfArea(Box4::of(bvh_.nodes[child].bounds), areaScale_),
                    child};
    }
    std::stable_sort(order.begin(), order.begin() + childCount_, [](const Place& a, const Place& b) {
        return a.isInner != b.isInner ? a.isInner : a.area > b.area;
    });
    for (std::uint32_t i = 0; i < childCount_; ++i)
        children_[i] = order[i].child;
}

void Collapser::layOut() {
    tree_.nodes.reserve(bvh_.nodes.size() / width_ + 1);
    tree_.leaves.reserve(bvh_.nodes.size() / 2 + 1);
    tree_.primitives.reserve(bvh_.primitives.size());
    struct Step {
        std::uint32_t source, place;
        int depth;
    };
    std::vector<Step> steps{{0, 0, 1}};
    while (!steps.empty()) {
        const Step step = steps.back();
        steps.pop_back();
        tree_.depth = std::max(tree_.depth, step.depth);
        childCount_ = 0;
        if (isLeaf_[step.source])
            children_[childCount_++] = step.source;
        else
            gatherBelow(step.source, width_);
        sortChildren();
        auto next = static_cast<std::uint32_t>(tree_.nodes.size());
        CollapsedNode& node = tree_.nodes[step.place];
        node.childCount = childCount_;
        for (std::uint32_t i = 0; i < childCount_; ++i) {
            const bool leaf = isLeaf_[children_[i]] != 0;
            node.children[i] = {children_[i], leaf ? emitLeaf(children_[i]) : next++, leaf};
        }
        for (std::uint32_t i = childCount_; i-- > 0;) // the last pushed is the next to be laid out
            if (!node.children[i].isLeaf)
                steps.push_back({children_[i], node.children[i].index, step.depth + 1});
        tree_.nodes.resize(next);
    }
}

CollapsedTree Collapser::run() {
    tree_.nodes.emplace_back();
    if (!bvh_.nodes.empty()) {
        computeCosts();
        layOut();
    }
    return std::move(tree_);
}

} // namespace

CollapsedTree collapse(const Bvh& bvh, std::uint32_t width, std::uint32_t leafSize) {
    return Collapser(bvh, width, leafSize).run();
}

} // namespace prizma
