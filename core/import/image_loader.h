#pragma once

#include "core/diagnostic.h"
#include "core/scene/image.h"

#include <string>

namespace prizma {

/// Reads a picture: PNG, JPEG, BMP, TGA, GIF, PSD (8-bit sRGB) and HDR, EXR (linear). Errors name the file.
Result<ImagePtr> loadImage(const std::string& file);

/// Writes 8-bit RGBA (PNG) or linear RGBA floats (EXR); `pixels` holds width × height × 4 values, top row
/// first.
Result<void> savePng(const std::string& file, int width, int height, const std::vector<std::uint8_t>& pixels);
Result<void> saveExr(const std::string& file, int width, int height, const std::vector<float>& pixels);

} // namespace prizma
