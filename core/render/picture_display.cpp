#include "core/render/picture_display.h"

#include "core/render/view_transform.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

float scaleOf(const SummedPicture& picture, double exposure) {
    return static_cast<float>(std::exp2(exposure) / std::max(picture.samples, 1));
}

} // namespace

Result<void> PictureDisplay::makeTables(Context& context) {
    if (srgb_.get())
        return {};
    if (auto ok = filmic_.assign(context, filmicTable(), "filmic table"); !ok)
        return ok;
    return srgb_.assign(context, srgbEncoding(), "sRGB table");
}

Result<void> PictureDisplay::launch(Context& context, Kernel& kernel, const KernelSet& kernels,
                                    std::size_t pixels) {
    const auto launched = kernel.launch(context, pixels, kernels.groupSize);
    if (!launched)
        return std::unexpected(launched.error());
    if (auto ok = context.finish(); !ok)
        return ok;
    milliseconds_ = prizma::milliseconds(*launched);
    return {};
}

Result<std::vector<std::uint8_t>> PictureDisplay::bytes(Context& context, KernelSet& kernels,
                                                        const SummedPicture& picture,
                                                        const RenderSettings& settings) {
    if (auto ok = makeTables(context); !ok)
        return std::unexpected(ok.error());
    if (auto ok = bytes_.reserve(context, picture.pixels(), "picture"); !ok)
        return std::unexpected(ok.error());
    const bool isFilmic = settings.viewTransform == ViewTransform::Filmic;
    Kernel& kernel = isFilmic ? kernels.toneMapFilmic : kernels.toneMap;
    kernel.setArguments(picture.sums, bytes_, picture.width, picture.height,
                        scaleOf(picture, settings.exposure), srgb_);
    if (isFilmic)
        kernel.addArgument(filmic_);
    if (auto ok = launch(context, kernel, kernels, picture.pixels()); !ok)
        return std::unexpected(ok.error());
    std::vector<std::uint32_t> words(picture.pixels());
    if (auto ok = bytes_.read(context, words, 0, "picture"); !ok)
        return std::unexpected(ok.error());
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(words.data());
    return std::vector<std::uint8_t>(bytes, bytes + 4 * words.size());
}

Result<std::vector<std::uint16_t>> PictureDisplay::words(Context& context, KernelSet& kernels,
                                                         const SummedPicture& picture,
                                                         const RenderSettings& settings) {
    if (auto ok = makeTables(context); !ok)
        return std::unexpected(ok.error());
    if (auto ok = words_.reserve(context, 4 * picture.pixels(), "picture"); !ok)
        return std::unexpected(ok.error());
    const std::uint32_t isFilmic = settings.viewTransform == ViewTransform::Filmic ? 1 : 0;
    kernels.toneMapDeep.setArguments(picture.sums, words_, picture.width, picture.height,
                                     scaleOf(picture, settings.exposure), isFilmic, filmic_);
    if (auto ok = launch(context, kernels.toneMapDeep, kernels, picture.pixels()); !ok)
        return std::unexpected(ok.error());
    std::vector<std::uint16_t> words(4 * picture.pixels());
    if (auto ok = words_.read(context, words, 0, "picture"); !ok)
        return std::unexpected(ok.error());
    return words;
}

Result<std::vector<float>> PictureDisplay::mean(Context& context, KernelSet& kernels,
                                                const SummedPicture& picture) {
    if (auto ok = mean_.reserve(context, 4 * picture.pixels(), "picture"); !ok)
        return std::unexpected(ok.error());
    kernels.meanRadiance.setArguments(picture.sums, mean_, picture.width, picture.height,
                                      scaleOf(picture, 0.0));
    if (auto ok = launch(context, kernels.meanRadiance, kernels, picture.pixels()); !ok)
        return std::unexpected(ok.error());
    std::vector<float> values(4 * picture.pixels());
    if (auto ok = mean_.read(context, values, 0, "picture"); !ok)
        return std::unexpected(ok.error());
    return values;
}

} // namespace prizma
