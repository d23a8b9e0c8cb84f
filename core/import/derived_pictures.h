#pragma once

#include "core/scene/image.h"

namespace prizma {

/// Pictures made of others, where a model file keeps apart what a Material has in one texture, or in
/// another form. Pictures of different sizes are brought to the larger one bilinearly. "Values" are a
/// picture's brightest channel as stored, 0 to 1, without the sRGB curve.

/// `color` (null: white) with the opacity that `opacity` shows: its alpha if it has any, else its values.
ImagePtr withOpacity(const ImagePtr& color, const ImagePtr& opacity);

/// Green is the values of `roughness`, blue those of `metallic`; null stands for 1 everywhere.
ImagePtr metallicRoughness(const ImagePtr& roughness, const ImagePtr& metallic);

/// Green is the roughness for a Phong exponent of `shininess` times the values of `map`; blue is 1.
ImagePtr roughnessFromShininess(const ImagePtr& map, double shininess);

/// Alpha is the values of `specular`; white.
ImagePtr valuesInAlpha(const ImagePtr& specular);

/// The normal map of a height map that is repeated in both directions, by central differences. Height 1 is
/// `scale` times a fiftieth of the picture's width: files do not say how deep a bump is, and this looks
/// right for plaster, bricks and bark.
ImagePtr normalsFromHeights(const ImagePtr& heights, double scale);

/// Normal maps are bluish all over; height maps, for which the same keywords are used, are grey.
bool looksLikeNormalMap(const Image& image);

} // namespace prizma
