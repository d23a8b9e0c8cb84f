#pragma once

#include "core/scene/properties.h"

#include <QIcon>

namespace prizma {

/// The icon of a thing in the scene; lights have one for each type.
QIcon entityIcon(const Scene& scene, EntityRef entity);

/// A ball in the material's colour: enough to tell materials apart in a list.
QIcon materialIcon(const glm::dvec3& baseColor);

QIcon lightIcon(LightType type);
QIcon primitiveIcon(PrimitiveType type);

} // namespace prizma
