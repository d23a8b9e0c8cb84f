#pragma once

#include "core/compute/buffer.h"
#include "core/compute/kernel.h"
#include "core/render/device_scene.h"
#include "core/render/kernel_set.h"
#include "core/render/picture_display.h"
#include "kernels/device_types.h"

namespace prizma {

/// Whether a preview with these settings is denoised: those that look into the engine have no noise.
bool isDenoised(const RenderSettings& settings);

/// Smooths the noise of a picture on the device for the screen, never for files or measurements: an
/// edge-avoiding à-trous wavelet (Dammertz et al. 2010) guided by the first hits' normal, place and colour,
/// and by how much the samples scatter (Schied et al. 2017), so that it fades out as the picture converges.
/// See kernels/denoise.cl. What is seen in mirrors and through glass is guided by the mirror's or the glass'
/// own surface.
class PreviewDenoiser {
  public:
    static Result<PreviewDenoiser> create(Context& context, TreeLayout layout, std::size_t groupSize);

    /// Finds the surfaces that `view` sees, for the pictures to come.
    Result<void> takeGuides(Context& context, KernelSet& kernels, const DeviceScene& scene, DeviceView view);

    /// The denoised picture, as a sum of one sample; it stays until the next call. Its alpha is the mean
    /// coverage. A pixel that is no number stays so and spreads nowhere.
    Result<SummedPicture> denoise(Context& context, const SummedPicture& picture);

    /// What the device spent on the last picture; with its guides if it is the first one with them.
    double milliseconds() const { return milliseconds_; }

    /// Guides for a picture of width x height, given rather than found: for tests. Planes as
    /// kernels/denoise_planes.clh says.
    Result<void> setGuides(Context& context, int width, int height, std::span<const float> planes);
    static std::size_t places(int width, int height); ///< Floats a plane.

    static constexpr int guidePlanes = 10;

  private:
    PreviewDenoiser() = default;

    Result<void> resize(Context& context, int width, int height);
    Result<void> launch(Context& context, Kernel& kernel, std::size_t items, std::size_t group);

    Kernel guidesKernel_, demodulate_, spatialVariance_, waveletStep_, modulate_;
    std::size_t groupSize_ = 64;
    std::size_t lanes_ = 1;

    int width_ = 0, height_ = 0;
    Buffer<DeviceRay> rays_; ///< Through the middle of each pixel, for the guides.
    Buffer<DeviceHit> hits_;
    Buffer<float> guides_;
    Buffer<float> history_; ///< Of the samples' scatter: two planes.
    Buffer<float> light_[2];
    Buffer<float> pixels_;
    int knownSamples_ = 0; ///< Of the history.
    int batches_ = 0;
    double milliseconds_ = 0.0;
    double guideMilliseconds_ = 0.0;
};

} // namespace prizma
