#include "core/render/material_store.h"

#include "core/scene/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

namespace prizma {
namespace {

constexpr std::size_t srgbTableSize = 256;

void store(float (&target)[3], const glm::dvec3& value) {
    for (int i = 0; i < 3; ++i)
        target[i] = static_cast<float>(value[i]);
}

ImagePtr makeCheckerboard() {
    auto image = std::make_shared<Image>();
    image->width = image->height = 16;
    for (int i = 0; i < 256; ++i) {
        const bool bright = ((i / 16 / 2) + (i % 16 / 2)) % 2 == 0;
        const std::uint8_t level = bright ? 255 : 40;
        image->bytes.insert(image->bytes.end(), {level, 0, level, 255});
    }
    return image;
}

struct UsedTexture {
    Texture texture;
    TexelUse use;
};

std::array<UsedTexture, 6> usedTextures(const Material& m) {
    const TexelUse base = m.alphaMode == AlphaMode::Opaque ? TexelUse::OpaqueColor : TexelUse::Color;
    return {{{m.baseColorTexture, base},
             {m.emissionTexture, TexelUse::OpaqueColor},
             {m.specularTexture, TexelUse::Data},
             {m.metallicRoughnessTexture, TexelUse::Data},
             {m.transmissionTexture, TexelUse::Data},
             {m.normalTexture, TexelUse::Normal}}};
}

/// Rows near the poles of an equirectangular picture stand for less of the sphere.
glm::dvec3 meanOverSphere(const Image& image) {
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int y = 0; y < image.height; ++y) {
        const double weight = std::sin((y + 0.5) / image.height * 3.14159265358979323846);
        for (int x = 0; x < image.width; ++x) {
            const auto first = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                    static_cast<std::size_t>(x));
            for (int c = 0; c < 3; ++c) {
                const auto i = first + static_cast<std::size_t>(c);
                sum[c] += weight * (image.bytes.empty() ? static_cast<double>(image.floats[i])
                                                        : decodeSrgb(image.bytes[i] / 255.0));
            }
            weights += weight;
        }
    }
    return weights > 0.0 ? sum / weights : sum;
}

/// Beer-Lambert coefficients, per scene unit.
glm::dvec3 absorptionOf(const Material& material) {
    constexpr double blackest = 1e-6;
    if (!(material.attenuationDistance > 0.0))
        return glm::dvec3(0.0);
    return -glm::log(glm::max(material.attenuationColor, glm::dvec3(blackest))) /
           material.attenuationDistance;
}

/// Whether a ray may get past a surface of this material as if it were not there (kernels/surface.clh).
bool hasHoles(const Material& material) {
    if (!material.doubleSided && material.transmission == 0.0)
        return true;
    if (material.alphaMode == AlphaMode::Opaque)
        return false;
    const double solid = material.alphaMode == AlphaMode::Mask ? material.alphaCutoff : 1.0;
    const ImagePtr& image = material.baseColorTexture.image;
    return material.alpha < solid || (image && !image->opaque);
}

} // namespace

Result<void> MaterialStore::uploadConstants(Context& context) {
    if (checkerboard_)
        return {};
    std::vector<std::uint32_t> table(srgbTableSize);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] =
            std::bit_cast<std::uint32_t>(static_cast<float>(decodeSrgb(static_cast<double>(i) / 255.0)));
    if (const auto place = texels_.add(context, table); !place)
        return std::unexpected(place.error());
    checkerboard_ = makeCheckerboard();
    return {};
}

MaterialStore::PictureKey MaterialStore::keyOf(const ImagePtr& image, TexelUse use) {
    return {image, use == TexelUse::OpaqueColor && image->opaque ? TexelUse::Color : use};
}

Result<void> MaterialStore::uploadPicture(Context& context, const PictureKey& key) {
    if (pictures_.contains(key))
        return {};
    const auto words = texelWords(*key.first, key.second);
    const auto offset = texels_.add(context, words);
    if (!offset)
        return std::unexpected(offset.error());
    pictures_[key] = {*offset, words.size(), 0};
    return {};
}

Result<void> MaterialStore::updateTextures(Context& context, const Scene& scene) {
    if (auto ok = uploadConstants(context); !ok)
        return ok;
    std::set<PictureKey> used{keyOf(checkerboard_, TexelUse::Color)};
    for (const Material& material : scene.materials)
        for (const auto& [texture, use] : usedTextures(material))
            if (texture.image)
                used.insert(keyOf(texture.image, use));
    if (scene.background.image.image)
        used.insert(keyOf(scene.background.image.image, TexelUse::Color));
    std::erase_if(pictures_, [&](const auto& entry) {
        if (used.contains(entry.first))
            return false;
        texels_.release(entry.second.offset, entry.second.words);
        return true;
    });
    for (const PictureKey& key : used)
        if (auto ok = uploadPicture(context, key); !ok)
            return ok;
    if (backgroundImage_ != scene.background.image.image) {
        backgroundImage_ = scene.background.image.image;
        backgroundImageMean_ = backgroundImage_ ? meanOverSphere(*backgroundImage_) : glm::dvec3(0.0);
    }
    std::vector<DeviceTexture> table;
    for (auto& [key, picture] : pictures_) {
        const Image& image = *key.first;
        const bool isFloat = image.bytes.empty();
        picture.index = static_cast<std::uint32_t>(table.size());
        std::uint32_t offset = picture.offset;
        for (const glm::ivec2& size : mipSizes(image.width, image.height)) {
            table.push_back({offset, size.x, size.y, isFloat ? 1u : 0u});
            offset +=
                static_cast<std::uint32_t>(size.x) * static_cast<std::uint32_t>(size.y) * (isFloat ? 4u : 1u);
        }
    }
    return textures_.assign(context, table, "textures");
}

void MaterialStore::setTextures(DeviceMaterial& out, const Material& material) const {
    const std::array places{&out.baseColorTexture,         &out.emissionTexture,     &out.specularTexture,
                            &out.metallicRoughnessTexture, &out.transmissionTexture, &out.normalTexture};
    const auto used = usedTextures(material);
    for (std::size_t i = 0; i < used.size(); ++i)
        *places[i] = used[i].texture.image ? indexOf(used[i].texture, used[i].use) : PRIZMA_NO_TEXTURE;
    // The checkerboard stands in for missing colours; other data that is missing changes nothing.
    out.baseColorTexture = indexOf(used[0].texture, used[0].use);
}

Result<void> MaterialStore::updateMaterials(Context& context, const Scene& scene) {
    indexOfMaterial_.clear();
    hasHoles_ = std::ranges::any_of(scene.materials, prizma::hasHoles);
    std::vector<DeviceMaterial> table;
    const auto append = [&](const Material& material) {
        DeviceMaterial out{};
        store(out.baseColor, material.baseColor);
        out.alpha = static_cast<float>(material.alpha);
        store(out.emission, material.emission * material.emissionStrength);
        out.specular = static_cast<float>(material.specular);
        out.metallic = static_cast<float>(material.metallic);
        out.roughness = static_cast<float>(material.roughness);
        out.transmission = static_cast<float>(material.transmission);
        out.ior = static_cast<float>(material.ior);
        store(out.specularColor, material.specularColor);
        store(out.absorption, absorptionOf(material));
        out.alphaMode = static_cast<std::uint32_t>(material.alphaMode);
        out.alphaCutoff = static_cast<float>(material.alphaCutoff);
        out.doubleSided = material.doubleSided ? 1 : 0;
        out.normalScale = static_cast<float>(material.normalScale);
        setTextures(out, material);
        indexOfMaterial_[material.id] = static_cast<std::uint32_t>(table.size());
        table.push_back(out);
    };
    append(Material{});
    for (const Material& material : scene.materials)
        append(material);
    return materials_.assign(context, table, "materials");
}

std::uint32_t MaterialStore::indexOf(Id material) const {
    const auto found = indexOfMaterial_.find(material);
    return found == indexOfMaterial_.end() ? 0 : found->second;
}

std::uint32_t MaterialStore::indexOf(const Texture& texture, TexelUse use) const {
    if (!texture.isSet())
        return PRIZMA_NO_TEXTURE;
    const auto found =
        pictures_.find(texture.image ? keyOf(texture.image, use) : keyOf(checkerboard_, TexelUse::Color));
    return found == pictures_.end() ? PRIZMA_NO_TEXTURE : found->second.index;
}

} // namespace prizma
