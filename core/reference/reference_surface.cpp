#include "core/reference/reference_surface.h"

#include "core/reference/reference_texture.h"
#include "core/scene/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prizma::reference {
namespace {

const Material& materialOf(const Scene& scene, const Hit& hit) {
    static const Material neutral{};
    const Object& object = scene.objects[hit.object];
    const std::uint32_t slot = object.mesh->triangleSlots[hit.primitive];
    const Material* found =
        slot < object.materials.size() ? scene.findMaterial(object.materials[slot]) : nullptr;
    return found != nullptr ? *found : neutral;
}

/// The triangle that was hit, in world space.
struct Corners {
    std::array<glm::dvec3, 3> position;
    std::array<glm::dvec3, 3> normal;
    std::array<glm::dvec2, 3> texCoord;
    std::array<double, 3> weight;
    glm::dvec3 outward; ///< Unit.

    template <class T>
    T mean(const std::array<T, 3>& values) const {
        return values[0] * weight[0] + values[1] * weight[1] + values[2] * weight[2];
    }
};

Corners cornersOf(const Scene& scene, const Hit& hit) {
    const Object& object = scene.objects[hit.object];
    const Mesh& mesh = *object.mesh;
    const glm::dmat4 toWorld = worldMatrix(scene, object);
    const glm::dmat3 turn(toWorld);
    const glm::dmat3 normalTurn = glm::transpose(glm::inverse(turn));
    Corners c;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.triangles[hit.primitive][i];
        const auto k = static_cast<std::size_t>(i);
        c.position[k] = glm::dvec3(toWorld * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
        c.normal[k] = normalTurn * glm::dvec3(mesh.normals[vertex]);
        c.texCoord[k] = mesh.texCoords.empty() ? glm::dvec2(0.0) : glm::dvec2(mesh.texCoords[vertex]);
    }
    c.weight = {1.0 - hit.u - hit.v, hit.u, hit.v};
    // A mirrored object's corners run the other way round.
    const double handedness = glm::determinant(turn) < 0.0 ? -1.0 : 1.0;
    c.outward =
        glm::normalize(glm::cross(c.position[1] - c.position[0], c.position[2] - c.position[0]) * handedness);
    return c;
}

/// Directions in which the texture's coordinates grow, in the plane of `normal`; nothing if they do not span
/// the triangle.
bool tangents(const Corners& c, const glm::dvec3& normal, glm::dvec3& tangent, glm::dvec3& bitangent) {
    const glm::dvec3 e1 = c.position[1] - c.position[0];
    const glm::dvec3 e2 = c.position[2] - c.position[0];
    const glm::dmat2 t(c.texCoord[1] - c.texCoord[0], c.texCoord[2] - c.texCoord[0]);
    if (glm::determinant(t) == 0.0)
        return false;
    const glm::dmat2 inverse = glm::inverse(t); // e = P t, so P = e t⁻¹
    const glm::dvec3 alongU = e1 * inverse[0][0] + e2 * inverse[0][1];
    const glm::dvec3 alongV = e1 * inverse[1][0] + e2 * inverse[1][1];
    tangent = glm::normalize(alongU - normal * glm::dot(alongU, normal));
    const glm::dvec3 across = alongV - normal * glm::dot(alongV, normal);
    bitangent = glm::normalize(across - tangent * glm::dot(across, tangent));
    return true;
}

glm::dvec3 bentNormal(const Material& material, const Corners& c, const glm::dvec3& normal) {
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
    if (!material.normalTexture.image || !tangents(c, normal, tangent, bitangent))
        return normal;
    const glm::dvec3 bend =
        glm::dvec3(sampleImage(*material.normalTexture.image, c.mean(c.texCoord), Reading::Data)) * 2.0 - 1.0;
    return glm::normalize(tangent * (bend.x * material.normalScale) +
                          bitangent * (bend.y * material.normalScale) + normal * std::max(bend.z, 0.0));
}

void applyMaterial(const Material& m, const glm::dvec2& texCoord, Surface& s) {
    const auto look = [&](const Texture& texture, Reading reading) {
        return texture.image ? sampleImage(*texture.image, texCoord, reading) : glm::dvec4(1.0);
    };
    const Reading reading = m.alphaMode == AlphaMode::Opaque ? Reading::Color : Reading::CoveredColor;
    const glm::dvec4 base = look(m.baseColorTexture, reading);
    const glm::dvec4 metallicRoughness = look(m.metallicRoughnessTexture, Reading::Data);
    s.baseColor = m.baseColor * glm::dvec3(base);
    s.emission = m.emission * m.emissionStrength * glm::dvec3(look(m.emissionTexture, Reading::Color));
    s.specular = m.specular * look(m.specularTexture, Reading::Data).w;
    s.specularColor = m.specularColor;
    s.roughness = m.roughness * metallicRoughness.y;
    s.metallic = m.metallic * metallicRoughness.z;
    s.transmission = m.transmission * look(m.transmissionTexture, Reading::Data).x;
    s.ior = m.ior;
    if (m.attenuationDistance > 0.0)
        s.absorption = -glm::log(glm::max(m.attenuationColor, 1e-6)) / m.attenuationDistance;
    const double alpha = m.alpha * base.w;
    if (m.alphaMode == AlphaMode::Blend)
        s.coverage = std::clamp(alpha, 0.0, 1.0);
    else if (m.alphaMode == AlphaMode::Mask)
        s.coverage = alpha >= m.alphaCutoff ? 1.0 : 0.0;
    if (!m.doubleSided && !s.entering && m.transmission == 0.0)
        s.coverage = 0.0;
}

/// The largest number of texels across the spot of a ray that is `width` wide and meets the surface at
/// `cosine`.
double texelsUnder(const Material& material, const Corners& c, double width, double cosine) {
    const glm::dvec2 t1 = c.texCoord[1] - c.texCoord[0];
    const glm::dvec2 t2 = c.texCoord[2] - c.texCoord[0];
    const double inTexture = std::abs(t1.x * t2.y - t1.y * t2.x);
    const double inWorld =
        glm::length(glm::cross(c.position[1] - c.position[0], c.position[2] - c.position[0]));
    double most = 0.0;
    for (const Texture& texture : texturesOf(material))
        if (texture.image)
            most = std::max(most, std::sqrt(double(texture.image->width) * texture.image->height));
    return most * width / std::max(cosine, 1e-4) * std::sqrt(inTexture / inWorld);
}

} // namespace

Surface surfaceAt(const Scene& scene, const Ray& ray, const Hit& hit, double coneWidth) {
    const Corners c = cornersOf(scene, hit);
    const Material& material = materialOf(scene, hit);
    const double slant = glm::dot(glm::normalize(ray.direction), c.outward);
    Surface s;
    s.position = c.mean(c.position);
    s.entering = slant < 0.0;
    applyMaterial(material, c.mean(c.texCoord), s);
    s.texelsInFootprint = texelsUnder(material, c, coneWidth, std::abs(slant));
    s.geometricNormal = s.entering ? c.outward : -c.outward;
    s.normal = bentNormal(material, c, glm::normalize(c.mean(c.normal)));
    if (glm::dot(s.normal, s.geometricNormal) < 0.0)
        s.normal = -s.normal;
    if (glm::dot(s.normal, ray.direction) >= 0.0) // turned away from the viewer: not to be believed
        s.normal = s.geometricNormal;
    return s;
}

} // namespace prizma::reference
