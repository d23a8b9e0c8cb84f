#pragma once

#include "core/scene/properties.h"

#include <QString>

#include <string>
#include <string_view>

namespace prizma {

/// Core speaks UTF-8, Qt UTF-16.
inline QString toQString(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}
inline std::string toStdString(const QString& text) {
    return text.toStdString();
}

/// A label, help text or unit from the property tables in the user's language.
QString translated(std::string_view text);

/// The name of a thing as the user reads it: its own, or "Camera", "Background", ... in the user's language.
QString nameOf(const Scene& scene, EntityRef entity);

/// "light", "3 lights", "2 things": what a set of entities is called in the middle of a sentence. One that
/// has a name of its own goes by it.
QString describeEntities(const Scene& scene, const std::vector<EntityRef>& entities);

} // namespace prizma
