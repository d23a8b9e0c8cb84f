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
    std::string specularFile;      ///< Its texture's picture, if that is a file of its own,
    std::string specularContent;   ///< or the content of the picture file inside the model file.
    int specularImage = -1;        ///< Its number among the file's pictures; -1 if there is none.
    bool hasMovedTextures = false; ///< KHR_texture_transform
};

/// One for each of the file's materials, in its order; none if `content` (of a .gltf or .glb) is damaged. Of
/// pictures inside the file those are read that are in the text or in a .glb's own buffer.
std::vector<GltfExtras> readGltfExtras(std::string_view content);

} // namespace prizma
