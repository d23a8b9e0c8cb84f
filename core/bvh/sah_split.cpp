#include "core/bvh/sah_split.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// A power of two that brings the box's extents to about one, so that products neither overflow nor vanish.
float areaScale(const Box4& box) {
    const Float4 halfExtent = box.high * 0.5f - box.low * 0.5f;
    const float largest = std::max({halfExtent[0], halfExtent[1], halfExtent[2]});
    if (!(largest > 0.0f))
        return 1.0f;
    return std::ldexp(1.0f, std::clamp(-std::ilogb(largest), -126, 126));
}

float scaledHalfArea(const Box4& box, float scale) { return halfAreaOf(box.high * scale - box.low * scale); }

std::uint32_t difference(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; }

} // namespace

BinMapping::BinMapping(const Box4& centres, std::uint32_t primitiveCount)
    : offset_(centres.low), bins_(std::min(maxBins, 4 + primitiveCount / 16)) {
    // A little less than the number of bins, so that rounding cannot reach a bin beyond the last.
    const float reach = static_cast<float>(bins_) * 0.999f;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = centres.high[axis] - centres.low[axis];
        scale_[axis] = extent > 1e-34f ? reach / extent : 0.0f;
    }
    offset_[3] = 0.0f;
    scale_[3] = 0.0f;
}

void BinSet::clear(std::uint32_t bins) {
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(boxes[axis].begin(), bins, Box4{});
        std::fill_n(counts[axis].begin(), bins, 0u);
    }
}

void BinSet::add(std::span<const Fragment> fragments, const BinMapping& mapping) {
    for (const Fragment& fragment : fragments) {
        const Int4 place = mapping(fragment);
        const int x = place[0], y = place[1], z = place[2];
        boxes[0][x].add(fragment.low, fragment.high);
        boxes[1][y].add(fragment.low, fragment.high);
        boxes[2][z].add(fragment.low, fragment.high);
        ++counts[0][x];
        ++counts[1][y];
        ++counts[2][z];
    }
}

void BinSet::add(const BinSet& other, std::uint32_t bins) {
    for (int axis = 0; axis < 3; ++axis)
        for (std::uint32_t bin = 0; bin < bins; ++bin) {
            boxes[axis][bin].add(other.boxes[axis][bin]);
            counts[axis][bin] += other.counts[axis][bin];
        }
}

std::uint32_t BinSet::countBelow(int axis, std::uint32_t bin) const {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < bin; ++i)
        count += counts[axis][i];
    return count;
}

Split findBestSplit(const BinSet& bins, const BinMapping& mapping, const Box4& node, const SahCosts& costs) {
    const float scale = areaScale(node);
    std::array<float, maxBins> rightArea{};
    std::array<std::uint32_t, maxBins> rightCount{};
    Split best;
    float bestCost = std::numeric_limits<float>::infinity();
    std::uint32_t bestImbalance = 0;

    for (int axis = 0; axis < 3; ++axis) {
        if (!mapping.separates(axis))
            continue;
        Box4 box;
        std::uint32_t count = 0;
        for (std::uint32_t bin = mapping.bins() - 1; bin > 0; --bin) {
            box.add(bins.boxes[axis][bin]);
            count += bins.counts[axis][bin];
            rightArea[bin] = scaledHalfArea(box, scale);
            rightCount[bin] = count;
        }
        box = {};
        count = 0;
        for (std::uint32_t bin = 1; bin < mapping.bins(); ++bin) {
            box.add(bins.boxes[axis][bin - 1]);
            count += bins.counts[axis][bin - 1];
            if (count == 0 || rightCount[bin] == 0)
                continue;
            const float cost = scaledHalfArea(box, scale) * costs.leafSteps(count) +
                               rightArea[bin] * costs.leafSteps(rightCount[bin]);
            const std::uint32_t imbalance = difference(count, rightCount[bin]);
            if (cost < bestCost || (cost == bestCost && imbalance < bestImbalance)) {
                bestCost = cost;
                bestImbalance = imbalance;
                best.axis = axis;
                best.bin = bin;
            }
        }
    }
    const float area = scaledHalfArea(node, scale);
    best.cost = costs.traversal + (area > 0.0f ? costs.intersection * bestCost / area : 0.0f);
    return best;
}

PartitionBounds partition(std::span<const Fragment> from, const BinMapping& mapping, const Split& split,
                          Fragment* left, Fragment* right) {
    const Float4 none = splat(std::numeric_limits<float>::infinity());
    PartitionBounds bounds;
    const auto border = static_cast<std::int32_t>(split.bin);
    for (const Fragment& fragment : from) {
        const Int4 place = mapping(fragment);
        const std::int32_t goesRight = place[split.axis] >= border ? -1 : 0;
        const Int4 mask = {goesRight, goesRight, goesRight, goesRight};
        const Float4 centre = fragment.halfCentre();
        bounds.leftCentres.add(mask ? none : centre, mask ? -none : centre);
        bounds.rightCentres.add(mask ? centre : none, mask ? centre : -none);
        *(goesRight != 0 ? right : left) = fragment;
        right -= goesRight;
        left += 1 + goesRight;
    }
    return bounds;
}

} // namespace prizma
