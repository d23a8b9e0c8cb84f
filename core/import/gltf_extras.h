#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prizma {

/// What a glTF material says that assimp 5.2 does not pass on.
struct GltfExtras {
    std::optional<double> emissiveStrength; ///< KHR_materials_emissive_strength
    std::optional<double> specular;         ///< KHR_materials_specular
    std::optional<glm::dvec3> specularColor;
    std::string specularImage;     ///< As assimp names it: a file, or *n for one inside the model file.
    bool hasMovedTextures = false; ///< KHR_texture_transform
};

/// One for each of the file's materials, in its order; none if `content` (of a .gltf or .glb) is damaged.
std::vector<GltfExtras> readGltfExtras(std::string_view content);

} // namespace prizma
