#pragma once

#include "core/compute/arena.h"
#include "core/render/mip_levels.h"
#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <map>
#include <unordered_map>

namespace prizma {

/// Materials and textures on the device.
class MaterialStore {
  public:
    /// Brings the pictures that materials and background use onto the device, each once, and drops the
    /// others.
    Result<void> updateTextures(Context& context, const Scene& scene);

    /// The material table; textures are up to date.
    Result<void> updateMaterials(Context& context, const Scene& scene);

    /// Place of a material in the table; 0, a neutral grey, for an id that is not there.
    std::uint32_t indexOf(Id material) const;

    /// Place of a texture's finest level in the table: PRIZMA_NO_TEXTURE for none, the checkerboard for one
    /// that is missing. Its other levels follow.
    std::uint32_t indexOf(const Texture& texture, TexelUse use = TexelUse::Color) const;

    /// Mean radiance of the background's image over all directions, without its intensity; 0 without an
    /// image.
    const glm::dvec3& backgroundImageMean() const { return backgroundImageMean_; }

    const Buffer<DeviceMaterial>& materials() const { return materials_; }
    const Buffer<DeviceTexture>& textures() const { return textures_; }
    const Buffer<std::uint32_t>& texels() const { return texels_.buffer(); }

    /// Whether light may get past a surface of some material: through its alpha or from behind.
    bool hasHoles() const { return hasHoles_; }

  private:
    struct Picture {
        std::uint32_t offset = 0;
        std::size_t words = 0;
        std::uint32_t index = 0;
    };
    using PictureKey = std::pair<ImagePtr, TexelUse>;

    static PictureKey keyOf(const ImagePtr& image, TexelUse use);
    Result<void> uploadPicture(Context& context, const PictureKey& key);
    Result<void> uploadConstants(Context& context);
    void setTextures(DeviceMaterial& out, const Material& material) const;

    Buffer<DeviceMaterial> materials_;
    Buffer<DeviceTexture> textures_;
    Arena<std::uint32_t> texels_{"textures"};
    bool hasHoles_ = false;
    std::unordered_map<Id, std::uint32_t> indexOfMaterial_;
    std::map<PictureKey, Picture> pictures_;
    glm::dvec3 backgroundImageMean_{0.0};
    ImagePtr backgroundImage_; ///< The image that the mean is of.
    ImagePtr checkerboard_;    ///< Stands in for pictures that are missing.
};

} // namespace prizma
