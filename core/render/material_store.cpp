#include "core/render/material_store.h"

#include "core/scene/srgb.h"

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

std::size_t wordCount(const Image& image) {
    return image.bytes.empty() ? image.floats.size() : image.bytes.size() / 4;
}

std::vector<std::uint32_t> wordsOf(const Image& image) {
    std::vector<std::uint32_t> words(wordCount(image));
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (image.bytes.empty()) {
            words[i] = std::bit_cast<std::uint32_t>(image.floats[i]);
        } else {
            const std::uint8_t* p = &image.bytes[4 * i];
            words[i] = p[0] | static_cast<std::uint32_t>(p[1]) << 8 | static_cast<std::uint32_t>(p[2]) << 16 |
                       static_cast<std::uint32_t>(p[3]) << 24;
        }
    }
    return words;
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
    return uploadPicture(context, checkerboard_);
}

Result<void> MaterialStore::uploadPicture(Context& context, const ImagePtr& image) {
    if (pictures_.contains(image.get()))
        return {};
    const auto offset = texels_.add(context, wordsOf(*image));
    if (!offset)
        return std::unexpected(offset.error());
    pictures_[image.get()] = {image, *offset, 0};
    return {};
}

Result<void> MaterialStore::updateTextures(Context& context, const Scene& scene) {
    if (auto ok = uploadConstants(context); !ok)
        return ok;
    std::set<ImagePtr> used{checkerboard_};
    for (const Material& material : scene.materials)
        for (const Texture& texture : texturesOf(material))
            used.insert(texture.image);
    used.insert(scene.background.image.image);
    used.erase(nullptr);
    std::erase_if(pictures_, [&](const auto& entry) {
        if (used.contains(entry.second.image))
            return false;
        texels_.release(entry.second.offset, wordCount(*entry.second.image));
        return true;
    });
    for (const ImagePtr& image : used)
        if (auto ok = uploadPicture(context, image); !ok)
            return ok;
    if (backgroundImage_ != scene.background.image.image) {
        backgroundImage_ = scene.background.image.image;
        backgroundImageMean_ = backgroundImage_ ? meanOverSphere(*backgroundImage_) : glm::dvec3(0.0);
    }
    std::vector<DeviceTexture> table;
    for (auto& [image, picture] : pictures_) {
        picture.index = static_cast<std::uint32_t>(table.size());
        table.push_back({picture.offset, image->width, image->height, image->bytes.empty() ? 1u : 0u});
    }
    return textures_.assign(context, table, "textures");
}

Result<void> MaterialStore::updateMaterials(Context& context, const Scene& scene) {
    indexOfMaterial_.clear();
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
        // The checkerboard stands in for missing colours; other data that is missing changes nothing.
        const auto dataIndex = [this](const Texture& texture) {
            return texture.image ? indexOf(texture) : PRIZMA_NO_TEXTURE;
        };
        out.baseColorTexture = indexOf(material.baseColorTexture);
        out.emissionTexture = dataIndex(material.emissionTexture);
        out.specularTexture = dataIndex(material.specularTexture);
        out.metallicRoughnessTexture = dataIndex(material.metallicRoughnessTexture);
        out.transmissionTexture = dataIndex(material.transmissionTexture);
        out.normalTexture = dataIndex(material.normalTexture);
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

std::uint32_t MaterialStore::indexOf(const Texture& texture) const {
    if (!texture.isSet())
        return PRIZMA_NO_TEXTURE;
    const auto found = pictures_.find(texture.image ? texture.image.get() : checkerboard_.get());
    return found == pictures_.end() ? PRIZMA_NO_TEXTURE : found->second.index;
}

} // namespace prizma
