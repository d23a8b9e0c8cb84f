#pragma once

#include "core/reference/reference_tracer.h"
#include "core/scene/camera.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace prizma::test {

/// The ray through a place of a square picture of `size` pixels a side, its first pixel's corner being (0,
/// 0).
inline reference::Ray pixelRay(const Camera& camera, double x, double y, int size) {
    const CameraFrame frame = frameOf(camera);
    const double half = std::tan(glm::radians(camera.fovY) / 2);
    reference::Ray ray;
    ray.origin = camera.position;
    ray.direction = glm::normalize(frame.forward + frame.right * ((x / size * 2 - 1) * half) +
                                   frame.up * ((1 - y / size * 2) * half));
    return ray;
}

} // namespace prizma::test
