#include "core/import/mtl_material.h"

#include "core/import/derived_pictures.h"
#include "core/import/phong_material.h"

#include <algorithm>

namespace prizma {
namespace {

constexpr double largestExponent = 1000.0;

bool isPhysical(const MtlMaterial& m) {
    return m.roughness || m.metallic || m.roughnessMap.isSet() || m.metallicMap.isSet();
}

bool mayBeGlass(const MtlMaterial& m) {
    const int illumination = m.illumination.value_or(-1);
    return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
}

double opacityOf(const MtlMaterial& m) {
    if (m.dissolve)
        return *m.dissolve == 0.0 && m.dissolveMap.isSet() ? 1.0 : std::clamp(*m.dissolve, 0.0, 1.0);
    const double transparency = std::clamp(m.transparency.value_or(0.0), 0.0, 1.0);
    return transparency == 1.0 && !mayBeGlass(m) ? 1.0 : 1.0 - transparency;
}

PhongMaterial phongOf(const MtlMaterial& m) {
    PhongMaterial phong;
    phong.isTextured = m.diffuseMap.isSet() || m.dissolveMap.isSet();
    phong.diffuse = m.diffuse.value_or(m.diffuseMap.isSet() ? glm::dvec3(1.0) : phong.diffuse);
    phong.specular = m.specular.value_or(glm::dvec3(isPhysical(m) ? 1.0 : 0.0));
    if (m.specularMap.isSet() && m.specular.value_or(glm::dvec3(0.0)) == glm::dvec3(0.0))
        phong.specular = glm::dvec3(1.0);
    phong.filter = m.filter.value_or(phong.filter);
    phong.shininess = m.shininess.value_or(phong.shininess);
    phong.opacity = opacityOf(m);
    phong.ior = m.ior.value_or(phong.ior);
    phong.illumination = m.illumination.value_or(-1);
    return phong;
}

void applyPhysical(const MtlMaterial& m, const PhongMaterial& phong, Material& material) {
    if (material.transmission == 0.0) {
        material.baseColor = glm::clamp(phong.diffuse, 0.0, 1.0);
        material.metallic = std::clamp(m.metallic.value_or(0.0), 0.0, 1.0);
    }
    material.roughness = std::clamp(m.roughness.value_or(material.roughness), 0.0, 1.0);
}

/// Reads a material's maps into its textures.
class MapReader {
  public:
    MapReader(const MtlMaterial& source, PictureReader& pictures) : source_(source), pictures_(pictures) {}

    void readInto(Material& material) {
        material.baseColorTexture = baseColor();
        readEmission(material);
        if (const Texture specular = read(source_.specularMap); specular.image)
            material.specularTexture = pictures_.made("alpha is " + source_.specularMap.file,
                                                      [&] { return valuesInAlpha(specular.image); });
        readMetallicRoughness(material);
        readNormals(material);
    }

  private:
    Texture read(const MtlMap& map) {
        Texture texture = pictures_.read(map.file);
        if (map.isPlaced && texture.image)
            pictures_.warn("The model moves or scales this texture (-o, -s or -t), which is not supported: "
                           "it is used as it is.",
                           texture.file);
        return texture;
    }

    Texture baseColor() {
        Texture color = read(source_.diffuseMap);
        if (source_.dissolveMap.file == source_.diffuseMap.file) // its own alpha, or a mistake
            return color;
        const Texture opacity = read(source_.dissolveMap);
        if (!opacity.image || (color.isSet() && !color.image))
            return color;
        return pictures_.made("colour " + source_.diffuseMap.file + ", alpha " + source_.dissolveMap.file,
                              [&] { return withOpacity(color.image, opacity.image); });
    }

    void readEmission(Material& material) {
        material.emission = glm::max(source_.emission.value_or(glm::dvec3(0.0)), 0.0);
        material.emissionTexture = read(source_.emissionMap);
        if (material.emissionTexture.image && material.emission == glm::dvec3(0.0))
            material.emission = glm::dvec3(1.0);
    }

    void readMetallicRoughness(Material& material) {
        const Texture roughness = read(source_.roughnessMap);
        const Texture metallic = read(source_.metallicMap);
        if (roughness.image || metallic.image) {
            material.roughness = roughness.image ? 1.0 : material.roughness;
            material.metallic = metallic.image ? 1.0 : material.metallic;
            material.metallicRoughnessTexture = joined(roughness, metallic);
            return;
        }
        const Texture shininess = read(source_.shininessMap);
        if (!shininess.image || material.transmission > 0.0)
            return;
        const double exponent = source_.shininess.value_or(largestExponent);
        material.roughness = 1.0;
        material.metallicRoughnessTexture = pictures_.made(
            "roughness for exponent " + std::to_string(exponent) + " of " + source_.shininessMap.file,
            [&] { return roughnessFromShininess(shininess.image, exponent); });
    }

    Texture joined(const Texture& roughness, const Texture& metallic) {
        if (roughness.file == metallic.file)
            return roughness;
        return pictures_.made("roughness " + source_.roughnessMap.file + ", metallic " +
                                  source_.metallicMap.file,
                              [&] { return metallicRoughness(roughness.image, metallic.image); });
    }

    void readNormals(Material& material) {
        if (source_.normalMap.isSet()) {
            material.normalTexture = read(source_.normalMap);
            material.normalScale = source_.normalMap.bumpScale;
            return;
        }
        const MtlMap& map = source_.bumpMap;
        const Texture bump = read(map);
        if (!bump.image || looksLikeNormalMap(*bump.image)) {
            material.normalTexture = bump;
            material.normalScale = bump.image ? map.bumpScale : 1.0;
        } else {
            material.normalTexture =
                pictures_.made("normals of heights " + std::to_string(map.bumpScale) + " times " + map.file,
                               [&] { return normalsFromHeights(bump.image, map.bumpScale); });
        }
    }

    const MtlMaterial& source_;
    PictureReader& pictures_;
};

} // namespace

Material materialOf(const MtlMaterial& source, const std::string& name, PictureReader& pictures) {
    Material material;
    material.name = name;
    const PhongMaterial phong = phongOf(source);
    applyPhong(phong, material);
    if (isPhysical(source))
        applyPhysical(source, phong, material);
    MapReader(source, pictures).readInto(material);
    return material;
}

} // namespace prizma
