#pragma once

#include "core/scene/id.h"
#include "core/scene/transform.h"

#include <glm/glm.hpp>

#include <string>

namespace prizma {

enum class LightType { Point, Spot, Directional, Rectangle, Sphere };

/// A light of any type; which members count depends on `type` (see the comments). Physical, linear units.
struct Light {
    Id id = noId;
    std::string name;
    LightType type = LightType::Point;
    Id parent = noId; ///< The group whose space its place is given in; without one, world space.
    bool enabled = true;
    bool solo = false;   ///< While any light has this, only those that have it shine.
    bool visible = true; ///< Rectangle, sphere: the camera sees it.

    glm::dvec3 color{1.0};
    double intensity = 100.0; ///< Point, spot: W/sr.
    double irradiance = 3.0;  ///< Directional: W/m², on a surface that faces it.
    double radiance = 10.0;   ///< Rectangle, sphere: W/(m²·sr).

    glm::dvec3 position{0.0, 4.0, 0.0}; ///< All but directional; world space.
    glm::dvec3 direction{0.0, -1.0,
                         0.0}; ///< Spot, directional: where the light travels; normalised when used.
    double innerAngle = 25.0;  ///< Spot: degrees from the axis with full intensity,
    double outerAngle = 35.0;  ///< and from where on there is none.
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< Rectangle; it emits along its local -Y.
    glm::dvec2 size{1.0};                    ///< Rectangle: lengths along its local X and Z.
    double radius = 0.25;                    ///< Sphere.

    friend bool operator==(const Light&, const Light&) = default;
};

} // namespace prizma
