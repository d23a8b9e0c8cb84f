#include "ui/scene_tree/entity_icon.h"

#include "core/scene/property_tables.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"

namespace prizma {
namespace {

template <class Enum>
QString keyOf(Enum value) {
    return toQString(choicesOf<Enum>()[static_cast<std::size_t>(value)].key);
}

} // namespace

QIcon lightIcon(LightType type) {
    return icon(QStringLiteral("light-") + keyOf(type));
}

QIcon primitiveIcon(PrimitiveType type) {
    return icon(QStringLiteral("primitive-") + keyOf(type));
}

QIcon entityIcon(const Scene& scene, EntityRef entity) {
    switch (entity.kind) {
    case EntityKind::Object:
        return icon(QStringLiteral("object"));
    case EntityKind::Light: {
        const Light* light = scene.findLight(entity.id);
        return lightIcon(light ? light->type : LightType::Point);
    }
    case EntityKind::Material:
        return icon(QStringLiteral("material"));
    case EntityKind::Camera:
        return icon(QStringLiteral("camera"));
    case EntityKind::Background:
        return icon(QStringLiteral("background"));
    case EntityKind::Timeline:
        return icon(QStringLiteral("timeline"));
    case EntityKind::Render:
        break;
    }
    return icon(QStringLiteral("render"));
}

} // namespace prizma
