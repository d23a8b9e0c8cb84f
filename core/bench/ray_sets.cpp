#include "core/bench/ray_sets.h"

#include "core/animation/posed_bounds.h"
#include "core/scene/hierarchy.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

namespace prizma::bench {
namespace {

constexpr int tileSize = 4;
constexpr double offsetShare =
    1e-5; ///< Of the scene's diagonal: how far from the surface secondary rays start.
constexpr float noLimit = std::numeric_limits<float>::infinity();

DeviceRay deviceRay(const glm::dvec3& origin, const glm::dvec3& direction, float tMax) {
    const glm::vec3 o(origin);
    const glm::vec3 d(direction);
    return {{o.x, o.y, o.z}, 0.0f, {d.x, d.y, d.z}, tMax};
}

struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; ///< Unit, on the side that the ray came from.
};

/// World space corners of a triangle give its true normal.
glm::dvec3 normalOf(const Scene& scene, const reference::Hit& hit, const glm::dvec3& direction) {
    const Object& object = scene.objects[hit.object];
    const glm::dmat4 matrix = worldMatrix(scene, object);
    const glm::uvec3 t = object.mesh->triangles[hit.primitive];
    glm::dvec3 corners[3];
    for (int i = 0; i < 3; ++i)
        corners[i] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(object.mesh->positions[t[i]]), 1.0));
    const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    return glm::dot(normal, direction) > 0.0 ? -normal : normal;
}

/// Cosine-distributed about `normal` (Malley's method).
glm::dvec3 cosineDirection(const glm::dvec3& normal, double u, double v) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, normal));
    const double radius = std::sqrt(u);
    const double angle = 2.0 * std::numbers::pi * v;
    return tangent * (radius * std::cos(angle)) + glm::cross(normal, tangent) * (radius * std::sin(angle)) +
           normal * std::sqrt(1.0 - u);
}

std::vector<DeviceRay> cameraRays(const Scene& scene, const glm::dvec3& origin, int width, int height) {
    const CameraFrame frame = frameOf(scene.camera);
    const double halfHeight = std::tan(glm::radians(scene.camera.fovY) * 0.5);
    const double halfWidth = halfHeight * width / height;
    const glm::dvec3 position = scene.camera.position - origin;
    std::vector<DeviceRay> rays;
    rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int tileY = 0; tileY < height; tileY += tileSize)
        for (int tileX = 0; tileX < width; tileX += tileSize)
            for (int i = 0; i < tileSize * tileSize; ++i) {
                const double x = (tileX + i % tileSize + 0.5) / width * 2.0 - 1.0;
                const double y = 1.0 - (tileY + i / tileSize + 0.5) / height * 2.0;
                const glm::dvec3 direction =
                    frame.forward + frame.right * (x * halfWidth) + frame.up * (y * halfHeight);
                rays.push_back(deviceRay(position, glm::normalize(direction), noLimit));
            }
    return rays;
}

int wholeTiles(int pixels) {
    return (pixels + tileSize - 1) / tileSize * tileSize;
}

} // namespace

reference::Ray referenceRay(const DeviceRay& ray, const glm::dvec3& origin) {
    reference::Ray result;
    for (int axis = 0; axis < 3; ++axis) {
        result.origin[axis] = origin[axis] + static_cast<double>(ray.origin[axis]);
        result.direction[axis] = static_cast<double>(ray.direction[axis]);
    }
    result.tMin = static_cast<double>(ray.tMin);
    result.tMax = std::isinf(ray.tMax) ? result.tMax : static_cast<double>(ray.tMax);
    return result;
}

RaySets makeRaySets(const Scene& scene, const reference::Tracer& tracer, const glm::dvec3& origin, int width,
                    int height) {
    RaySets sets;
    sets.camera = cameraRays(scene, origin, wholeTiles(width), wholeTiles(height));
    std::vector<std::optional<SurfacePoint>> points(sets.camera.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const reference::Ray ray = referenceRay(sets.camera[i], origin);
        if (const auto hit = tracer.closestHit(ray))
            points[i] = {ray.origin + ray.direction * hit->t, normalOf(scene, *hit, ray.direction)};
    });

    const DBounds bounds = worldBounds(scene);
    const double offset = offsetShare * glm::length(bounds.extent());
    const glm::dvec3 light{bounds.centre().x, bounds.high.y - 0.03 * bounds.extent().y, bounds.centre().z};
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const auto& point : points) {
        if (!point)
            continue;
        const glm::dvec3 start = point->position + point->normal * offset;
        const double u = uniform(random);
        const double v = uniform(random);
        sets.diffuse.push_back(deviceRay(start - origin, cosineDirection(point->normal, u, v), noLimit));
        sets.shadow.push_back(deviceRay(start - origin, light - start, 0.999f));
    }
    return sets;
}

} // namespace prizma::bench
