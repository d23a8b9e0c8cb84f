#include "core/render/film.h"

#include "core/scene/srgb.h"

#include <bit>
#include <cmath>

namespace prizma {
namespace {

/// The linear value from which on each byte is used, as float bits, then for every bin of floats (their upper
/// 16 bits) from the smallest to 1 the byte at the bin's start.
std::vector<std::uint32_t> srgbEncoding() {
    std::vector<float> limits(256, 0.0f);
    for (std::size_t byte = 1; byte < limits.size(); ++byte)
        limits[byte] = static_cast<float>(decodeSrgb((static_cast<double>(byte) - 0.5) / 255.0));
    std::vector<std::uint32_t> table;
    for (const float limit : limits)
        table.push_back(std::bit_cast<std::uint32_t>(limit));
    const std::uint32_t first = std::bit_cast<std::uint32_t>(PRIZMA_SRGB_SMALLEST) >> 16;
    const std::uint32_t last = std::bit_cast<std::uint32_t>(1.0f) >> 16;
    std::uint32_t byte = 0;
    for (std::uint32_t bin = first; bin <= last; ++bin) {
        while (byte < 255 && std::bit_cast<float>(bin << 16) >= limits[byte + 1])
            ++byte;
        table.push_back(byte);
    }
    return table;
}

} // namespace

Result<void> Film::resize(Context& context, int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
    pixelCount =
        static_cast<std::uint32_t>((width + 7) / 8) * static_cast<std::uint32_t>((height + 7) / 8) * 64;
    Result<void> ok;
    const auto reserve = [&](auto& buffer, std::size_t count) {
        if (ok)
            ok = buffer.reserve(context, count, "picture");
    };
    reserve(sums, 4ull * pixelCount);
    reserve(losses, 4ull * pixelCount);
    reserve(work, pixelCount / pixelsAWork);
    reserve(display, pixelCount);
    if (ok && !encoding.get())
        ok = encoding.assign(context, srgbEncoding(), "sRGB table");
    return ok;
}

Result<void> Film::reserveRays(Context& context) {
    if (auto ok = rays.reserve(context, pixelCount, "picture"); !ok)
        return ok;
    return hits.reserve(context, pixelCount, "picture");
}

} // namespace prizma
