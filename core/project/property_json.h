#pragma once

#include "core/project/json_text.h"
#include "core/scene/properties.h"

#include <string>

namespace prizma {

/// A property's value as the project file stores it; texture paths become relative to `folder`.
Json toJson(const PropertyValue& value, const std::string& folder);

/// The reverse. The error says what kind of value is wanted ("must be a number"). Texture paths become
/// absolute; pictures are not loaded.
Result<PropertyValue> fromJson(const Json& json, PropertyKind kind, const std::string& folder);

/// `path` relative to `folder` with forward slashes, or unchanged where there is no way from one to the
/// other.
std::string relativePath(const std::string& path, const std::string& folder);

} // namespace prizma
