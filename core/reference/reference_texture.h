#pragma once

#include "core/scene/image.h"

#include <glm/glm.hpp>

namespace prizma::reference {

/// What a texel's numbers mean.
enum class Reading {
    Color,        ///< 8-bit values are sRGB; floats are linear. Alpha is straight.
    CoveredColor, ///< The same, but what is transparent lends its neighbours no colour.
    Data          ///< As they stand; 8-bit values stand for 0 to 1.
};

/// The finest level of a picture, bilinearly between its texels' centres, repeated in both directions. (0, 0)
/// is its bottom left corner.
glm::dvec4 sampleImage(const Image& image, const glm::dvec2& texCoord, Reading reading);

} // namespace prizma::reference
