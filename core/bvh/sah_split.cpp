#include "core/bvh/sah_split.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace prizma {
namespace {

/// Everything is a local value here, because the compiler must assume that a fragment's write changes all
/// else.
template <int axis>
PartitionBounds partitionAlong(std::span<const Fragment> from, BinMapping mapping, std::uint32_t border,
                               Fragment* left, Fragment* right) {
    const auto last = static_cast<std::int32_t>(border) - 1;
    const Int4 lastLeft = {last, last, last, last};
    Box4 leftCentres, rightCentres;
    for (const Fragment& source : from) {
        const Fragment fragment = source;
        const Int4 place = mapping(fragment);
        const Int4 goesRight = __builtin_shufflevector(place, place, axis, axis, axis, axis) > lastLeft;
        // All bits set is not a number, which the boxes ignore.
        const Int4 centre = reinterpret_cast<Int4>(fragment.halfCentre());
        const auto forLeft = reinterpret_cast<Float4>(centre | goesRight);
        const auto forRight = reinterpret_cast<Float4>(centre | ~goesRight);
        leftCentres.add(forLeft, forLeft);
        rightCentres.add(forRight, forRight);
        const std::ptrdiff_t step = goesRight[0]; // 0 or -1
        *(step != 0 ? right : left) = fragment;
        right -= step;
        left += 1 + step;
    }
    return {leftCentres, rightCentres};
}

/// Running boxes of the three axes' bins, from one end on.
struct Sweep {
    Box4 boxes[3];
    Int4 counts{};

    void add(const BinSet& bins, std::uint32_t bin) {
        for (int axis = 0; axis < 3; ++axis)
            boxes[axis].add(bins.boxes[axis][bin]);
        counts += std::bit_cast<Int4>(bins.counts[bin]);
    }

    /// Half of the boxes' scaled surfaces, an axis a lane.
    Float4 halfAreas(float scale) const {
        Float4 products[3];
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 extent = boxes[axis].high * scale - boxes[axis].low * scale;
            products[axis] = extent * __builtin_shufflevector(extent, extent, 1, 2, 0, 3);
        }
        // Transposed, so that a lane's sum becomes a sum of registers.
        const Float4 xy = __builtin_shufflevector(products[0], products[1], 0, 4, 1, 5);
        const Float4 xyLast = __builtin_shufflevector(products[0], products[1], 2, 6, 3, 7);
        const Float4 first = __builtin_shufflevector(xy, products[2], 0, 1, 4, 4);
        const Float4 second = __builtin_shufflevector(xy, products[2], 2, 3, 5, 5);
        const Float4 third = __builtin_shufflevector(xyLast, products[2], 0, 1, 6, 6);
        return first + second + third;
    }
};

} // namespace

BinMapping::BinMapping(const Box4& centres, std::uint32_t primitiveCount)
    : offset_(centres.low), bins_(std::min(maxBins, 8 + primitiveCount / 16)) {
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
    for (auto& axis : boxes)
        std::fill_n(axis.begin(), bins, Box4{});
    std::fill_n(counts.begin(), bins, std::array<std::int32_t, 4>{});
}

void BinSet::add(std::span<const Fragment> fragments, const BinMapping& mapping) {
    const BinMapping map = mapping; // a copy stays in registers: nothing that is written can be part of it
    const auto addOne = [&](const Fragment& source) {
        const Fragment fragment = source;
        const Int4 place = map(fragment);
        const int x = place[0], y = place[1], z = place[2];
        boxes[0][x].add(fragment.low, fragment.high);
        boxes[1][y].add(fragment.low, fragment.high);
        boxes[2][z].add(fragment.low, fragment.high);
        ++counts[x][0];
        ++counts[y][1];
        ++counts[z][2];
    };
    // Neighbours in the list mostly share their bins, and each would wait for the one before to be stored.
    // Two that are far apart do not.
    const std::size_t half = fragments.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
        addOne(fragments[i]);
        addOne(fragments[half + i]);
    }
    if (fragments.size() % 2 != 0)
        addOne(fragments.back());
}

void BinSet::add(const BinSet& other, std::uint32_t bins) {
    for (int axis = 0; axis < 3; ++axis)
        for (std::uint32_t bin = 0; bin < bins; ++bin) {
            boxes[axis][bin].add(other.boxes[axis][bin]);
            counts[bin][axis] += other.counts[bin][axis];
        }
}

std::uint32_t BinSet::countBelow(int axis, std::uint32_t bin) const {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < bin; ++i)
        count += static_cast<std::uint32_t>(counts[i][axis]);
    return count;
}

Split findBestSplit(const BinSet& bins, const BinMapping& mapping, const Box4& node, const SahCosts& costs) {
    const Float4 none = splat(std::numeric_limits<float>::infinity());
    const float scale = areaScale(node);
    std::array<Float4, maxBins> rightAreas;
    std::array<Int4, maxBins> rightCounts;
    Sweep right;
    for (std::uint32_t bin = mapping.bins() - 1; bin > 0; --bin) {
        right.add(bins, bin);
        rightAreas[bin] = right.halfAreas(scale);
        rightCounts[bin] = right.counts;
    }
    // All three axes at once, each in its lane.
    Float4 bestCosts = none;
    Int4 bestBins{};
    Int4 bestImbalances{};
    Sweep left;
    for (std::uint32_t bin = 1; bin < mapping.bins(); ++bin) {
        left.add(bins, bin - 1);
        const Int4 isSplit = (left.counts > 0) & (rightCounts[bin] > 0);
        const Float4 sum = left.halfAreas(scale) * costs.leafSteps(left.counts) +
                           rightAreas[bin] * costs.leafSteps(rightCounts[bin]);
        const Float4 cost = isSplit ? sum : none;
        const Int4 difference = left.counts - rightCounts[bin];
        const Int4 imbalance = difference < 0 ? -difference : difference;
        const Int4 isBetter =
            (cost < bestCosts) | ((cost == bestCosts) & isSplit & (imbalance < bestImbalances));
        bestCosts = isBetter ? cost : bestCosts;
        bestImbalances = isBetter ? imbalance : bestImbalances;
        bestBins = isBetter ? Int4{} + static_cast<std::int32_t>(bin) : bestBins;
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!mapping.separates(axis) || bestBins[axis] == 0)
            continue;
        const bool isFirst = !best.isValid();
        if (isFirst || bestCosts[axis] < bestCosts[best.axis] ||
            (bestCosts[axis] == bestCosts[best.axis] && bestImbalances[axis] < bestImbalances[best.axis])) {
            best.axis = axis;
            best.bin = static_cast<std::uint32_t>(bestBins[axis]);
        }
    }
    if (!best.isValid())
        return best;
    const float area = scaledHalfArea(node, scale);
    best.cost = costs.traversal + (area > 0.0f ? costs.intersection * bestCosts[best.axis] / area : 0.0f);
    return best;
}

PartitionBounds partition(std::span<const Fragment> from, const BinMapping& mapping, const Split& split,
                          Fragment* left, Fragment* right) {
    switch (split.axis) {
    case 0:
        return partitionAlong<0>(from, mapping, split.bin, left, right);
    case 1:
        return partitionAlong<1>(from, mapping, split.bin, left, right);
    default:
        return partitionAlong<2>(from, mapping, split.bin, left, right);
    }
}

} // namespace prizma
