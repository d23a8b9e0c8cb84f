#pragma once

#include "core/import/smd_file.h"
#include "core/progress.h"

#include <string>
#include <string_view>

namespace prizma {

/// Reads the text of an SMD file (Half-Life 1 and Source): a reference model or an animation. `file` names it
/// in messages. Takes time and memory in proportion to the text, whatever is in it. Errors, with the line:
/// not an SMD, a block that does not end, fields that are missing or no finite numbers, bones that are not
/// declared, cancelled.
Result<SmdFile> readSmd(std::string_view text, const std::string& file, const ProgressPart& progress);

/// Whether `text` is an animation: it has no block of triangles. Quick, for telling dropped files apart.
bool isSmdAnimation(std::string_view text);

} // namespace prizma
