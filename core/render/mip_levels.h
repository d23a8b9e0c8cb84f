#pragma once

#include "core/scene/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace prizma {

/// What a picture's texels mean, and so what their mean is.
enum class TexelUse {
    Color,       ///< A colour and how much of it there is: alpha weights it, so that holes do not bleed.
    OpaqueColor, ///< A colour; alpha does not matter.
    Data,        ///< Four numbers. 8 bits stand for 0 to 1 without the sRGB curve.
    Normal,      ///< A unit vector, -1 to 1 stored as 0 to 1.
};

/// The levels of a picture, itself first, each half as wide and high as the one before, rounded down but at
/// least 1; the last is one texel.
std::vector<glm::ivec2> mipSizes(int width, int height);

/// Texels of all levels, one after the other, as the texel buffer holds them: one word each for 8-bit
/// pictures (red lowest), four floats for others. The first level is the picture as it is. A texel of a
/// further one is the mean, in linear light, of what it covers of the level above: of two by two texels, or
/// of three where the size is odd, the outer ones in part.
std::vector<std::uint32_t> texelWords(const Image& image, TexelUse use);

} // namespace prizma
