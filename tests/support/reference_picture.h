#pragma once

#include "core/reference/reference_whitted.h"
#include "tests/support/pixel_ray.h"
#include "tests/support/test_scenes.h"

#include <QString>

#include <algorithm>
#include <cmath>

namespace prizma::test {

/// Compares a square picture of Whitted's shader with the reference, pixel by pixel.
///
/// A pixel agrees if each channel is within `bound` of the reference's, as a share of that value plus the
/// picture's mean. Where it does not, single precision may have decided something the other way: hit or miss,
/// lit or not, refracted or not. Then the reference, looked at through places around the pixel's centre, has
/// to give values on both sides: such a pixel counts as one on an edge. A ray that meets the very edge (a
/// thousandth of a pixel) can find a third thing, as where a ray starts, just beside the surface, may then be
/// beyond the edge: such pixels are counted apart. Any other is a fault.
class ReferencePicture {
  public:
    /// `reach`: how far around the centre, in pixels.
    ReferencePicture(const Scene& scene, int size, double bound, double reach)
        : camera_(scene.camera), whitted_(scene), size_(size), bound_(bound), reach_(reach) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                pixels_.push_back(at(x + 0.5, y + 0.5));
        for (const reference::Radiance& pixel : pixels_)
            mean_ += (pixel.value.x + pixel.value.y + pixel.value.z) / (3.0 * size * size);
    }

    struct Outcome {
        int agree = 0, onEdge = 0, onVeryEdge = 0, faults = 0, minified = 0;
        double largestError = 0.0; ///< Of those that agree, as the bound is meant.
        double largestFault = 0.0;
        QString first;
    };

    /// Pixels whose textures a renderer shows from mip levels are left out and counted.
    Outcome compare(const OfflinePicture& picture) const {
        Outcome outcome;
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x)
                compare(pixelOf(picture, x, y), x, y, outcome);
        return outcome;
    }

    /// Of all pixels, beside shadow rays.
    int mostRays() const {
        int rays = 0;
        for (const reference::Radiance& pixel : pixels_)
            rays = std::max(rays, pixel.rays);
        return rays;
    }

  private:
    reference::Radiance at(double x, double y) const {
        const reference::Ray ray = pixelRay(camera_, x, y, size_);
        const double cosine = glm::dot(ray.direction, frameOf(camera_).forward);
        const double pixel = 2.0 * std::tan(glm::radians(camera_.fovY) / 2.0) / size_;
        return whitted_.trace(ray, pixel * std::pow(cosine, 1.5));
    }

    /// Largest of the channels' distances from the span [low, high], as the bound is meant.
    double errorOf(const glm::dvec3& value, const glm::dvec3& low, const glm::dvec3& high) const {
        double worst = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double off = std::max({low[c] - value[c], value[c] - high[c], 0.0});
            worst = std::max(worst, off / (std::abs(high[c]) + mean_));
        }
        return std::isfinite(value.x + value.y + value.z) ? worst : 1e300;
    }

    void compare(const glm::dvec3& value, int x, int y, Outcome& outcome) const {
        const reference::Radiance& exact = pixels_[static_cast<std::size_t>(y) * size_ + x];
        if (exact.texelsInFootprint > 1.0) {
            ++outcome.minified;
            return;
        }
        const double error = errorOf(value, exact.value, exact.value);
        if (error <= bound_) {
            ++outcome.agree;
            outcome.largestError = std::max(outcome.largestError, error);
            return;
        }
        glm::dvec3 low = exact.value;
        glm::dvec3 high = exact.value;
        bool isVeryEdge = false;
        for (const double radius : {0.03, 0.2, 1.0}) {
            for (int corner = 0; corner < 4; ++corner) {
                const glm::dvec3 there = at(x + 0.5 + ((corner & 1) != 0 ? reach_ : -reach_) * radius,
                                            y + 0.5 + ((corner & 2) != 0 ? reach_ : -reach_) * radius)
                                             .value;
                low = glm::min(low, there);
                high = glm::max(high, there);
            }
            if (radius == 0.03)
                isVeryEdge = errorOf(low, high, high) > bound_;
        }
        const double outside = errorOf(value, low, high);
        if (outside <= bound_) {
            ++outcome.onEdge;
            return;
        }
        if (isVeryEdge) {
            ++outcome.onVeryEdge;
            return;
        }
        ++outcome.faults;
        outcome.largestFault = std::max(outcome.largestFault, outside);
        if (outcome.first.isEmpty())
            outcome.first =
                QString("pixel (%1, %2) is %3 %4 %5 instead of %6 %7 %8, off by %9 beside its surroundings")
                    .arg(x)
                    .arg(y)
                    .arg(value.x)
                    .arg(value.y)
                    .arg(value.z)
                    .arg(exact.value.x)
                    .arg(exact.value.y)
                    .arg(exact.value.z)
                    .arg(outside);
    }

    Camera camera_;
    reference::Whitted whitted_;
    int size_;
    double bound_, reach_;
    std::vector<reference::Radiance> pixels_;
    double mean_ = 0.0;
};

} // namespace prizma::test
