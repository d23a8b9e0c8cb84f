#pragma once

#include "core/compute/cl_handle.h"
#include "core/compute/context.h"
#include "core/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace prizma {

/// Where built programs are kept: $XDG_CACHE_HOME/prizma/programs (or ~/.cache/...); empty if there is no
/// such place.
std::filesystem::path programCacheFolder();

/// Builds kernels/`file` with compiler `options`, or takes the binary from the cache, which is keyed by the
/// expanded source, the options, the device and its driver. A cache entry that no longer loads is replaced.
/// Errors hold the compiler's log.
Result<ClProgram> buildProgram(Context& context, const std::string& file, const std::string& options);

/// The same for kernels from elsewhere: `content` is built as if it were kernels/`file`.
Result<ClProgram> buildProgram(Context& context, const std::string& file, std::string_view content,
                               const std::string& options);

} // namespace prizma
