#pragma once

#include "core/scene/id.h"
#include "core/scene/image.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

namespace prizma {

/// What a surface's alpha does.
enum class AlphaMode {
    Blend,  ///< The share of light that meets the surface at all.
    Mask,   ///< Below the cut-off there is a hole.
    Opaque, ///< Nothing.
};

/// The glTF 2.0 metallic-roughness model with KHR_materials_specular, _transmission, _ior, _volume's
/// attenuation and _emissive_strength. Colours are linear. `specular` 0 and `metallic` 0 is pure Lambert;
/// `metallic` 1 and `roughness` 0 with a white base colour is a perfect mirror; `transmission` 1 and
/// `roughness` 0 is smooth glass.
struct Material {
    Id id = noId;
    std::string name;

    glm::dvec3 baseColor{0.8};
    Texture baseColorTexture;
    double alpha = 1.0; ///< Times the base colour texture's.
    AlphaMode alphaMode = AlphaMode::Blend;
    double alphaCutoff = 0.5;
    bool doubleSided = true; ///< Otherwise a surface that lets no light through is not there from behind.

    double specular = 1.0;
    glm::dvec3 specularColor{1.0};
    Texture specularTexture; ///< Its alpha multiplies `specular`.
    double metallic = 0.0;
    double roughness = 0.5;
    Texture metallicRoughnessTexture; ///< Blue multiplies `metallic`, green `roughness`; linear.
    double transmission = 0.0;
    Texture transmissionTexture; ///< Its red multiplies `transmission`; linear.
    double ior = 1.5;
    glm::dvec3 attenuationColor{1.0}; ///< What is left of white light after `attenuationDistance` inside.
    double attenuationDistance = 0.0; ///< In scene units; 0: nothing is absorbed.

    glm::dvec3 emission{0.0};
    double emissionStrength = 1.0; ///< Radiance is emission times this.

    Texture emissionTexture;
    Texture normalTexture; ///< Tangent space, linear.
    double normalScale = 1.0;

    friend bool operator==(const Material&, const Material&) = default;
};

/// All textures of a material, set or not.
inline std::array<Texture, 6> texturesOf(const Material& m) {
    return {m.baseColorTexture,    m.specularTexture, m.metallicRoughnessTexture,
            m.transmissionTexture, m.emissionTexture, m.normalTexture};
}

} // namespace prizma
