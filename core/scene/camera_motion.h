#pragma once

#include "core/scene/camera.h"

#include <glm/glm.hpp>

#include <optional>

namespace prizma {

/// How people move a camera: turntable style, so that the horizon stays level. All functions are pure, take
/// any camera (one that is degenerate or not finite is mended first) and give one that is finite.
///
/// A place in the picture is measured from its middle in half picture heights, x to the right and y up: the
/// top edge is at y = 1, the right edge at x = width / height.

enum class ViewDirection { Front, Right, Top };

/// Turns about the target: `azimuth` counter-clockwise about the up vector seen from its tip, `elevation`
/// upwards, in radians. Stops just short of the poles. The distance to the target stays.
Camera orbit(const Camera& camera, double azimuth, double elevation);

/// Moves sideways so that what lies `depth` in front of the camera follows the pointer's way `drag` across
/// the picture. The view direction stays.
Camera pan(const Camera& camera, const glm::dvec2& drag, double depth);

/// Moves towards `anchor` (`factor` below 1) or away from it (above 1): all distances to the anchor are
/// multiplied by `factor`, so that it keeps its place in the picture. The view direction stays. Unchanged
/// where the distance to the target would leave what numbers can hold.
Camera zoom(const Camera& camera, double factor, const glm::dvec3& anchor);

/// Looks at the target from a side, from the same distance, with Y up.
Camera viewFrom(const Camera& camera, ViewDirection direction);

/// The same camera looking at `target` from where it is; unchanged if it is there already.
Camera lookAt(const Camera& camera, const glm::dvec3& target);

/// The camera itself if it is sound. Else whatever is not finite, a target at the position, a missing up
/// vector or an impossible field of view is replaced.
Camera mended(const Camera& camera);

/// How far in front of the camera `point` lies, along the view direction.
double depthOf(const Camera& camera, const glm::dvec3& point);

/// The point at `place` in the picture, `depth` in front of the camera.
glm::dvec3 pointInPicture(const Camera& camera, const glm::dvec2& place, double depth);

/// Where `point` appears in the picture; nothing if it is not in front of the camera.
std::optional<glm::dvec2> placeInPicture(const Camera& camera, const glm::dvec3& point);

} // namespace prizma
