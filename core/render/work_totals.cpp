#include "core/render/work_totals.h"

#include <cstddef>

namespace prizma {

void WorkTotals::add(const DeviceWork& work) {
    shadowRays += work.shadowRays;
    secondaryRays += work.secondaryRays;
    nonFinite += work.nonFinite;
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] += static_cast<double>(work.times[i]);
}

PassTimes WorkTotals::split(double milliseconds) const {
    const auto& [generate, trace, shadow, further, single, accumulate, all] = times;
    if (all <= 0.0)
        return {.shade = milliseconds, .isEstimated = true};
    const double tick = milliseconds / all;
    return {.generate = generate * tick,
            .trace = trace * tick,
            .shadow = shadow * tick,
            .further = further * tick,
            .single = single * tick,
            .shade = (all - generate - trace - shadow - further - single - accumulate) * tick,
            .accumulate = accumulate * tick,
            .isEstimated = true};
}

} // namespace prizma
