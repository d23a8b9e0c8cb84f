#pragma once

#include "core/reference/reference_surface.h"

namespace prizma::reference {

/// Smoother surfaces than this are mirrors: they reflect one direction only.
constexpr double smoothRoughness = 0.08;

inline bool isMirror(const Surface& s) {
    return s.roughness < smoothRoughness;
}

/// Share of the light that goes through the surface.
inline double clearShare(const Surface& s) {
    return (1.0 - s.metallic) * s.transmission;
}

/// Share that is reflected diffusely, before the layer above takes its part.
inline double diffuseShare(const Surface& s) {
    return (1.0 - s.metallic) * (1.0 - s.transmission);
}

/// Fresnel's equations for unpolarised light; `index` is that of the far side over that of the near one. 1
/// where nothing is refracted.
double fresnel(double cosine, double index);

/// What the outermost layer reflects of light that meets it at `cosine`.
glm::dvec3 layerReflectance(const Surface& s, double cosine);

/// Radiance towards `toEye` for unit irradiance on a surface that faces the light at `toLight`; both unit and
/// above the surface.
glm::dvec3 reflected(const Surface& s, const glm::dvec3& toEye, const glm::dvec3& toLight);

/// Share of light from all sides, of equal radiance, that goes towards `toEye`, without what a mirror
/// reflects and what goes through.
glm::dvec3 ambientAlbedo(const Surface& s, const glm::dvec3& toEye);

} // namespace prizma::reference
