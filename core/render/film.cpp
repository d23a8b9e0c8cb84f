#include "core/render/film.h"

namespace prizma {

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
    return ok;
}

Result<void> Film::reserveRays(Context& context) {
    if (auto ok = rays.reserve(context, pixelCount, "picture"); !ok)
        return ok;
    return hits.reserve(context, pixelCount, "picture");
}

} // namespace prizma
