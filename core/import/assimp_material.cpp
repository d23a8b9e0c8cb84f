#include "core/import/assimp_material.h"

#include "core/import/file_finder.h"
#include "core/import/image_decoder.h"
#include "core/import/image_loader.h"

#include <assimp/GltfMaterial.h>
#include <assimp/ObjMaterial.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace prizma {
namespace {

std::optional<double> number(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
    ai_real value = 0;
    if (source.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value))
        return std::nullopt;
    return static_cast<double>(value);
}

std::optional<glm::dvec3> color(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
    aiColor3D value;
    if (source.Get(key, type, index, value) != aiReturn_SUCCESS)
        return std::nullopt;
    const glm::dvec3 rgb(value.r, value.g, value.b);
    if (!std::isfinite(rgb.x + rgb.y + rgb.z))
        return std::nullopt;
    return glm::max(rgb, 0.0);
}

double largest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

double fraction(double value) {
    return std::clamp(value, 0.0, 1.0);
}

bool isColoured(const glm::dvec3& v) {
    return largest(v) - std::min({v.x, v.y, v.z}) > 0.01;
}

/// What a Phong material (MTL above all) says, as far as the file says it.
struct Phong {
    glm::dvec3 diffuse, specular, transparent;
    double shininess, opacity, ior;
    int illum;
};

Phong readPhong(const aiMaterial& source) {
    Phong phong{};
    phong.diffuse = color(source, AI_MATKEY_COLOR_DIFFUSE).value_or(glm::dvec3(0.8));
    phong.specular = color(source, AI_MATKEY_COLOR_SPECULAR).value_or(glm::dvec3(0.0));
    phong.transparent = color(source, AI_MATKEY_COLOR_TRANSPARENT).value_or(glm::dvec3(1.0));
    phong.shininess = std::max(0.0, number(source, AI_MATKEY_SHININESS).value_or(0.0));
    phong.opacity = fraction(number(source, AI_MATKEY_OPACITY).value_or(1.0));
    phong.ior = number(source, AI_MATKEY_REFRACTI).value_or(1.0);
    source.Get(AI_MATKEY_OBJ_ILLUM, phong.illum);
    return phong;
}

/// Illumination models 4, 6, 7 and 9 are glass; others are if they let light through and bend it.
bool isGlass(const Phong& phong, bool textured) {
    if (phong.illum == 6 || phong.illum == 7)
        return true;
    const bool bends = phong.ior > 1.01;
    if (phong.illum == 4 || phong.illum == 9)
        return phong.opacity < 1.0 || (bends && !textured);
    return phong.opacity < 1.0 && bends && !textured;
}

/// Glass keeps the hue of its filter colour, but not its darkness: what MTL files call dark glass is often
/// clear.
glm::dvec3 glassTint(const Phong& phong) {
    const glm::dvec3 tint = isColoured(phong.transparent) ? phong.transparent : phong.diffuse;
    return largest(tint) > 0.05 ? tint / largest(tint) : glm::dvec3(1.0);
}

void mapPhong(const aiMaterial& source, Material& material) {
    const Phong phong = readPhong(source);
    const bool textured = source.GetTextureCount(aiTextureType_DIFFUSE) > 0;
    material.baseColor = glm::min(phong.diffuse, 1.0);
    // Exporters that write a texture often leave the colour black, though it should multiply.
    if (textured && phong.diffuse == glm::dvec3(0.0))
        material.baseColor = glm::dvec3(1.0);
    material.specular = fraction(largest(phong.specular));
    material.roughness = std::sqrt(2.0 / (phong.shininess + 2.0));
    material.alpha = phong.opacity;
    if (phong.ior > 1.01) // 1 (or 0) is what is written when nothing was meant
        material.ior = std::clamp(phong.ior, 1.0, 4.0);
    const bool mirror = phong.illum == 3 || phong.illum == 5 || phong.illum == 8;
    if (isGlass(phong, textured)) {
        material.transmission = phong.opacity < 1.0 ? 1.0 - phong.opacity : 1.0;
        material.alpha = 1.0;
        material.baseColor = glassTint(phong);
        material.roughness = 0.0;
        material.specular = 1.0; // exact Fresnel
    } else if (mirror && material.specular > 0.0) {
        material.roughness = 0.0;
        if (largest(phong.specular) >= largest(phong.diffuse)) {
            material.metallic = 1.0;
            material.baseColor = glm::min(phong.specular, 1.0);
        }
    }
}

/// glTF and others whose materials are like ours.
void mapPhysical(const aiMaterial& source, Material& material) {
    if (const auto base = color(source, AI_MATKEY_BASE_COLOR))
        material.baseColor = glm::min(*base, 1.0);
    aiColor4D base;
    if (source.Get(AI_MATKEY_BASE_COLOR, base) == aiReturn_SUCCESS && std::isfinite(base.a))
        material.alpha = fraction(base.a);
    aiString alphaMode;
    if (source.Get(AI_MATKEY_GLTF_ALPHAMODE, alphaMode) == aiReturn_SUCCESS &&
        std::string_view(alphaMode.C_Str()) == "OPAQUE")
        material.alpha = 1.0;
    material.specular = 1.0;
    material.ior = std::clamp(number(source, AI_MATKEY_REFRACTI).value_or(1.5), 1.0, 4.0);
    material.transmission = fraction(number(source, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0.0));
}

std::string materialName(const aiMaterial& source) {
    aiString name;
    if (source.Get(AI_MATKEY_NAME, name) != aiReturn_SUCCESS || name.length == 0)
        return "material";
    return name.C_Str();
}

/// Normal maps are bluish all over; height maps, which the same MTL keyword may mean, are grey.
bool looksLikeNormalMap(const Image& image) {
    if (image.bytes.empty())
        return false;
    double sums[3] = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i + 3 < image.bytes.size(); i += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += image.bytes[i + channel];
    return sums[2] > 1.3 * sums[0] && sums[2] > 1.3 * sums[1];
}

} // namespace

MaterialReader::MaterialReader(const aiScene& scene, std::string file, std::vector<std::string> folders,
                               Diagnostics& warnings)
    : scene_(scene), file_(std::move(file)), folders_(std::move(folders)), warnings_(warnings) {}

Material MaterialReader::read(const aiMaterial& source) {
    Material material;
    material.name = materialName(source);
    const auto metallic = number(source, AI_MATKEY_METALLIC_FACTOR);
    const auto roughness = number(source, AI_MATKEY_ROUGHNESS_FACTOR);
    mapPhong(source, material);
    if (color(source, AI_MATKEY_BASE_COLOR))
        mapPhysical(source, material);
    if (metallic)
        material.metallic = fraction(*metallic);
    if (roughness)
        material.roughness = fraction(*roughness);
    material.emission = color(source, AI_MATKEY_COLOR_EMISSIVE).value_or(glm::dvec3(0.0));
    material.emissionStrength = std::max(0.0, number(source, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1.0));
    readTextures(source, material);
    return material;
}

void MaterialReader::readTextures(const aiMaterial& source, Material& material) {
    material.baseColorTexture = readTexture(source, aiTextureType_BASE_COLOR);
    if (!material.baseColorTexture.isSet())
        material.baseColorTexture = readTexture(source, aiTextureType_DIFFUSE);
    material.normalTexture = readTexture(source, aiTextureType_NORMALS);
    if (material.normalTexture.isSet())
        return;
    const Texture bump = readTexture(source, aiTextureType_HEIGHT);
    if (!bump.image || looksLikeNormalMap(*bump.image))
        material.normalTexture = bump;
    else
        warnings_.push_back({Severity::Warning,
                             "It is a height map, which is not used; only normal maps are.", bump.file, 0});
}

Texture MaterialReader::readTexture(const aiMaterial& source, aiTextureType type) {
    aiString name;
    if (source.GetTextureCount(type) == 0 || source.GetTexture(type, 0, &name) != aiReturn_SUCCESS)
        return {};
    const std::string key = name.C_Str();
    if (cleanFileName(key).empty())
        return {};
    auto [found, isNew] = textures_.try_emplace(key);
    if (isNew)
        found->second = loadTexture(key);
    return found->second;
}

Texture MaterialReader::loadTexture(const std::string& name) {
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str()))
        return loadEmbedded(*embedded, name);
    std::optional<std::string> file;
    for (const std::string& folder : folders_)
        if (!file)
            file = findFile(folder, name);
    if (!file) {
        const std::string expected = expectedPath(folders_.front(), name);
        warnings_.push_back(
            {Severity::Warning, "The texture is missing; a checkerboard stands in for it.", expected, 0});
        return {expected, nullptr};
    }
    const auto image = loadImage(*file);
    if (!image) {
        warnings_.push_back({Severity::Warning, image.error().message, *file, 0});
        return {*file, nullptr};
    }
    return {*file, *image};
}

Texture MaterialReader::loadEmbedded(const aiTexture& source, const std::string& name) {
    const std::string file = file_ + "#" + name;
    if (source.mHeight == 0) {
        const auto image = decodeImage({reinterpret_cast<const char*>(source.pcData), source.mWidth}, file);
        if (image)
            return {file, *image};
        warnings_.push_back({Severity::Warning, image.error().message, file, 0});
        return {file, nullptr};
    }
    auto image = std::make_shared<Image>();
    image->width = static_cast<int>(source.mWidth);
    image->height = static_cast<int>(source.mHeight);
    const std::size_t texels = static_cast<std::size_t>(source.mWidth) * source.mHeight;
    image->bytes.reserve(texels * 4);
    for (std::size_t i = 0; i < texels; ++i) {
        const aiTexel& texel = source.pcData[i];
        image->bytes.insert(image->bytes.end(), {texel.r, texel.g, texel.b, texel.a});
        image->opaque = image->opaque && texel.a == 255;
    }
    return {file, image};
}

} // namespace prizma
