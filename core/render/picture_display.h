#pragma once

#include "core/compute/buffer.h"
#include "core/render/kernel_set.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

namespace prizma {

/// Sums of radiance on the device: four floats a pixel, in the order of kernels/pixel_order.clh.
struct SummedPicture {
    const Buffer<float>& sums;
    int width, height;
    int samples; ///< That were summed.

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Turns sums of radiance into pictures for screens and files, on the device. All pictures have the top row
/// first and four channels a pixel.
class PictureDisplay {
  public:
    /// sRGB bytes through the settings' exposure and view transform; alpha is 255.
    Result<std::vector<std::uint8_t>> bytes(Context& context, KernelSet& kernels,
                                            const SummedPicture& picture, const RenderSettings& settings);

    /// The same of 16 bits, from the sums and not from the bytes; alpha is 65535.
    Result<std::vector<std::uint16_t>> words(Context& context, KernelSet& kernels,
                                             const SummedPicture& picture, const RenderSettings& settings);

    /// Linear radiance and coverage.
    Result<std::vector<float>> mean(Context& context, KernelSet& kernels, const SummedPicture& picture);

    /// What the device spent on the last picture.
    double milliseconds() const { return milliseconds_; }

  private:
    Result<void> makeTables(Context& context);
    Result<void> launch(Context& context, Kernel& kernel, const KernelSet& kernels, std::size_t pixels);

    Buffer<std::uint32_t> bytes_;
    Buffer<std::uint16_t> words_; ///< Only once asked for, as the next.
    Buffer<float> mean_;
    Buffer<std::uint32_t> srgb_; ///< Tables of core/render/view_transform.h.
    Buffer<float> filmic_;
    double milliseconds_ = 0.0;
};

} // namespace prizma
