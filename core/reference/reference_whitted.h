#pragma once

#include "core/reference/reference_surface.h"

#include <array>

namespace prizma::reference {

/// What a ray brings to the eye.
struct Radiance {
    glm::dvec3 value{0.0};
    /// Surface::texelsInFootprint, the largest on the way.
    double texelsInFootprint = 0.0;
    int rays = 0; ///< Traced beside shadow rays.
};

/// Whitted's ray tracer of 1980 in double precision, to compare the RayShader of that name with: direct light
/// with hard shadows, mirror reflection and refraction as a tree, Beer-Lambert absorption, an ambient term.
/// Shares no code with kernels/. Meshes are taken as they stand: a posed object has to be given with its
/// pose's vertices.
///
/// Boundaries are between a material and air.
class Whitted {
  public:
    static constexpr int mostLevels = 6;     ///< RenderSettings::maxDepth beyond it counts as it.
    static constexpr int raysALevel = 64;    ///< So many bounces' rays, and those straight through alpha.
    static constexpr double smallest = 1e-3; ///< Share of a ray's radiance below which it is not followed.

    explicit Whitted(const Scene& scene);

    /// `spread`: what the ray widens by in a unit of length (a camera ray: a pixel's size at distance 1).
    Radiance trace(const Ray& ray, double spread) const;

    const Tracer& tracer() const { return tracer_; }

  private:
    struct Branch;
    struct Progress;

    void follow(const Branch& branch, Progress& progress) const;
    void branchOut(const Surface& surface, const Branch& from, Progress& progress) const;
    glm::dvec3 directLight(const Surface& surface, const glm::dvec3& toEye) const;

    /// Share of light that comes from `distance` away along a unit direction.
    glm::dvec3 visibility(const Surface& from, const glm::dvec3& direction, double distance) const;

    Scene scene_;
    std::vector<Light> lights_; ///< In world space.
    Tracer tracer_;
    glm::dvec3 ambient_;
};

} // namespace prizma::reference
