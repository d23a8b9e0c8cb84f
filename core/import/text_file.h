#pragma once

#include "core/diagnostic.h"

#include <cstddef>
#include <string>

namespace prizma {

inline constexpr std::size_t mostModelBytes = std::size_t(1) << 30;  ///< SMD and VTA.
inline constexpr std::size_t mostScriptBytes = std::size_t(1) << 22; ///< QC and what it includes.

/// A file of text as UTF-8. Errors: missing, no plain file, empty, larger than `mostBytes`, no text.
Result<std::string> readTextFile(const std::string& file, std::size_t mostBytes);

} // namespace prizma
