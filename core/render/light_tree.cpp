#include "core/render/light_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace prizma {
namespace {

constexpr std::uint32_t binCount = 12;
constexpr std::uint32_t taskSize = 2048;    ///< Larger subtrees are built beside each other.
constexpr std::uint32_t allAxesSize = 1024; ///< Larger nodes are split along their longest side only.
constexpr std::uint32_t balancedDepth = 48; ///< From here on nodes are halved, so that no tree is deep.

float sideMeasure(const LightBounds& bounds) {
    const glm::vec3 extent = bounds.box.extent();
    return glm::dot(extent, extent); // not the area: lights in a row have none
}

float cost(const LightBounds& bounds) {
    return bounds.power > 0.0f ? bounds.power * orientationMeasure(bounds) * sideMeasure(bounds) : 0.0f;
}

/// The bounds of the emitters in a bin. Its cone is about their mean direction and not the smallest: it only
/// serves to compare splits, of which there are many.
class Bin {
  public:
    Bin() { bounds_.emission = 0.0f; }

    /// First all emitters are added,
    void add(const LightBounds& emitter) {
        bounds_.box.add(emitter.box);
        bounds_.power += emitter.power;
        bounds_.emission = std::max(bounds_.emission, emitter.emission);
        bounds_.twoSided = bounds_.twoSided || emitter.twoSided;
        bounds_.moves = bounds_.moves || emitter.moves;
        sum_ += emitter.twoSided && glm::dot(sum_, emitter.normals.axis) < 0.0f ? -emitter.normals.axis
                                                                                : emitter.normals.axis;
    }

    /// then each opens the cone so far that it is inside.
    void open(const LightBounds& emitter) {
        const float length = glm::length(sum_);
        float cosine = length > 0.0f ? glm::dot(sum_, emitter.normals.axis) / length : -1.0f;
        if (emitter.twoSided)
            cosine = std::abs(cosine);
        if (emitter.normals.angle == 0.0f)
            cosine_ = std::min(cosine_, cosine);
        else
            angle_ = std::max(angle_, std::acos(std::clamp(cosine, -1.0f, 1.0f)) + emitter.normals.angle);
    }

    LightBounds bounds() const {
        LightBounds result = bounds_;
        const float length = glm::length(sum_);
        if (length > 0.0f)
            result.normals = {
                sum_ / length,
                std::min(std::max(angle_, std::acos(std::clamp(cosine_, -1.0f, 1.0f))), glm::pi<float>())};
        return result;
    }

  private:
    LightBounds bounds_;
    glm::vec3 sum_{0.0f};
    float cosine_ = 1.0f, angle_ = 0.0f;
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    float place = 0.0f;
};

class Builder {
  public:
    explicit Builder(std::span<const LightBounds> emitters) : emitters_(emitters), order_(emitters.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        tree_.nodes.resize(2 * emitters.size() - 1);
        tree_.leafOf.resize(emitters.size());
    }

    LightTree take() && {
        build(0, 0, static_cast<std::uint32_t>(emitters_.size()), 1, 0, 0);
        return std::move(tree_);
    }

  private:
    /// Makes `node` from emitters [first, end) of the order; all nodes below it lie from `below` on.
    LightBounds build(std::uint32_t node, std::uint32_t first, std::uint32_t end, std::uint32_t below,
                      std::uint32_t parent, std::uint32_t depth) {
        const std::uint32_t count = end - first;
        if (count == 1) {
            tree_.leafOf[order_[first]] = node;
            return write(node, parent, PRIZMA_LEAF_BIT | order_[first], emitters_[order_[first]]);
        }
        const std::uint32_t middle = partition(first, end, depth);
        LightBounds left, right;
        const auto buildLeft = [&] { left = build(below, first, middle, below + 2, node, depth + 1); };
        const auto buildRight = [&] {
            right = build(below + 1, middle, end, below + 2 * (middle - first), node, depth + 1);
        };
        if (count > taskSize) {
            tbb::parallel_invoke(buildLeft, buildRight);
        } else {
            buildLeft();
            buildRight();
        }
        return write(node, parent, below, unite(left, right));
    }

    LightBounds write(std::uint32_t index, std::uint32_t parent, std::uint32_t child,
                      const LightBounds& bounds) {
        DeviceLightNode& node = tree_.nodes[index];
        for (int i = 0; i < 3; ++i) {
            node.low[i] = bounds.box.low[i];
            node.high[i] = bounds.box.high[i];
            node.axis[i] = bounds.normals.axis[i];
        }
        node.child = child;
        node.parent = parent;
        node.power = std::min(bounds.power, 1e30f);
        node.cosCone = std::cos(std::min(bounds.normals.angle, glm::pi<float>()));
        node.cosEmission = std::cos(std::min(bounds.emission, glm::pi<float>()));
        node.flags = (bounds.twoSided ? PRIZMA_LIGHT_TWO_SIDED : 0u) |
                     (bounds.moves ? PRIZMA_LIGHT_MOVES : 0u) | (bounds.isMet ? PRIZMA_LIGHT_IS_MET : 0u);
        return bounds;
    }

    /// Orders [first, end) so that a left and a right child's emitters follow each other; where the right's
    /// begin.
    std::uint32_t partition(std::uint32_t first, std::uint32_t end, std::uint32_t depth) {
        Bounds centres;
        for (std::uint32_t i = first; i < end; ++i)
            centres.add(emitters_[order_[i]].box.centre());
        const Split split = depth < balancedDepth ? findSplit(first, end, centres) : Split{};
        const auto begin = order_.begin();
        if (split.axis >= 0) {
            const auto middle = std::partition(begin + first, begin + end, [&](std::uint32_t i) {
                return emitters_[i].box.centre()[split.axis] < split.place;
            });
            if (middle != begin + first && middle != begin + end)
                return static_cast<std::uint32_t>(middle - begin);
        }
        const int axis = longestAxis(centres);
        const std::uint32_t middle = first + (end - first) / 2;
        std::nth_element(begin + first, begin + middle, begin + end, [&](std::uint32_t a, std::uint32_t b) {
            const float x = emitters_[a].box.centre()[axis];
            const float y = emitters_[b].box.centre()[axis];
            return x < y || (x == y && a < b);
        });
        return middle;
    }

    static int longestAxis(const Bounds& centres) {
        const glm::vec3 extent = centres.extent();
        return extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    }

    Split findSplit(std::uint32_t first, std::uint32_t end, const Bounds& centres) const {
        const glm::vec3 extent = centres.extent();
        const int longest = longestAxis(centres);
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(extent[axis] > 0.0f) || (end - first > allAxesSize && axis != longest))
                continue;
            const Split split = splitAlong(first, end, centres, axis);
            // Thin nodes: an axis counts for less the shorter it is.
            const float weighted = split.cost * (extent[longest] / extent[axis]);
            if (split.axis >= 0 && weighted < best.cost)
                best = {weighted, axis, split.place};
        }
        return best;
    }

    Split splitAlong(std::uint32_t first, std::uint32_t end, const Bounds& centres, int axis) const {
        const float low = centres.low[axis];
        const float width = centres.extent()[axis] / static_cast<float>(binCount);
        const auto binOf = [&](const LightBounds& emitter) {
            const float place = (emitter.box.centre()[axis] - low) / width;
            return std::min(static_cast<std::uint32_t>(std::max(place, 0.0f)), binCount - 1);
        };
        std::array<Bin, binCount> filled;
        for (std::uint32_t i = first; i < end; ++i)
            filled[binOf(emitters_[order_[i]])].add(emitters_[order_[i]]);
        for (std::uint32_t i = first; i < end; ++i)
            filled[binOf(emitters_[order_[i]])].open(emitters_[order_[i]]);
        std::array<LightBounds, binCount> bins;
        std::ranges::transform(filled, bins.begin(), &Bin::bounds);
        std::array<float, binCount> rightCost{};
        LightBounds right;
        for (std::uint32_t i = binCount - 1; i > 0; --i) {
            right = unite(right, bins[i]);
            rightCost[i] = cost(right);
        }
        Split best;
        LightBounds left;
        for (std::uint32_t i = 1; i < binCount; ++i) {
            left = unite(left, bins[i - 1]);
            const float sum = cost(left) + rightCost[i];
            if (sum < best.cost)
                best = {sum, axis, low + static_cast<float>(i) * width};
        }
        return best;
    }

    std::span<const LightBounds> emitters_;
    std::vector<std::uint32_t> order_;
    LightTree tree_;
};

} // namespace

LightTree buildLightTree(std::span<const LightBounds> emitters) {
    return emitters.empty() ? LightTree{} : Builder(emitters).take();
}

} // namespace prizma
