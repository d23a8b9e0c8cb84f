#pragma once

#include "core/project/json_text.h"

namespace prizma {

/// The version of the project format that this program writes.
inline constexpr int projectVersion = 1;

/// Brings a project of an older version up to the present one. Errors: no version, a newer one.
Result<void> migrateProject(JsonText& text, const std::string& file);

} // namespace prizma
