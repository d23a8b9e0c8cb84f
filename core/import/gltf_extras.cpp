#include "core/import/gltf_extras.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace prizma {
namespace {

using nlohmann::json;

/// The JSON text: all of a .gltf, the first chunk of a .glb, whose second is its own buffer.
struct Chunks {
    std::string_view json, binary;
};

Chunks chunksOf(std::string_view content) {
    constexpr std::size_t fileHeader = 12; // "glTF", version, length
    constexpr std::size_t chunkHeader = 8; // length, type
    if (!content.starts_with("glTF"))
        return {content, {}};
    content.remove_prefix(std::min(fileHeader, content.size()));
    const auto next = [&]() -> std::string_view {
        if (content.size() < chunkHeader)
            return {};
        std::uint32_t length = 0;
        std::memcpy(&length, content.data(), sizeof length);
        const std::string_view chunk = content.substr(chunkHeader, length);
        content.remove_prefix(chunkHeader + chunk.size());
        return chunk;
    };
    const std::string_view text = next();
    return {text, next()};
}

/// What of `text` is base64, up to the first character that is not.
std::string fromBase64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos)
            break;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<char>(bits >> count & 255U));
        }
    }
    return bytes;
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

std::size_t index(const json& value) {
    return value.is_number_unsigned() ? value.get<std::size_t>() : 0;
}

/// A picture's content in a .glb's own buffer.
std::string contentOf(const json& file, const json& image, std::string_view binary) {
    const json& view = element(member(file, "bufferViews"), member(image, "bufferView"));
    const std::size_t offset = index(member(view, "byteOffset"));
    if (!view.is_object() || index(member(view, "buffer")) != 0 || offset > binary.size())
        return {};
    return std::string(binary.substr(offset, index(member(view, "byteLength"))));
}

void readSpecularTexture(const json& file, const json& texture, std::string_view binary, GltfExtras& extras) {
    constexpr std::string_view inText = ";base64,";
    const json& source = member(element(member(file, "textures"), member(texture, "index")), "source");
    const json& image = element(member(file, "images"), source);
    if (!image.is_object())
        return;
    extras.specularImage = static_cast<int>(index(source));
    const json& uri = member(image, "uri");
    if (!uri.is_string()) {
        extras.specularContent = contentOf(file, image, binary);
        return;
    }
    const std::string_view text = uri.get_ref<const std::string&>();
    if (!text.starts_with("data:"))
        extras.specularFile = text;
    else if (const std::size_t start = text.find(inText); start != std::string_view::npos)
        extras.specularContent = fromBase64(text.substr(start + inText.size()));
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

GltfExtras extrasOf(const json& file, const json& material, std::string_view binary) {
    GltfExtras extras;
    const json& extensions = member(material, "extensions");
    extras.emissiveStrength =
        number(member(member(extensions, "KHR_materials_emissive_strength"), "emissiveStrength"));
    const json& specular = member(extensions, "KHR_materials_specular");
    extras.specular = number(member(specular, "specularFactor"));
    extras.specularColor = color(member(specular, "specularColorFactor"));
    readSpecularTexture(file, member(specular, "specularTexture"), binary, extras);
    extras.hasMovedTextures = hasTransform(material);
    return extras;
}

} // namespace

std::vector<GltfExtras> readGltfExtras(std::string_view content) {
    constexpr int deepest = 64;
    const auto notTooDeep = [](int depth, json::parse_event_t, json&) { return depth < deepest; };
    const Chunks chunks = chunksOf(content);
    const json file = json::parse(chunks.json, notTooDeep, false);
    std::vector<GltfExtras> list;
    if (const json& materials = member(file, "materials"); materials.is_array())
        for (const json& material : materials)
            list.push_back(extrasOf(file, material, chunks.binary));
    return list;
}

} // namespace prizma
