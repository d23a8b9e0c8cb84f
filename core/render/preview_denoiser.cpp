#include "core/render/preview_denoiser.h"

#include "core/compute/program.h"

#include <algorithm>
#include <utility>

namespace prizma {
namespace {

constexpr int steps = 5; // the widest reaches 2 * 2^4 pixels, PRIZMA_DENOISE_MARGIN
static_assert(2 << (steps - 1) <= PRIZMA_DENOISE_MARGIN);

constexpr int fewBatches = 4; // FEW_BATCHES of the kernels

std::size_t pixelCountOf(int width, int height) {
    return static_cast<std::size_t>((width + 7) / 8) * static_cast<std::size_t>((height + 7) / 8) * 64;
}

} // namespace

bool isDenoised(const RenderSettings& settings) {
    return settings.denoise &&
           (settings.shader == ShaderType::Path || settings.shader == ShaderType::Whitted);
}

std::size_t PreviewDenoiser::places(int width, int height) {
    const int stride = (width + 7) / 8 * 8 + 2 * PRIZMA_DENOISE_MARGIN;
    return static_cast<std::size_t>(stride) * static_cast<std::size_t>(height);
}

Result<PreviewDenoiser> PreviewDenoiser::create(Context& context, TreeLayout layout, std::size_t groupSize) {
    const bool isWide = layout == TreeLayout::Wide8;
    const std::string options = isWide ? "-D PRIZMA_WIDE8" : "-D PRIZMA_BINARY2";
    PreviewDenoiser made;
    made.groupSize_ = groupSize;
    made.lanes_ = isWide ? 8 : 1;
    Result<void> ok;
    const auto load = [&](const std::string& file,
                          std::initializer_list<std::pair<Kernel*, const char*>> kernels) {
        const auto program = buildProgram(context, file, options);
        if (!program)
            ok = std::unexpected(program.error());
        for (const auto& [kernel, name] : kernels) {
            if (!ok)
                return;
            auto created = Kernel::create(*program, name);
            if (created)
                *kernel = std::move(*created);
            else
                ok = std::unexpected(created.error());
        }
    };
    load("denoise_guides.cl", {{&made.guidesKernel_, "denoiseGuides"}});
    if (ok)
        load("denoise.cl", {{&made.demodulate_, "demodulate"},
                            {&made.spatialVariance_, "spatialVariance"},
                            {&made.waveletStep_, "waveletStep"},
                            {&made.modulate_, "modulate"}});
    if (!ok)
        return std::unexpected(ok.error());
    return made;
}

Result<void> PreviewDenoiser::resize(Context& context, int width, int height) {
    width_ = width;
    height_ = height;
    knownSamples_ = batches_ = 0;
    const std::size_t plane = places(width, height);
    Result<void> ok;
    const auto reserve = [&](Buffer<float>& buffer, std::size_t count) {
        if (ok)
            ok = buffer.reserve(context, count, "denoiser");
    };
    reserve(guides_, guidePlanes * plane);
    reserve(history_, 2 * plane);
    reserve(light_[0], 4 * plane);
    reserve(light_[1], 4 * plane);
    reserve(pixels_, 4 * pixelCountOf(width, height));
    return ok;
}

Result<void> PreviewDenoiser::launch(Context& context, Kernel& kernel, std::size_t items, std::size_t group) {
    const auto launched = kernel.launch(context, items, group);
    if (!launched)
        return std::unexpected(launched.error());
    if (auto ok = context.finish(); !ok)
        return ok;
    milliseconds_ += prizma::milliseconds(*launched);
    return {};
}

Result<void> PreviewDenoiser::takeGuides(Context& context, KernelSet& kernels, const DeviceScene& scene,
                                         DeviceView view) {
    if (auto ok = resize(context, view.width, view.height); !ok)
        return ok;
    const auto count = static_cast<std::uint32_t>(pixelCountOf(view.width, view.height));
    if (auto ok = rays_.reserve(context, count, "denoiser"); !ok)
        return ok;
    if (auto ok = hits_.reserve(context, count, "denoiser"); !ok)
        return ok;
    view.jitter[0] = view.jitter[1] = 0.5f;
    view.lensRadius =
        0.0f; // guides are sharp: what is out of focus scatters, and so is smoothed all the same
    view.firstPixel = 0;
    view.pixelCount = count;
    milliseconds_ = 0.0;
    kernels.generateCameraRays.setArguments(view, rays_);
    if (auto ok = launch(context, kernels.generateCameraRays, count, groupSize_); !ok)
        return ok;
    Kernel& trace = kernels.tracePacket;
    scene.setSceneArguments(trace);
    trace.addArgument(rays_);
    trace.addArgument(hits_);
    trace.addArgument(0u);
    trace.addArgument(count);
    if (auto ok = launch(context, trace, (count + kernels.raysAPacket - 1) / kernels.raysAPacket,
                         kernels.packetGroupSize());
        !ok)
        return ok;
    scene.setSceneArguments(guidesKernel_);
    guidesKernel_.addArgument(view);
    guidesKernel_.addArgument(rays_);
    guidesKernel_.addArgument(hits_);
    guidesKernel_.addArgument(guides_);
    if (auto ok = launch(context, guidesKernel_, places(width_, height_), groupSize_); !ok)
        return ok;
    guideMilliseconds_ = milliseconds_;
    return {};
}

Result<void> PreviewDenoiser::setGuides(Context& context, int width, int height,
                                        std::span<const float> planes) {
    if (auto ok = resize(context, width, height); !ok)
        return ok;
    return guides_.write(context, planes, 0, "guides");
}

Result<SummedPicture> PreviewDenoiser::denoise(Context& context, const SummedPicture& picture) {
    milliseconds_ = std::exchange(guideMilliseconds_, 0.0);
    const int batch = picture.samples - knownSamples_;
    if (batch > 0)
        ++batches_;
    knownSamples_ = picture.samples;
    const int samples = std::max(picture.samples, 1);
    const std::size_t all = places(width_, height_);
    const std::size_t items =
        (static_cast<std::size_t>(width_) + lanes_ - 1) / lanes_ * static_cast<std::size_t>(height_);
    demodulate_.setArguments(picture.sums, guides_, history_, light_[0], light_[1], width_, height_, samples,
                             batch, std::max(batches_, 1));
    auto ok = launch(context, demodulate_, all, groupSize_);
    int from = 0;
    if (ok && batches_ < fewBatches) {
        spatialVariance_.setArguments(guides_, light_[0], light_[1], width_, height_);
        ok = launch(context, spatialVariance_, items, groupSize_);
        from = 1;
    }
    for (int i = 0; i < steps && ok; ++i) {
        waveletStep_.setArguments(guides_, light_[from], light_[1 - from], width_, height_, 1 << i);
        ok = launch(context, waveletStep_, items, groupSize_);
        from = 1 - from;
    }
    if (ok) {
        modulate_.setArguments(picture.sums, guides_, light_[from], pixels_, width_, height_, samples);
        ok = launch(context, modulate_, all, groupSize_);
    }
    if (!ok)
        return std::unexpected(ok.error());
    return SummedPicture{pixels_, width_, height_, 1};
}

} // namespace prizma
