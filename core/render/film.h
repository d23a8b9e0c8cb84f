#pragma once

#include "core/compute/buffer.h"
#include "kernels/device_types.h"

#include <cstdint>

namespace prizma {

/// The fewest pixels that share a DeviceWork.
inline constexpr std::uint32_t pixelsAWork = 16;

/// What a picture needs a pixel: sums, and ray and hit where they go through memory. Pixels lie in the order
/// of kernels/pixel_order.clh.
struct Film {
    int width = 0, height = 0;
    std::uint32_t pixelCount = 0; ///< Rounded up to whole tiles.
    Buffer<DeviceRay> rays;       ///< These two only once asked for.
    Buffer<DeviceHit> hits;
    Buffer<float> sums, losses; ///< Four floats a pixel.
    Buffer<DeviceWork> work;    ///< One a packet of sixteen pixels, or a work group.

    Result<void> resize(Context& context, int newWidth, int newHeight);

    /// Room for rays and hits.
    Result<void> reserveRays(Context& context);
};

} // namespace prizma
