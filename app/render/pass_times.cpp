#include "app/render/pass_times.h"

#include <fmt/format.h>

namespace prizma {

nlohmann::ordered_json toJson(const PassTimes& times) {
    return {{"generate", times.generate},     {"trace", times.trace},          {"shadow", times.shadow},
            {"further", times.further},       {"single", times.single},        {"shade", times.shade},
            {"accumulate", times.accumulate}, {"estimated", times.isEstimated}};
}

std::string describe(const PassTimes& times) {
    if (!times.isEstimated)
        return fmt::format("camera rays {:.1f} ms, their hits {:.1f}, RayShader with its rays {:.1f}",
                           times.generate, times.trace, times.shade);
    return fmt::format(
        "camera rays {:.1f} ms, their hits {:.1f}, shadow rays {:.1f}, further rays {:.1f}, surfaces and "
        "lights {:.1f}, those shaded one by one {:.1f}, adding up {:.1f} (estimated from one packet in 61)",
        times.generate, times.trace, times.shadow, times.further, times.shade, times.single,
        times.accumulate);
}

} // namespace prizma
