#include "core/reference/reference_whitted.h"

#include "core/reference/reference_bsdf.h"
#include "core/reference/reference_light.h"
#include "core/scene/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace prizma::reference {
namespace {

/// A hit's position is good to a few 1e-16 of the coordinates it was computed from. What a ray starts beyond
/// is a thousand times that.
constexpr double offsetShare = 1e-12;
constexpr int mostHoles = 256;
constexpr double darkestShare = 1e-6;

double largest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Moves a start away from the surface, to the side that `direction` goes to.
glm::dvec3 leave(const Surface& s, const glm::dvec3& direction) {
    const double size =
        std::max({1.0, std::abs(s.position.x), std::abs(s.position.y), std::abs(s.position.z)});
    const double side = glm::dot(direction, s.geometricNormal) < 0.0 ? -1.0 : 1.0;
    return s.position + s.geometricNormal * (side * size * offsetShare);
}

/// `direction`, or, where interpolated normals turn it to the wrong side of the surface, just on the right
/// one.
glm::dvec3 onSide(const glm::dvec3& direction, const glm::dvec3& side) {
    const double height = glm::dot(direction, side);
    return height > 0.0 ? direction : glm::normalize(direction + side * (1e-3 - height));
}

bool isGlass(const Surface& s) {
    return s.coverage > 0.0 && clearShare(s) > 0.0;
}

/// Along a straight way through glass: what absorbs before and after each surface.
class Medium {
  public:
    /// What is left after `distance` to the surface `s`. Ways that end inside glass ran through it.
    glm::dvec3 reach(const Surface& s, double distance) {
        if (isGlass(s) && !s.entering)
            absorption_ = s.absorption;
        return glm::exp(-absorption_ * distance);
    }
    glm::dvec3 pass(double distance) const { return glm::exp(-absorption_ * distance); }

    void cross(const Surface& s) {
        if (isGlass(s))
            absorption_ = s.entering ? s.absorption : glm::dvec3(0.0);
    }

  private:
    glm::dvec3 absorption_{0.0};
};

} // namespace

struct Whitted::Branch {
    Ray ray; ///< Of unit direction.
    glm::dvec3 weight{1.0};
    Medium medium;
    int level = 0;
    double width = 0.0; ///< Of the ray's cone where it starts.
};

struct Whitted::Progress {
    Radiance sum;
    double spread = 0.0;
    std::array<int, mostLevels + 1> raysOfLevel{1};
};

Whitted::Whitted(const Scene& scene)
    : scene_(scene),
      lights_(lightsInWorld(scene)),
      tracer_(scene),
      ambient_(meanBackground(scene.background)) {}

Radiance Whitted::trace(const Ray& ray, double spread) const {
    Progress progress;
    progress.spread = spread;
    Branch branch;
    branch.ray = ray;
    branch.ray.direction = glm::normalize(ray.direction);
    follow(branch, progress);
    return progress.sum;
}

void Whitted::follow(const Branch& branch, Progress& progress) const {
    ++progress.sum.rays;
    const auto hit = tracer_.closestHit(branch.ray);
    if (const auto light = nearestLight(lights_, branch.ray, hit ? hit->t : 1e300, branch.level == 0)) {
        progress.sum.value += branch.weight * branch.medium.pass(light->t) * light->radiance;
        return;
    }
    if (!hit) {
        progress.sum.value += branch.weight * backgroundRadiance(scene_.background, branch.ray.direction);
        return;
    }
    Branch here = branch;
    here.width = branch.width + progress.spread * hit->t;
    const Surface s = surfaceAt(scene_, branch.ray, *hit, here.width);
    progress.sum.texelsInFootprint = std::max(progress.sum.texelsInFootprint, s.texelsInFootprint);
    here.weight *= here.medium.reach(s, hit->t);
    const glm::dvec3 toEye = -branch.ray.direction;
    progress.sum.value +=
        here.weight * s.coverage * (s.emission + ambient_ * ambientAlbedo(s, toEye) + directLight(s, toEye));
    branchOut(s, here, progress);
}

void Whitted::branchOut(const Surface& s, const Branch& from, Progress& progress) const {
    std::vector<Branch> made;
    const auto add = [&](const glm::dvec3& direction, const glm::dvec3& weight, int level, bool through,
                         bool refracted) {
        if (!(largest(weight) > smallest) || progress.raysOfLevel[level] >= raysALevel)
            return;
        ++progress.raysOfLevel[level];
        Branch next = from;
        next.ray = {};
        next.ray.direction = onSide(direction, through ? -s.geometricNormal : s.geometricNormal);
        next.ray.origin = leave(s, next.ray.direction);
        next.weight = weight;
        next.level = level;
        if (refracted)
            next.medium.cross(s);
        made.push_back(next);
    };
    const glm::dvec3& direction = from.ray.direction;
    if (s.coverage < 1.0)
        add(direction, from.weight * (1.0 - s.coverage), from.level, true, false);
    if (from.level < std::min(scene_.render.maxDepth, mostLevels) && s.coverage > 0.0) {
        const glm::dvec3 weight = from.weight * s.coverage;
        const double cosine = std::clamp(-glm::dot(direction, s.normal), 0.0, 1.0);
        const double index = s.entering ? s.ior : 1.0 / s.ior;
        const double back = fresnel(cosine, index);
        if (clearShare(s) > 0.0 && back < 1.0)
            add(glm::refract(direction, s.normal, 1.0 / index),
                weight * clearShare(s) * (1.0 - back) * glm::sqrt(s.baseColor), from.level + 1, true, true);
        const glm::dvec3 layer = isMirror(s) ? layerReflectance(s, cosine) : glm::dvec3(0.0);
        add(glm::reflect(direction, s.normal), weight * glm::max(layer, glm::dvec3(clearShare(s) * back)),
            from.level + 1, false, false);
    }
    // The last one first: what the limits leave out depends on the order.
    for (auto branch = made.rbegin(); branch != made.rend(); ++branch)
        follow(*branch, progress);
}

glm::dvec3 Whitted::directLight(const Surface& s, const glm::dvec3& toEye) const {
    glm::dvec3 sum(0.0);
    if (s.coverage == 0.0 || (isMirror(s) && diffuseShare(s) == 0.0))
        return sum;
    for (const Light& light : lights_) {
        const auto arriving = lightAt(light, s.position);
        if (!arriving || glm::dot(arriving->direction, s.geometricNormal) <= 0.0)
            continue;
        const glm::dvec3 unshadowed = arriving->irradiance * reflected(s, toEye, arriving->direction);
        if (largest(unshadowed) > 0.0)
            sum += unshadowed * visibility(s, arriving->direction, arriving->distance);
    }
    return sum;
}

glm::dvec3 Whitted::visibility(const Surface& from, const glm::dvec3& direction, double distance) const {
    Ray ray;
    ray.origin = leave(from, direction);
    ray.direction = direction;
    ray.tMax = distance;
    glm::dvec3 share(1.0);
    Medium medium;
    for (int i = 0; i < mostHoles; ++i) {
        const auto hit = tracer_.closestHit(ray);
        if (!hit)
            return share;
        const Surface s = surfaceAt(scene_, ray, *hit, 0.0);
        glm::dvec3 passes(1.0 - s.coverage);
        if (scene_.render.transparentShadows) {
            share *= medium.reach(s, hit->t - ray.tMin);
            medium.cross(s);
            // As steeply as light comes into a slab it leaves it.
            const double cosine = std::clamp(-glm::dot(direction, s.normal), 0.0, 1.0);
            passes += s.coverage * clearShare(s) * (1.0 - fresnel(cosine, s.ior)) * glm::sqrt(s.baseColor);
        }
        share *= passes;
        if (!(largest(share) > darkestShare))
            break;
        ray.tMin = hit->t * (1.0 + 1e-14) + 1e-300;
    }
    return glm::dvec3(0.0);
}

} // namespace prizma::reference
