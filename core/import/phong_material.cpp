#include "core/import/phong_material.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double blackest = 0.05;    ///< Diffuse colours of metals are not brighter than this.
constexpr double dullestMetal = 0.5; ///< Their specular ones are.
constexpr double neutralIor = 1.01;  ///< 1 (or 0) is what is written when nothing was meant.

double largest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

bool isColoured(const glm::dvec3& v) {
    return largest(v) - std::min({v.x, v.y, v.z}) > 0.01;
}

bool isGlass(const PhongMaterial& phong) {
    if (phong.illumination == 6 || phong.illumination == 7)
        return true;
    const bool bends = phong.ior > neutralIor;
    if (phong.illumination == 4 || phong.illumination == 9)
        return phong.opacity < 1.0 || (bends && !phong.isTextured);
    return phong.opacity < 1.0 && bends && !phong.isTextured;
}

bool isMirror(const PhongMaterial& phong) {
    return (phong.illumination == 3 || phong.illumination == 5 || phong.illumination == 8) &&
           largest(phong.specular) > 0.0;
}

bool isMetal(const PhongMaterial& phong) {
    if (isMirror(phong))
        return largest(phong.specular) >= largest(phong.diffuse);
    return !phong.isTextured && largest(phong.diffuse) < blackest && largest(phong.specular) > dullestMetal;
}

glm::dvec3 glassTint(const PhongMaterial& phong) {
    const glm::dvec3 tint = isColoured(phong.filter) ? phong.filter : phong.diffuse;
    return largest(tint) > 0.05 ? tint / largest(tint) : glm::dvec3(1.0);
}

void makeGlass(const PhongMaterial& phong, Material& material) {
    material.transmission = phong.opacity < 1.0 ? 1.0 - phong.opacity : 1.0;
    material.alpha = 1.0;
    material.baseColor = glassTint(phong);
    material.roughness = 0.0;
    material.specular = 1.0; // exact Fresnel
    material.specularColor = glm::dvec3(1.0);
}

} // namespace

double roughnessOfShininess(double shininess) {
    return std::pow(2.0 / (std::max(shininess, 0.0) + 2.0), 0.25);
}

void applyPhong(const PhongMaterial& phong, Material& material) {
    const bool whitened = phong.isTextured && phong.diffuse == glm::dvec3(0.0);
    material.baseColor = whitened ? glm::dvec3(1.0) : glm::clamp(phong.diffuse, 0.0, 1.0);
    const double brightness = largest(phong.specular);
    material.specular = std::clamp(brightness, 0.0, 1.0);
    material.specularColor = brightness > 0.0 ? glm::max(phong.specular, 0.0) / brightness : glm::dvec3(1.0);
    material.roughness = roughnessOfShininess(phong.shininess);
    material.alpha = std::clamp(phong.opacity, 0.0, 1.0);
    if (phong.ior > neutralIor)
        material.ior = std::clamp(phong.ior, 1.0, 4.0);
    if (isGlass(phong)) {
        makeGlass(phong, material);
        return;
    }
    if (isMirror(phong))
        material.roughness = 0.0;
    if (isMetal(phong)) {
        material.metallic = 1.0;
        material.baseColor = glm::clamp(phong.specular, 0.0, 1.0);
        material.specularColor = glm::dvec3(1.0);
    }
}

} // namespace prizma
