#pragma once

#include "core/bvh/float4.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace prizma {

/// What the builder moves about: a primitive's box with its index in a spare lane, so that every pass over
/// the primitives reads memory in order.
struct alignas(32) Fragment {
    Float4 low; ///< Lane 3: the primitive's index, as bits.
    Float4 high;

    static constexpr std::uint32_t maxPrimitives = 0x3F000000u;

    static Fragment of(const Bounds& box, std::uint32_t primitive) {
        return {Float4{box.low.x, box.low.y, box.low.z, std::bit_cast<float>(primitive | indexBias)},
                Float4{box.high.x, box.high.y, box.high.z, 0.0f}};
    }

    std::uint32_t primitive() const { return std::bit_cast<std::uint32_t>(low[3]) & ~indexBias; }

    /// Half of the centroid: differences of halves cannot overflow.
    Float4 halfCentre() const { return low * 0.25f + high * 0.25f; }

  private:
    /// Makes an index a normal number when read as a float: denormal ones cost some processors a hundred
    /// cycles a multiplication.
    static constexpr std::uint32_t indexBias = 0x40000000u;
};

inline constexpr std::uint32_t maxBins = 32;

/// Assigns centroids to bins of equal width along each axis.
class BinMapping {
  public:
    /// `centres`: the box of the half centroids. Small nodes get fewer bins: they have less to gain from
    /// many.
    BinMapping(const Box4& centres, std::uint32_t primitiveCount);

    std::uint32_t bins() const { return bins_; }

    /// True if no axis tells the centroids apart.
    bool isDegenerate() const { return !separates(0) && !separates(1) && !separates(2); }
    bool separates(int axis) const { return scale_[axis] > 0.0f; }

    /// Bin of a fragment on each axis, always in [0, bins).
    Int4 operator()(const Fragment& fragment) const {
        return __builtin_convertvector((fragment.halfCentre() - offset_) * scale_, Int4);
    }

  private:
    Float4 offset_;
    Float4 scale_;
    std::uint32_t bins_;
};

/// The boxes and numbers of the primitives in each bin, on the three axes.
struct BinSet {
    std::array<std::array<Box4, maxBins>, 3> boxes;
    alignas(
        16) std::array<std::array<std::int32_t, 4>, maxBins> counts; ///< By bin, then axis; the fourth is 0.

    /// Empties the first `bins` of each axis; no others are looked at.
    void clear(std::uint32_t bins);
    void add(std::span<const Fragment> fragments, const BinMapping& mapping);
    void add(const BinSet& other, std::uint32_t bins);

    /// Primitives in the bins below `bin`.
    std::uint32_t countBelow(int axis, std::uint32_t bin) const;
};

/// How leaves are priced: a step tests 2^widthShift primitives.
struct SahCosts {
    float traversal = 1.0f;
    float intersection = 1.0f;
    std::uint32_t widthShift = 3;

    float leafSteps(std::uint32_t count) const {
        return static_cast<float>((count + (1u << widthShift) - 1) >> widthShift);
    }
    Float4 leafSteps(Int4 counts) const {
        const auto shift = static_cast<std::int32_t>(widthShift);
        return __builtin_convertvector((counts + ((1 << shift) - 1)) >> shift, Float4);
    }
};

/// A plane between two bins. `cost` is relative to the node's own visit, in the unit of SahCosts.
struct Split {
    int axis = -1;         ///< -1: there is none.
    std::uint32_t bin = 0; ///< First bin of the right side.
    float cost = 0.0f;

    bool isValid() const { return axis >= 0; }
};

/// The cheapest of all planes between bins; of equally cheap ones the most even.
Split findBestSplit(const BinSet& bins, const BinMapping& mapping, const Box4& node, const SahCosts& costs);

/// The boxes of the half centroids on both sides of a partition.
struct PartitionBounds {
    Box4 leftCentres, rightCentres;
};

/// Copies `from` to the two sides without a branch; keeps the order on each side.
PartitionBounds partition(std::span<const Fragment> from, const BinMapping& mapping, const Split& split,
                          Fragment* left, Fragment* right);

} // namespace prizma
