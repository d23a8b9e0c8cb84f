#pragma once

#include "core/diagnostic.h"

#include <cstdint>
#include <string>
#include <vector>

namespace prizma {

/// What a picture is to be written as.
enum class PictureFormat {
    Png8,  ///< sRGB, 8 bits a channel.
    Png16, ///< sRGB, 16 bits a channel.
    Exr    ///< Linear radiance, 32 bits a channel.
};

/// "png" or "exr".
std::string_view extensionOf(PictureFormat format);

/// A finished picture, never denoised: four channels a pixel, top row first. Empty is what nobody asked for.
struct Picture {
    int width = 0, height = 0;
    int samples = 0;                   ///< In each pixel.
    std::vector<float> radiance;       ///< Linear; alpha is coverage.
    std::vector<std::uint8_t> display; ///< sRGB through exposure and view transform; opaque.
    std::vector<std::uint16_t> deep;   ///< The same of 16 bits.
};

/// Writes what `format` needs of a picture; a crash leaves no half of a picture behind.
Result<void> savePicture(const Picture& picture, PictureFormat format, const std::string& file);

/// As the file's extension says; PNG of 16 bits if the picture has them.
Result<void> savePicture(const Picture& picture, const std::string& file);

} // namespace prizma
