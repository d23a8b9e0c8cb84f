#pragma once

#include <glm/glm.hpp>

namespace prizma {

/// A pinhole or thin lens camera in world space.
struct Camera {
    glm::dvec3 position{0.0, 1.5, 6.0};
    glm::dvec3 target{0.0, 1.0, 0.0}; ///< What it looks at, and what orbiting turns about.
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fovY = 45.0; ///< Vertical field of view in degrees.
    bool orthographic =
        false;               ///< Parallel rays; the picture is as high as the perspective one is at `target`.
    double lensRadius = 0.0; ///< In scene units; 0: a pinhole, everything is sharp.
    double focusDistance = 0.0; ///< Along the view direction, in scene units; 0: as far as the target.

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// An orthonormal, right-handed camera frame: right and up span the picture, forward looks into it.
/// Sound for every camera: degenerate input (position equals target, up along the view) gets a stand-in.
struct CameraFrame {
    glm::dvec3 right, up, forward;
};

CameraFrame frameOf(const Camera& camera);

/// Where the camera is sharp, along its view direction; never 0.
double focusDistanceOf(const Camera& camera);

} // namespace prizma
