#pragma once

#include "core/scene/material.h"

namespace prizma {

/// What a material of the Phong kind (MTL, FBX, Collada and others) says.
struct PhongMaterial {
    glm::dvec3 diffuse{0.8}, specular{0.0};
    glm::dvec3 filter{1.0}; ///< Colour of glass.
    double shininess = 0.0; ///< Phong's exponent.
    double opacity = 1.0;
    double ior = 1.0;      ///< 1 or less: not said.
    int illumination = -1; ///< MTL's illum, -1 if not said.
    bool isTextured = false;
};

/// Roughness of GGX with highlights about as wide as those of a Phong exponent: alpha² = 2 / (exponent + 2)
/// (Walter et al. 2007, section 5.2: the exponent of Blinn-Phong for a Beckmann width), and alpha is the
/// roughness squared.
double roughnessOfShininess(double shininess);

/// Sets `material`'s plain values. The rules:
/// - The base colour is the diffuse colour; black under a texture means white, as exporters write it.
/// - `specular` is the specular colour's brightness, its hue `specularColor`. A nearly black surface without
///   texture whose specular colour is above 1/2 is a metal of that colour.
/// - illum 3, 5 and 8 are mirrors: smooth, and metal if the specular colour is at least the diffuse one.
/// - illum 6 and 7 are smooth glass, 4 and 9 if they let light through or bend it; so are others, if
///   untextured, that do both. `transmission` is what opacity leaves, all if it leaves nothing; the base
///   colour is the hue of the filter colour or, if that is grey, of the diffuse colour, at full brightness:
///   what MTL files call dark glass is often clear.
/// - Otherwise opacity is alpha.
void applyPhong(const PhongMaterial& phong, Material& material);

} // namespace prizma
