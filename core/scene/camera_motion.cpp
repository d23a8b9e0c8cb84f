#include "core/scene/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prizma {
namespace {

// As near to straight down as keeps the horizon defined by the up vector.
constexpr double poleElevation = (90.0 - 0.01) * std::numbers::pi / 180.0;

// Limits of the distance to the target: beyond them the sums with positions lose their meaning.
constexpr double nearestTarget = 1e-9;
constexpr double furthestTarget = 1e12;

// Squares of lengths between these neither overflow nor vanish.
constexpr double smallest = 1e-100;
constexpr double largest = 1e100;

bool isUsable(const glm::dvec3& v) {
    return std::abs(v.x) <= largest && std::abs(v.y) <= largest && std::abs(v.z) <= largest;
}

double halfHeightAtUnitDepth(const Camera& camera) {
    return std::tan(glm::radians(camera.fovY) * 0.5);
}

/// Where the camera stands on the sphere about its target.
struct Turntable {
    glm::dvec3 axis;    ///< Of the turning: the up vector.
    glm::dvec3 outward; ///< Horizontal, from the target to below or above the camera.
    double elevation;   ///< In radians above the horizontal plane.
    double distance;
};

Turntable turntableOf(const Camera& camera) {
    const glm::dvec3 axis = glm::normalize(camera.up);
    const glm::dvec3 arm = camera.position - camera.target;
    const double distance = glm::length(arm);
    const double height = std::clamp(glm::dot(arm, axis) / distance, -1.0, 1.0);
    glm::dvec3 outward = arm / distance - axis * height;
    if (glm::length(outward) < 1e-9) {
        // At a pole the picture's vertical says which way is outward.
        const glm::dvec3 vertical = frameOf(camera).up;
        outward = height > 0.0 ? -vertical : vertical;
        outward -= axis * glm::dot(outward, axis);
    }
    return {axis, glm::normalize(outward), std::asin(height), distance};
}

Camera place(Camera camera, const Turntable& table) {
    const glm::dvec3 arm = table.outward * std::cos(table.elevation) + table.axis * std::sin(table.elevation);
    camera.position = camera.target + arm * table.distance;
    return camera;
}

} // namespace

Camera mended(const Camera& camera) {
    const Camera standard;
    Camera result = camera;
    if (!isUsable(result.position))
        result.position = standard.position;
    if (!isUsable(result.up) || glm::length(result.up) < smallest)
        result.up = standard.up;
    if (!(result.fovY > 0.0 && result.fovY < 180.0))
        result.fovY = standard.fovY;
    if (!isUsable(result.target) || glm::length(result.target - result.position) < smallest) {
        // Far from the origin a unit step would vanish in rounding.
        const double step = std::max(1.0, std::abs(result.position.z) * 1e-6);
        result.target = result.position - glm::dvec3(0.0, 0.0, step);
    }
    return result;
}

Camera orbit(const Camera& camera, double azimuth, double elevation) {
    const Camera sound = mended(camera);
    if (!std::isfinite(azimuth) || !std::isfinite(elevation))
        return sound;
    Turntable table = turntableOf(sound);
    const glm::dvec3 sideways = glm::cross(table.axis, table.outward);
    table.outward = table.outward * std::cos(azimuth) + sideways * std::sin(azimuth);
    table.elevation = std::clamp(table.elevation + elevation, -poleElevation, poleElevation);
    return place(sound, table);
}

Camera pan(const Camera& camera, const glm::dvec2& drag, double depth) {
    Camera result = mended(camera);
    const CameraFrame frame = frameOf(result);
    const glm::dvec2 way = drag * (halfHeightAtUnitDepth(result) * depth);
    const glm::dvec3 step = -frame.right * way.x - frame.up * way.y;
    if (!isUsable(result.position + step) || !isUsable(result.target + step))
        return result;
    result.position += step;
    result.target += step;
    return result;
}

Camera zoom(const Camera& camera, double factor, const glm::dvec3& anchor) {
    Camera result = mended(camera);
    const double distance = glm::length(result.target - result.position) * factor;
    if (!isUsable(anchor) || !(distance >= nearestTarget && distance <= furthestTarget))
        return result;
    const glm::dvec3 step = (anchor - result.position) * (1.0 - factor);
    const glm::dvec3 arm = (result.target - result.position) * factor;
    const glm::dvec3 position = result.position + step;
    const glm::dvec3 target = position + arm;
    // Close to a far-away target the two can become one number.
    if (!isUsable(target) || glm::length(target - position) < 0.5 * distance)
        return result;
    result.position = position;
    result.target = target;
    return result;
}

Camera viewFrom(const Camera& camera, ViewDirection direction) {
    Camera result = mended(camera);
    const double distance = glm::length(result.target - result.position);
    result.up = {0.0, 1.0, 0.0};
    const glm::dvec3 front{0.0, 0.0, 1.0};
    const glm::dvec3 right{1.0, 0.0, 0.0};
    const double elevation = direction == ViewDirection::Top ? poleElevation : 0.0;
    const glm::dvec3 outward = direction == ViewDirection::Right ? right : front;
    return place(result, {result.up, outward, elevation, distance});
}

Camera lookAt(const Camera& camera, const glm::dvec3& target) {
    Camera result = mended(camera);
    if (isUsable(target) && glm::length(target - result.position) >= smallest)
        result.target = target;
    return result;
}

double depthOf(const Camera& camera, const glm::dvec3& point) {
    const Camera sound = mended(camera);
    return glm::dot(point - sound.position, frameOf(sound).forward);
}

glm::dvec3 pointInPicture(const Camera& camera, const glm::dvec2& place, double depth) {
    const Camera sound = mended(camera);
    const CameraFrame frame = frameOf(sound);
    const glm::dvec2 across = place * halfHeightAtUnitDepth(sound);
    return sound.position + (frame.forward + frame.right * across.x + frame.up * across.y) * depth;
}

std::optional<glm::dvec2> placeInPicture(const Camera& camera, const glm::dvec3& point) {
    const Camera sound = mended(camera);
    const CameraFrame frame = frameOf(sound);
    const glm::dvec3 arm = point - sound.position;
    const double depth = glm::dot(arm, frame.forward);
    if (!(depth > 0.0))
        return std::nullopt;
    return glm::dvec2(glm::dot(arm, frame.right), glm::dot(arm, frame.up)) /
           (depth * halfHeightAtUnitDepth(sound));
}

} // namespace prizma
