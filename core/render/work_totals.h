#pragma once

#include "core/render/statistics.h"
#include "kernels/device_types.h"

#include <array>

namespace prizma {

/// What all packets or work groups of a pass did together.
struct WorkTotals {
    std::uint64_t shadowRays = 0, secondaryRays = 0, nonFinite = 0;
    std::array<double, 7>
        times{}; ///< Ticks of the packets that looked at the clock; the last is all of their time.

    void add(const DeviceWork& work);

    /// Shares `milliseconds`, the time of the kernel, out as the packets' clocks tell.
    PassTimes split(double milliseconds) const;
};

} // namespace prizma
