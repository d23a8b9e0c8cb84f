#pragma once

#include "core/scene/properties.h"

#include <QIcon>

namespace prizma {

/// The icon of a thing in the scene; lights have one for each type.
QIcon entityIcon(const Scene& scene, EntityRef entity);

QIcon lightIcon(LightType type);
QIcon primitiveIcon(PrimitiveType type);

} // namespace prizma
