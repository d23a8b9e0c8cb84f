#include "core/bvh/reinsertion.h"

#include "core/bvh/float4.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace prizma {
namespace {

constexpr std::uint32_t root = 1;             ///< So that pairs of children begin at even places.
constexpr std::size_t leastCandidates = 1000; ///< Small trees can afford all of their nodes.
constexpr std::size_t searchBlock = 4096;     ///< Searches between two looks at `progress`.
constexpr std::size_t grain = 64;             ///< Searches a task.

/// A node's box with what it holds in a spare lane: the first of its two children or, for a leaf, its place
/// in the tree that it came from.
struct WorkNode {
    Float4 low;
    Float4 high;

    static WorkNode inner(const Box4& box, std::uint32_t firstChild) { return make(box, firstChild); }
    static WorkNode leaf(const Box4& box, std::uint32_t source) { return make(box, source | leafBit); }

    bool isLeaf() const { return (content() & leafBit) != 0; }
    std::uint32_t firstChild() const { return content() & ~(indexBias | leafBit); }
    std::uint32_t source() const { return content() & ~(indexBias | leafBit); }
    Box4 box() const { return {low, high}; }
    void setBox(const Box4& box) { *this = make(box, content()); }

  private:
    static constexpr std::uint32_t leafBit = 0x80000000u;
    static constexpr std::uint32_t indexBias = 0x40000000u; ///< As in Fragment.

    std::uint32_t content() const { return std::bit_cast<std::uint32_t>(low[3]); }
    static WorkNode make(const Box4& box, std::uint32_t content) {
        WorkNode node{box.low, box.high};
        node.low[3] = std::bit_cast<float>(content | indexBias);
        node.high[3] = 0.0f;
        return node;
    }
};

/// Two children fill a cache line.
struct alignas(64) Siblings {
    WorkNode nodes[2];
};

Box4 unionOf(const Box4& a, const Box4& b) {
    return {minOf(a.low, b.low), maxOf(a.high, b.high)};
}

/// Taking `node` out of the tree and putting it beside `target`, under a parent of their own.
struct Move {
    std::uint32_t node = 0;
    std::uint32_t target = 0;
    float gain = 0.0f; ///< How much less surface all inner nodes have afterwards.
};

class Reinserter {
  public:
    Reinserter(const Bvh& bvh, const ReinsertionOptions& options, Progress& progress);

    bool run();
    Bvh result() const;

  private:
    /// A node that a search has yet to look at. `saved` is what the move gains if nothing but the boxes above
    /// this node had to grow for it.
    struct Waiting {
        std::uint32_t node;
        float saved;
    };
    using Stack = std::vector<Waiting>;

    WorkNode& at(std::uint32_t node) { return pairs_[node >> 1].nodes[node & 1]; }
    const WorkNode& at(std::uint32_t node) const { return pairs_[node >> 1].nodes[node & 1]; }
    static std::uint32_t siblingOf(std::uint32_t node) { return node ^ 1u; }
    float areaOf(const Box4& box) const { return scaledHalfArea(box, scale_); }
    float areaOf(std::uint32_t node) const { return areaOf(at(node).box()); }

    std::vector<std::uint32_t> candidates() const;
    std::vector<Move> findMoves(const std::vector<std::uint32_t>& nodes) const;
    Move bestMoveOf(std::uint32_t node, Stack& stack) const;
    void searchBelow(std::uint32_t start, float saved, const Box4& box, Move& best, Stack& stack) const;

    void makeMoves(const std::vector<Move>& moves);
    float gainNow(const Move& move) const;
    bool fits(const Move& move) const;
    void make(const Move& move);
    void put(std::uint32_t place, const WorkNode& node, std::int32_t height);
    void refitFrom(std::uint32_t node);
    std::uint32_t commonAncestor(std::uint32_t a, std::uint32_t b) const;
    int depthOf(std::uint32_t node) const;

    const Bvh& bvh_;
    const ReinsertionOptions options_;
    Progress& progress_;
    float scale_ = 1.0f;
    int maxDepth_ = 0;
    std::uint32_t end_ = 0; ///< After the last node.
    std::vector<Siblings> pairs_;
    std::vector<std::uint32_t> parents_;
    std::vector<std::int32_t> heights_; ///< Edges to the deepest leaf below.
};

Reinserter::Reinserter(const Bvh& bvh, const ReinsertionOptions& options, Progress& progress)
    : bvh_(bvh),
      options_(options),
      progress_(progress),
      scale_(areaScale(Box4::of(bvh.nodes.front().bounds))),
      maxDepth_(std::max(options.maxDepth, bvh.depth)),
      end_(static_cast<std::uint32_t>(bvh.nodes.size()) + root),
      pairs_(end_ / 2 + 1),
      parents_(end_, 0),
      heights_(end_, 0) {
    for (std::uint32_t node = end_; node-- > root;) { // children come after their parents
        const BvhNode& source = bvh.nodes[node - root];
        const Box4 box = Box4::of(source.bounds);
        if (source.isLeaf()) {
            at(node) = WorkNode::leaf(box, node - root);
            continue;
        }
        const std::uint32_t child = source.first + root;
        at(node) = WorkNode::inner(box, child);
        parents_[child] = parents_[child + 1] = node;
        heights_[node] = 1 + std::max(heights_[child], heights_[child + 1]);
    }
}

/// The nodes of the largest boxes. A root and its children have nowhere to go.
std::vector<std::uint32_t> Reinserter::candidates() const {
    std::vector<std::pair<float, std::uint32_t>> order;
    order.reserve(end_);
    for (std::uint32_t node = root + 1; node < end_; ++node)
        if (parents_[node] != root)
            order.emplace_back(-areaOf(node), node);
    const auto share = static_cast<std::size_t>(static_cast<double>(order.size()) * double(options_.share));
    const std::size_t count = std::min(std::max(share, leastCandidates), order.size());
    if (count < order.size())
        std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    std::vector<std::uint32_t> nodes(count);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = order[i].second;
    std::sort(nodes.begin(), nodes.end()); // neighbours in memory are neighbours in space
    return nodes;
}

/// The moves that gain anything, the best first.
std::vector<Move> Reinserter::findMoves(const std::vector<std::uint32_t>& nodes) const {
    std::vector<Move> moves(nodes.size());
    for (std::size_t first = 0; first < nodes.size() && !progress_.isCancelled(); first += searchBlock) {
        const tbb::blocked_range<std::size_t> block(first, std::min(first + searchBlock, nodes.size()),
                                                    grain);
        tbb::parallel_for(block, [&](const auto& range) {
            Stack stack;
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                moves[i] = bestMoveOf(nodes[i], stack);
        });
    }
    std::erase_if(moves, [](const Move& move) { return move.target == 0; });
    tbb::parallel_sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) {
        return a.gain != b.gain ? a.gain > b.gain : a.node < b.node;
    });
    return moves;
}

/// Goes up from the node, and at each step through what lies on the other side.
Move Reinserter::bestMoveOf(std::uint32_t node, Stack& stack) const {
    const Box4 box = at(node).box();
    Move best{node, 0, 0.0f};
    std::uint32_t pivot = parents_[node];
    std::uint32_t side = siblingOf(node);
    float saved = areaOf(pivot); // the parent goes
    Box4 rest = at(side).box();  // what is left below the pivot
    searchBelow(side, saved, box, best, stack);
    while (pivot != root) {
        side = siblingOf(pivot);
        searchBelow(side, saved, box, best, stack);
        rest = unionOf(rest, at(side).box());
        pivot = parents_[pivot];
        saved += areaOf(pivot) - areaOf(rest);
    }
    return best;
}

void Reinserter::searchBelow(std::uint32_t start, float saved, const Box4& box, Move& best,
                             Stack& stack) const {
    const float area = areaOf(box);
    stack.push_back({start, saved});
    while (!stack.empty()) {
        const Waiting waiting = stack.back();
        stack.pop_back();
        if (waiting.saved - area <= best.gain) // the new parent is at least as large
            continue;
        const WorkNode& target = at(waiting.node);
        const float merged = areaOf(unionOf(target.box(), box));
        const float gain = waiting.saved - merged;
        if (gain > best.gain) {
            best.gain = gain;
            best.target = waiting.node;
        }
        if (target.isLeaf())
            continue;
        const float below = waiting.saved - (merged - areaOf(target.box()));
        if (below - area <= best.gain)
            continue;
        stack.push_back({target.firstChild(), below});
        stack.push_back({target.firstChild() + 1, below});
    }
}

int Reinserter::depthOf(std::uint32_t node) const {
    int depth = 0;
    for (; node != root; node = parents_[node])
        ++depth;
    return depth;
}

std::uint32_t Reinserter::commonAncestor(std::uint32_t a, std::uint32_t b) const {
    int depthA = depthOf(a);
    int depthB = depthOf(b);
    while (a != b)
        if (depthA >= depthB) {
            a = parents_[a];
            --depthA;
        } else {
            b = parents_[b];
            --depthB;
        }
    return a;
}

/// What a move gains in the tree as it is by now; nothing if it has become impossible.
float Reinserter::gainNow(const Move& move) const {
    const std::uint32_t parent = parents_[move.node];
    const std::uint32_t sibling = siblingOf(move.node);
    if (parent == root || move.target == root || move.target == parent || move.target == sibling)
        return 0.0f;
    const std::uint32_t top = commonAncestor(move.node, move.target);
    if (top == move.node || top == move.target)
        return 0.0f;
    const Box4 box = at(move.node).box();
    float gain = areaOf(parent);
    Box4 rest = at(sibling).box();
    // With a target below the sibling nothing above the parent changes.
    for (std::uint32_t node = parent; node != top && parents_[node] != top;) {
        rest = unionOf(rest, at(siblingOf(node)).box());
        node = parents_[node];
        gain += areaOf(node) - areaOf(rest);
    }
    gain -= areaOf(unionOf(at(move.target).box(), box));
    for (std::uint32_t node = parents_[move.target]; node != top; node = parents_[node])
        gain -= areaOf(unionOf(at(node).box(), box)) - areaOf(node);
    return gain;
}

bool Reinserter::fits(const Move& move) const {
    const int height = std::max(heights_[move.node], heights_[move.target]);
    return depthOf(move.target) + 1 + height <= maxDepth_;
}

/// Fills a place anew; children learn of their parent.
void Reinserter::put(std::uint32_t place, const WorkNode& node, std::int32_t height) {
    at(place) = node;
    heights_[place] = height;
    if (!node.isLeaf())
        parents_[node.firstChild()] = parents_[node.firstChild() + 1] = place;
}

/// Boxes and heights from an inner node up to the root.
void Reinserter::refitFrom(std::uint32_t node) {
    while (true) {
        const std::uint32_t child = at(node).firstChild();
        at(node).setBox(unionOf(at(child).box(), at(child + 1).box()));
        heights_[node] = 1 + std::max(heights_[child], heights_[child + 1]);
        if (node == root)
            return;
        node = parents_[node];
    }
}

/// The sibling moves up into the parent's place, and what was the target into the sibling's, so that pairs
/// stay pairs.
void Reinserter::make(const Move& move) {
    const std::uint32_t parent = parents_[move.node];
    const std::uint32_t sibling = siblingOf(move.node);
    put(parent, at(sibling), heights_[sibling]);
    put(sibling, at(move.target), heights_[move.target]);
    const std::uint32_t first = std::min(move.node, sibling);
    put(move.target, WorkNode::inner(at(move.target).box(), first), 0);
    refitFrom(move.target);
    refitFrom(parents_[parent]);
}

void Reinserter::makeMoves(const std::vector<Move>& moves) {
    for (const Move& move : moves)
        if (gainNow(move) > 0.0f && fits(move))
            make(move);
}

bool Reinserter::run() {
    for (int pass = 0; pass < options_.passes; ++pass) {
        const std::vector<Move> moves = findMoves(candidates());
        if (progress_.isCancelled())
            return false;
        makeMoves(moves);
        progress_.set(double(pass + 1) / options_.passes);
    }
    return true;
}

/// In the order in which the builder lays trees out, parents first and each subtree in one piece.
Bvh Reinserter::result() const {
    Bvh bvh;
    bvh.nodes.reserve(bvh_.nodes.size());
    bvh.primitives.reserve(bvh_.primitives.size());
    bvh.nodes.emplace_back();
    bvh.depth = heights_[root];
    struct Step {
        std::uint32_t node, place;
    };
    std::vector<Step> steps{{root, 0}};
    while (!steps.empty()) {
        const auto [node, place] = steps.back();
        steps.pop_back();
        if (at(node).isLeaf()) {
            const BvhNode& source = bvh_.nodes[at(node).source()];
            bvh.nodes[place] = {source.bounds, static_cast<std::uint32_t>(bvh.primitives.size()),
                                source.count};
            const auto first = bvh_.primitives.begin() + source.first;
            bvh.primitives.insert(bvh.primitives.end(), first, first + source.count);
            continue;
        }
        const auto next = static_cast<std::uint32_t>(bvh.nodes.size());
        bvh.nodes[place] = {at(node).box().bounds(), next, 0};
        bvh.nodes.resize(next + 2);
        steps.push_back({at(node).firstChild() + 1, next + 1});
        steps.push_back({at(node).firstChild(), next});
    }
    return bvh;
}

} // namespace

bool reinsertNodes(Bvh& bvh, const ReinsertionOptions& options, Progress& progress) {
    if (bvh.nodes.size() < 5) // no node has anywhere to go
        return !progress.isCancelled();
    Reinserter reinserter(bvh, options, progress);
    if (!reinserter.run())
        return false;
    bvh = reinserter.result();
    return true;
}

} // namespace prizma
