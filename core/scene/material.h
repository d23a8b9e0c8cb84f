#pragma once

#include "core/scene/id.h"
#include "core/scene/image.h"

#include <glm/glm.hpp>

#include <string>

namespace prizma {

/// The glTF 2.0 metallic-roughness model with KHR_materials_specular, _transmission, _ior and
/// _emissive_strength. Colours are linear. `specular` 0 and `metallic` 0 is pure Lambert; `metallic` 1 and
/// `roughness` 0 with a white base colour is a perfect mirror; `transmission` 1 and `roughness` 0 is smooth
/// glass.
struct Material {
    Id id = noId;
    std::string name;

    glm::dvec3 baseColor{0.8};
    Texture baseColorTexture;
    double alpha = 1.0;

    double specular = 1.0;
    double metallic = 0.0;
    double roughness = 0.5;
    double transmission = 0.0;
    double ior = 1.5;

    glm::dvec3 emission{0.0};
    double emissionStrength = 1.0; ///< Radiance is emission times this.

    Texture normalTexture;

    friend bool operator==(const Material&, const Material&) = default;
};

} // namespace prizma
