#pragma once

#include "core/diagnostic.h"

#include <functional>
#include <string>
#include <string_view>

namespace prizma {

/// Has `write` fill a temporary file beside `file`, brings that to the disk and puts it in `file`'s place: a
/// crash or a full disk leaves the old file as it was. `write` gets the temporary file's path.
Result<void> replaceFile(const std::string& file,
                         const std::function<Result<void>(const std::string&)>& write);

/// The same with a content that is at hand.
Result<void> replaceFile(const std::string& file, std::string_view content);

/// A whole file in memory. Errors: it is missing, a directory, or cannot be read.
Result<std::string> readFile(const std::string& file);

} // namespace prizma
