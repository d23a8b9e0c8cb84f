#include "ui/document/strings.h"

#include <QCoreApplication>

#include <algorithm>

namespace prizma {
namespace {

QString counted(EntityKind kind, int count) {
    switch (kind) {
    case EntityKind::Object:
        return QCoreApplication::translate("prizma", "%n object(s)", nullptr, count);
    case EntityKind::Light:
        return QCoreApplication::translate("prizma", "%n light(s)", nullptr, count);
    case EntityKind::Material:
        return QCoreApplication::translate("prizma", "%n material(s)", nullptr, count);
    case EntityKind::Group:
        return QCoreApplication::translate("prizma", "%n group(s)", nullptr, count);
    default:
        return QCoreApplication::translate("prizma", "%n thing(s)", nullptr, count);
    }
}

} // namespace

QString translated(std::string_view text) {
    return QCoreApplication::translate("properties", std::string(text).c_str());
}

QString nameOf(const Scene& scene, EntityRef entity) {
    const std::string name = displayName(scene, entity);
    const bool named = entity.kind == EntityKind::Object || entity.kind == EntityKind::Light ||
                       entity.kind == EntityKind::Material || entity.kind == EntityKind::Group;
    return named ? toQString(name) : translated(name);
}

QString describeEntities(const Scene& scene, const std::vector<EntityRef>& entities) {
    if (entities.size() == 1)
        return nameOf(scene, entities.front());
    const bool alike = std::all_of(entities.begin(), entities.end(),
                                   [&](const EntityRef& e) { return e.kind == entities.front().kind; });
    // The English source text itself has no plural forms; translations do.
    QString text = counted(entities.empty() || !alike ? EntityKind::Camera : entities.front().kind,
                           static_cast<int>(entities.size()));
    return text.replace(QStringLiteral("(s)"), entities.size() == 1 ? QString() : QStringLiteral("s"));
}

} // namespace prizma
