#include "core/bvh/sah_split.h"

#include <algorithm>
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

std::uint32_t difference(std::uint32_t a, std::uint32_t b) {
    return a > b ? a - b : b - a;
}

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
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(boxes[axis].begin(), bins, Box4{});
        std::fill_n(counts[axis].begin(), bins, 0u);
    }
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
        ++counts[0][x];
        ++counts[1][y];
        ++counts[2][z];
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
