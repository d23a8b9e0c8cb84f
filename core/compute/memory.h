#pragma once

#include "core/compute/context.h"

#include <cstddef>

namespace prizma {

/// A device buffer of `bytes`, read and written by kernels; `code` says what went wrong. On processors large
/// ones lie in large pages where the system has them: rays that go everywhere miss the cache of page
/// addresses with small ones.
ClMemory createMemory(Context& context, std::size_t bytes, cl_int& code);

} // namespace prizma
