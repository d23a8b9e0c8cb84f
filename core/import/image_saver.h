#pragma once

#include "core/diagnostic.h"

#include <cstdint>
#include <string>
#include <vector>

namespace prizma {

/// Writes sRGB RGBA of 8 or 16 bits a channel as PNG, with an sRGB chunk. `pixels` holds width × height × 4
/// values, top row first. The file appears under its name once it is whole. Errors name the file.
Result<void> savePng(const std::string& file, int width, int height, const std::vector<std::uint8_t>& pixels);
Result<void> savePng16(const std::string& file, int width, int height,
                       const std::vector<std::uint16_t>& pixels);

/// The same for linear RGBA floats, as OpenEXR of 32 bits.
Result<void> saveExr(const std::string& file, int width, int height, const std::vector<float>& pixels);

} // namespace prizma
