#pragma once

#include <glm/glm.hpp>

namespace prizma {

/// A pinhole camera in world space.
struct Camera {
    glm::dvec3 position{0.0, 1.5, 6.0};
    glm::dvec3 target{0.0, 1.0, 0.0}; ///< What it looks at, and what orbiting turns about.
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fovY = 45.0; ///< Vertical field of view in degrees.

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// An orthonormal, right-handed camera frame: right and up span the picture, forward looks into it.
/// Sound for every camera: degenerate input (position equals target, up along the view) gets a stand-in.
struct CameraFrame {
    glm::dvec3 right, up, forward;
};

CameraFrame frameOf(const Camera& camera);

} // namespace prizma
