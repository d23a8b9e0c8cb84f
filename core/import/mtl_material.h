#pragma once

#include "core/import/mtl_reader.h"
#include "core/import/picture_reader.h"
#include "core/scene/material.h"

namespace prizma {

/// What an MTL material looks like here, by the rules of applyPhong and these:
/// - d is opacity; Tr is 1 - d and asked only without d. Tr 1 alone is opaque, unless it is glass: exporters
///   of the opposite opinion write it.
/// - Pr and Pm, or their maps, make it a physically based one: specular is 1 unless Ks says otherwise, and
///   nothing is guessed to be metal. Their maps replace Pr and Pm. One file for both is a packed picture as
///   in glTF (green and blue).
/// - map_Ns multiplies the exponent, of 1000 if there is no Ns; map_Ks multiplies `specular`, map_Ke the
///   emission (of 1 if Ke is black), map_d the alpha: its alpha channel if it has one, else its brightness.
/// - A bump map that is bluish is a normal map; another is a height map, of which one is made.
Material materialOf(const MtlMaterial& source, const std::string& name, PictureReader& pictures);

} // namespace prizma
