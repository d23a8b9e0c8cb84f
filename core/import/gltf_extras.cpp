#include "core/import/gltf_extras.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace prizma {
namespace {

using nlohmann::json;

/// The JSON text: all of a .gltf, the first chunk of a .glb.
std::string_view jsonOf(std::string_view content) {
    constexpr std::size_t headerBytes = 20; // "glTF", version, length, and the chunk's length and type
    if (!content.starts_with("glTF"))
        return content;
    if (content.size() < headerBytes)
        return {};
    std::uint32_t length = 0;
    std::memcpy(&length, content.data() + 12, sizeof length);
    return content.substr(headerBytes, length);
}

/// Member `name` of an object; null where there is none.
const json& member(const json& value, const char* name) {
    static const json none;
    if (!value.is_object())
        return none;
    const auto found = value.find(name);
    return found == value.end() ? none : *found;
}

const json& element(const json& list, const json& index) {
    static const json none;
    if (!list.is_array() || !index.is_number_unsigned() || index.get<std::size_t>() >= list.size())
        return none;
    return list[index.get<std::size_t>()];
}

std::optional<double> number(const json& value) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
        return std::nullopt;
    return value.get<double>();
}

std::optional<glm::dvec3> color(const json& value) {
    if (!value.is_array() || value.size() != 3)
        return std::nullopt;
    glm::dvec3 rgb(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto component = number(value[i]);
        if (!component)
            return std::nullopt;
        rgb[static_cast<glm::length_t>(i)] = *component;
    }
    return rgb;
}

std::string imageName(const json& file, const json& texture) {
    const json& source = member(element(member(file, "textures"), member(texture, "index")), "source");
    const json& image = element(member(file, "images"), source);
    const json& uri = member(image, "uri");
    if (uri.is_string() && !uri.get_ref<const std::string&>().starts_with("data:"))
        return uri.get<std::string>();
    if (!image.is_object())
        return {};
    // assimp numbers the pictures inside the file as they come.
    std::size_t number = 0;
    for (std::size_t i = 0; i < source.get<std::size_t>(); ++i) {
        const json& other = member(member(file, "images")[i], "uri");
        number += !other.is_string() || other.get_ref<const std::string&>().starts_with("data:") ? 1 : 0;
    }
    return "*" + std::to_string(number);
}

/// Whether a texture anywhere in the material is moved or scaled.
bool hasTransform(const json& value) {
    if (!member(member(value, "extensions"), "KHR_texture_transform").is_null())
        return true;
    if (!value.is_structured())
        return false;
    for (const json& inner : value) // no deeper than the parser allowed
        if (hasTransform(inner))
            return true;
    return false;
}

GltfExtras extrasOf(const json& file, const json& material) {
    GltfExtras extras;
    const json& extensions = member(material, "extensions");
    extras.emissiveStrength =
        number(member(member(extensions, "KHR_materials_emissive_strength"), "emissiveStrength"));
    const json& specular = member(extensions, "KHR_materials_specular");
    extras.specular = number(member(specular, "specularFactor"));
    extras.specularColor = color(member(specular, "specularColorFactor"));
    extras.specularImage = imageName(file, member(specular, "specularTexture"));
    extras.hasMovedTextures = hasTransform(material);
    return extras;
}

} // namespace

std::vector<GltfExtras> readGltfExtras(std::string_view content) {
    constexpr int deepest = 64;
    const auto notTooDeep = [](int depth, json::parse_event_t, json&) { return depth < deepest; };
    const json file = json::parse(jsonOf(content), notTooDeep, false);
    std::vector<GltfExtras> list;
    if (const json& materials = member(file, "materials"); materials.is_array())
        for (const json& material : materials)
            list.push_back(extrasOf(file, material));
    return list;
}

} // namespace prizma
