#pragma once

#include "core/compute/buffer.h"
#include "kernels/device_types.h"

#include <cstdint>

namespace prizma {

/// What a picture needs a pixel: ray, hit, sums, counters. Pixels lie in the order of
/// kernels/pixel_order.clh.
struct Film {
    int width = 0, height = 0;
    std::uint32_t pixelCount = 0; ///< Rounded up to whole tiles.
    Buffer<DeviceRay> rays;
    Buffer<DeviceHit> hits;
    Buffer<float> sums, losses; ///< Four floats a pixel.
    Buffer<std::uint32_t> rayCounts;

    Result<void> resize(Context& context, int newWidth, int newHeight);
};

} // namespace prizma
