#include "core/import/assimp_material.h"

#include "core/import/derived_pictures.h"
#include "core/import/image_decoder.h"
#include "core/import/mtl_material.h"
#include "core/import/phong_material.h"

#include <assimp/GltfMaterial.h>

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

/// assimp's glTF importer stores truth values as single bytes, for which it has no getter.
bool isTrue(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
    const aiMaterialProperty* property = nullptr;
    if (aiGetMaterialProperty(&source, key, type, index, &property) != aiReturn_SUCCESS)
        return false;
    return property->mDataLength > 0 && std::any_of(property->mData, property->mData + property->mDataLength,
                                                    [](char byte) { return byte != 0; });
}

std::string text(const aiMaterial& source, const char* key, unsigned type, unsigned index) {
    aiString value;
    return source.Get(key, type, index, value) == aiReturn_SUCCESS ? value.C_Str() : std::string();
}

double fraction(double value) {
    return std::clamp(value, 0.0, 1.0);
}

PhongMaterial phongOf(const aiMaterial& source) {
    PhongMaterial phong;
    phong.diffuse = color(source, AI_MATKEY_COLOR_DIFFUSE).value_or(phong.diffuse);
    phong.specular = color(source, AI_MATKEY_COLOR_SPECULAR).value_or(phong.specular) *
                     std::max(0.0, number(source, AI_MATKEY_SHININESS_STRENGTH).value_or(1.0));
    phong.filter = color(source, AI_MATKEY_COLOR_TRANSPARENT).value_or(phong.filter);
    phong.shininess = std::max(0.0, number(source, AI_MATKEY_SHININESS).value_or(phong.shininess));
    phong.opacity = fraction(number(source, AI_MATKEY_OPACITY).value_or(phong.opacity));
    phong.ior = number(source, AI_MATKEY_REFRACTI).value_or(phong.ior);
    phong.isTextured = source.GetTextureCount(aiTextureType_DIFFUSE) > 0;
    return phong;
}

std::string materialName(const aiMaterial& source) {
    const std::string name = text(source, AI_MATKEY_NAME);
    return name.empty() ? "material" : name;
}

/// A picture inside the model file: the content of a picture file, or plain texels.
Result<ImagePtr> decodeEmbedded(const aiTexture& source, const std::string& file) {
    if (source.mHeight == 0)
        return decodeImage({reinterpret_cast<const char*>(source.pcData), source.mWidth}, file);
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
    return image;
}

} // namespace

MaterialReader::MaterialReader(const aiScene& scene, std::string file, std::vector<std::string> folders,
                               MaterialSources sources, double unitScale, Diagnostics& warnings)
    : scene_(scene),
      file_(file),
      sources_(std::move(sources)),
      unitScale_(unitScale),
      pictures_(std::move(file), std::move(folders), warnings) {}

Material MaterialReader::read(unsigned index) {
    const aiMaterial& source = *scene_.mMaterials[index];
    const std::string name = materialName(source);
    if (const auto found = sources_.mtl.find(name); found != sources_.mtl.end())
        return materialOf(found->second, name, pictures_);
    Material material = color(source, AI_MATKEY_BASE_COLOR) ? readPhysical(source) : readPhong(source);
    material.name = name;
    material.emission = color(source, AI_MATKEY_COLOR_EMISSIVE).value_or(glm::dvec3(0.0));
    material.emissionStrength = std::max(0.0, number(source, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1.0));
    readTextures(source, material);
    if (!text(source, AI_MATKEY_GLTF_ALPHAMODE).empty())
        readGltf(source, index, material);
    return material;
}

Material MaterialReader::readPhong(const aiMaterial& source) {
    Material material;
    applyPhong(phongOf(source), material);
    if (const auto metallic = number(source, AI_MATKEY_METALLIC_FACTOR))
        material.metallic = fraction(*metallic);
    if (const auto roughness = number(source, AI_MATKEY_ROUGHNESS_FACTOR))
        material.roughness = fraction(*roughness);
    return material;
}

/// glTF and others whose materials are like ours.
Material MaterialReader::readPhysical(const aiMaterial& source) {
    Material material;
    material.baseColor = glm::min(color(source, AI_MATKEY_BASE_COLOR).value_or(material.baseColor), 1.0);
    aiColor4D base;
    if (source.Get(AI_MATKEY_BASE_COLOR, base) == aiReturn_SUCCESS && std::isfinite(base.a))
        material.alpha = fraction(static_cast<double>(base.a));
    material.specular = fraction(number(source, AI_MATKEY_SPECULAR_FACTOR).value_or(1.0));
    material.metallic = fraction(number(source, AI_MATKEY_METALLIC_FACTOR).value_or(0.0));
    material.roughness = fraction(number(source, AI_MATKEY_ROUGHNESS_FACTOR).value_or(0.5));
    material.ior = std::clamp(number(source, AI_MATKEY_REFRACTI).value_or(1.5), 1.0, 4.0);
    material.transmission = fraction(number(source, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0.0));
    const double distance = number(source, AI_MATKEY_VOLUME_ATTENUATION_DISTANCE).value_or(0.0);
    material.attenuationDistance = std::max(0.0, distance) * unitScale_;
    material.attenuationColor =
        glm::min(color(source, AI_MATKEY_VOLUME_ATTENUATION_COLOR).value_or(glm::dvec3(1.0)), 1.0);
    return material;
}

void MaterialReader::readGltf(const aiMaterial& source, unsigned index, Material& material) {
    const std::string mode = text(source, AI_MATKEY_GLTF_ALPHAMODE);
    material.alphaMode = mode == "MASK"    ? AlphaMode::Mask
                         : mode == "BLEND" ? AlphaMode::Blend
                                           : AlphaMode::Opaque;
    material.alphaCutoff = fraction(number(source, AI_MATKEY_GLTF_ALPHACUTOFF).value_or(0.5));
    material.doubleSided = isTrue(source, AI_MATKEY_TWOSIDED);
    if (index >= sources_.gltf.size())
        return;
    const GltfExtras& extras = sources_.gltf[index];
    material.emissionStrength = std::max(0.0, extras.emissiveStrength.value_or(1.0));
    material.specular = fraction(extras.specular.value_or(1.0));
    material.specularColor = glm::max(extras.specularColor.value_or(glm::dvec3(1.0)), 0.0);
    material.specularTexture = specularTexture(extras);
    if (extras.hasMovedTextures)
        pictures_.warn("Textures of \"" + material.name +
                           "\" are moved or scaled (KHR_texture_transform), which is not supported: they are "
                           "used as they are.",
                       file_);
}

Texture MaterialReader::specularTexture(const GltfExtras& extras) {
    if (extras.specularContent.empty())
        return pictures_.read(extras.specularFile);
    const std::string name = "image " + std::to_string(extras.specularImage);
    return pictures_.embedded(name, [&] { return decodeImage(extras.specularContent, file_ + "#" + name); });
}

Texture MaterialReader::baseColorTexture(const aiMaterial& source) {
    Texture color = readTexture(source, aiTextureType_BASE_COLOR);
    if (!color.isSet())
        color = readTexture(source, aiTextureType_DIFFUSE);
    const Texture opacity = readTexture(source, aiTextureType_OPACITY);
    if (!opacity.image || opacity.file == color.file || (color.isSet() && !color.image))
        return color;
    return pictures_.made("colour " + color.file + ", alpha " + opacity.file,
                          [&] { return withOpacity(color.image, opacity.image); });
}

void MaterialReader::readTextures(const aiMaterial& source, Material& material) {
    material.baseColorTexture = baseColorTexture(source);
    material.emissionTexture = readTexture(source, aiTextureType_EMISSION_COLOR);
    if (!material.emissionTexture.isSet())
        material.emissionTexture = readTexture(source, aiTextureType_EMISSIVE);
    // Where the material's emission is not said, its texture is all there is.
    if (material.emissionTexture.image && material.emission == glm::dvec3(0.0) &&
        text(source, AI_MATKEY_GLTF_ALPHAMODE).empty())
        material.emission = glm::dvec3(1.0);
    if (const Texture specular = readTexture(source, aiTextureType_SPECULAR); specular.image)
        material.specularTexture =
            pictures_.made("alpha is " + specular.file, [&] { return valuesInAlpha(specular.image); });
    material.transmissionTexture = readTexture(source, aiTextureType_TRANSMISSION);
    readMetallicRoughness(source, material);
    readNormals(source, material);
}

void MaterialReader::readMetallicRoughness(const aiMaterial& source, Material& material) {
    const Texture metallic = readTexture(source, aiTextureType_METALNESS);
    const Texture roughness = readTexture(source, aiTextureType_DIFFUSE_ROUGHNESS);
    if (metallic.file == roughness.file) { // packed, as glTF has it
        material.metallicRoughnessTexture = metallic;
        return;
    }
    if (!metallic.image && !roughness.image)
        return;
    // Apart they come from programs in which a texture takes the number's place.
    material.metallic = metallic.image ? 1.0 : material.metallic;
    material.roughness = roughness.image ? 1.0 : material.roughness;
    material.metallicRoughnessTexture =
        pictures_.made("roughness " + roughness.file + ", metallic " + metallic.file,
                       [&] { return metallicRoughness(roughness.image, metallic.image); });
}

void MaterialReader::readNormals(const aiMaterial& source, Material& material) {
    material.normalTexture = readTexture(source, aiTextureType_NORMALS);
    if (!material.normalTexture.isSet())
        material.normalTexture = readTexture(source, aiTextureType_NORMAL_CAMERA);
    if (const auto scale = number(source, AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0)))
        material.normalScale = *scale;
    if (material.normalTexture.isSet())
        return;
    const Texture bump = readTexture(source, aiTextureType_HEIGHT);
    const double depth = number(source, AI_MATKEY_BUMPSCALING).value_or(1.0);
    if (!bump.image || looksLikeNormalMap(*bump.image))
        material.normalTexture = bump;
    else
        material.normalTexture =
            pictures_.made("normals of heights " + std::to_string(depth) + " times " + bump.file,
                           [&] { return normalsFromHeights(bump.image, depth); });
}

Texture MaterialReader::readTexture(const aiMaterial& source, aiTextureType type) {
    aiString name;
    if (source.GetTextureCount(type) == 0 || source.GetTexture(type, 0, &name) != aiReturn_SUCCESS)
        return {};
    return readNamed(name.C_Str());
}

Texture MaterialReader::readNamed(const std::string& name) {
    const aiTexture* embedded = name.empty() ? nullptr : scene_.GetEmbeddedTexture(name.c_str());
    if (!embedded)
        return pictures_.read(name);
    return pictures_.embedded(name, [&] { return decodeEmbedded(*embedded, file_ + "#" + name); });
}

} // namespace prizma
