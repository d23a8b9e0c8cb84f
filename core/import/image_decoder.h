#pragma once

#include "core/diagnostic.h"
#include "core/scene/image.h"

#include <string>
#include <string_view>

namespace prizma {

/// A picture from a file's content, wherever that came from (a file, or the inside of a model file). `file`
/// names it in errors.
Result<ImagePtr> decodeImage(std::string_view content, const std::string& file);

} // namespace prizma
