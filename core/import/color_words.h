#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string_view>

namespace prizma {

/// The linear colour that a material's name speaks of ("mat_red", "DarkBlue2", "Grey"), for formats in which
/// the name is all there is.
std::optional<glm::dvec3> colorOfName(std::string_view name);

} // namespace prizma
