#include "ui/scene_tree/entity_icon.h"

#include "core/scene/property_tables.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/color_editor.h"

#include <QPainter>
#include <QRadialGradient>

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

QIcon materialIcon(const glm::dvec3& baseColor) {
    constexpr int size = 32; // twice what is shown, for dense screens
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    const QColor color = displayColor(baseColor);
    QRadialGradient shading(QPointF(size * 0.38, size * 0.34), size * 0.55);
    shading.setColorAt(0.0, color.lighter(150));
    shading.setColorAt(0.4, color);
    shading.setColorAt(1.0, color.darker(220));
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 50), 1.0)); // black ones stay visible
    painter.setBrush(shading);
    painter.drawEllipse(QRectF(4.0, 4.0, size - 8.0, size - 8.0));
    painter.end();
    return pixmap;
}

QIcon entityIcon(const Scene& scene, EntityRef entity) {
    switch (entity.kind) {
    case EntityKind::Object:
        return icon(QStringLiteral("object"));
    case EntityKind::Light: {
        const Light* light = scene.findLight(entity.id);
        return lightIcon(light ? light->type : LightType::Point);
    }
    case EntityKind::Material: {
        const Material* material = scene.findMaterial(entity.id);
        return material ? materialIcon(material->baseColor) : icon(QStringLiteral("material"));
    }
    case EntityKind::Group:
        return icon(QStringLiteral("folder"));
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
