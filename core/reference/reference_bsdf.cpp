#include "core/reference/reference_bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prizma::reference {
namespace {

constexpr double pi = std::numbers::pi;

double indexBeyond(const Surface& s) {
    return s.entering ? s.ior : 1.0 / s.ior;
}

/// Schlick 1994.
glm::dvec3 schlick(const glm::dvec3& straight, double cosine) {
    return straight + (1.0 - straight) * std::pow(1.0 - cosine, 5.0);
}

/// Walter et al. 2007, by the tangent of the half vector's angle.
double ggxDensity(double cosine, double alpha) {
    if (cosine <= 0.0)
        return 0.0;
    const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
    const double spread = alpha * alpha + tangent2;
    return alpha * alpha / (pi * std::pow(cosine, 4.0) * spread * spread);
}

/// Smith's Λ of GGX (Heitz 2014).
double smithLambda(double cosine, double alpha) {
    const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

/// Share of light from all sides that rough facets reflect once: `scale` times the reflectance at normal
/// incidence, plus `offset` (Karis' fit of 2014).
struct FacetAlbedo {
    double scale, offset;
};

FacetAlbedo facetAlbedo(double roughness, double cosine) {
    const double x = 1.0 - roughness;
    const double a = std::min(x * x, std::exp2(-9.28 * cosine)) * x + 0.0425 - 0.0275 * roughness;
    return {1.04 - 0.572 * roughness - 1.04 * a, 1.04 * a - 0.04 + 0.022 * roughness};
}

/// What all bounces between a metal's facets give back, over the first (Turquin 2019).
glm::dvec3 allBounces(const Surface& s, const FacetAlbedo& once) {
    return 1.0 + s.baseColor * (1.0 / (once.scale + once.offset) - 1.0);
}

} // namespace

double fresnel(double cosine, double index) {
    const double sine = std::sqrt(1.0 - cosine * cosine) / index; // Snell
    if (sine >= 1.0)
        return 1.0;
    const double beyond = std::sqrt(1.0 - sine * sine);
    const double s = (cosine - index * beyond) / (cosine + index * beyond);
    const double p = (beyond - index * cosine) / (beyond + index * cosine);
    return (s * s + p * p) / 2.0;
}

glm::dvec3 layerReflectance(const Surface& s, double cosine) {
    const glm::dvec3 dielectric = s.specular * s.specularColor * fresnel(cosine, indexBeyond(s));
    return s.metallic * schlick(s.baseColor, cosine) + (1.0 - s.metallic) * dielectric;
}

glm::dvec3 reflected(const Surface& s, const glm::dvec3& toEye, const glm::dvec3& toLight) {
    const double cosineI = glm::dot(s.normal, toLight);
    const double cosineO = std::max(glm::dot(s.normal, toEye), 1e-4);
    if (cosineI <= 0.0)
        return glm::dvec3(0.0);
    const glm::dvec3 half = glm::normalize(toEye + toLight);
    const glm::dvec3 layer = layerReflectance(s, glm::dot(half, toEye));
    glm::dvec3 value = diffuseShare(s) * s.baseColor * (1.0 - layer) / pi;
    if (!isMirror(s)) {
        const double alpha = s.roughness * s.roughness;
        const double masked = 1.0 / (1.0 + smithLambda(cosineO, alpha) + smithLambda(cosineI, alpha));
        const glm::dvec3 later = s.metallic * (allBounces(s, facetAlbedo(s.roughness, cosineO)) - 1.0);
        value += layer * (1.0 + later) *
                 (ggxDensity(glm::dot(half, s.normal), alpha) * masked / (4.0 * cosineO * cosineI));
    }
    return value * cosineI;
}

glm::dvec3 ambientAlbedo(const Surface& s, const glm::dvec3& toEye) {
    const double cosine = std::clamp(glm::dot(s.normal, toEye), 0.0, 1.0);
    const glm::dvec3 strength = s.specular * s.specularColor;
    if (isMirror(s))
        return diffuseShare(s) * s.baseColor * (1.0 - strength * fresnel(cosine, s.ior));
    const FacetAlbedo once = facetAlbedo(s.roughness, cosine);
    const glm::dvec3 layer = strength * std::max(fresnel(1.0, s.ior) * once.scale + once.offset, 0.0);
    return diffuseShare(s) * (layer + s.baseColor * (1.0 - layer)) +
           s.metallic * (s.baseColor * once.scale + once.offset) * allBounces(s, once);
}

} // namespace prizma::reference
