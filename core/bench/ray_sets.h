#pragma once

#include "core/reference/reference_tracer.h"
#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <vector>

namespace prizma::bench {

/// The rays that the measurements trace, relative to `origin`.
struct RaySets {
    std::vector<DeviceRay> camera;  ///< A ray a pixel centre; sixteen in a row are a tile of 4 x 4 pixels.
    std::vector<DeviceRay> diffuse; ///< A bounce from each hit of these, cosine-distributed about the normal.
    std::vector<DeviceRay>
        shadow; ///< From each of these hits to a light under the ceiling; ends before the light.
};

/// Rays for `scene` from its own camera. Width and height are rounded up to whole tiles. Hits come from the
/// reference tracer, so that the rays do not depend on what is measured; equal arguments give equal rays.
RaySets makeRaySets(const Scene& scene, const reference::Tracer& tracer, const glm::dvec3& origin, int width,
                    int height);

/// `ray` in world space, as the reference tracer takes it.
reference::Ray referenceRay(const DeviceRay& ray, const glm::dvec3& origin);

} // namespace prizma::bench
