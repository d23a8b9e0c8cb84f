#pragma once

#include "core/reference/reference_tracer.h"

namespace prizma::reference {

/// What shading knows of a hit, in world space.
struct Surface {
    glm::dvec3 position{0.0};
    glm::dvec3 geometricNormal{0.0}; ///< Unit, on the side that the ray came from.
    glm::dvec3 normal{0.0};          ///< Interpolated and normal-mapped, on the same side.
    bool entering = true;            ///< The ray came from outside the mesh.
    double coverage = 1.0;           ///< Share of the light that meets the surface at all; 0: a hole.
    glm::dvec3 baseColor{0.0}, emission{0.0}, specularColor{1.0};
    glm::dvec3 absorption{0.0}; ///< Per unit of length inside (Beer and Lambert).
    double specular = 0.0, metallic = 0.0, roughness = 0.0, transmission = 0.0, ior = 1.0;
    /// Texels under the ray's footprint, of the texture where they are most: above 1 a renderer with mip
    /// levels no longer shows the finest one, which the values here are of.
    double texelsInFootprint = 0.0;
};

/// The surface that `ray` meets at `hit`. `coneWidth`: how wide the ray is there, in scene units.
///
/// Materials are glTF 2.0's, with metallic-roughness (and KHR_materials_specular, _transmission, _ior and
/// _volume's attenuation). A surface that is single-sided and lets no light through is a hole from behind.
Surface surfaceAt(const Scene& scene, const Ray& ray, const Hit& hit, double coneWidth);

} // namespace prizma::reference
