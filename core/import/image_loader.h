#pragma once

#include "core/diagnostic.h"
#include "core/scene/image.h"

#include <string>

namespace prizma {

/// Reads a picture: PNG, JPEG, BMP, TGA, GIF, PSD (8-bit sRGB) and HDR, EXR (linear). Errors name the file.
Result<ImagePtr> loadImage(const std::string& file);

} // namespace prizma
