#pragma once

#include "core/diagnostic.h"

#include <CL/cl.h>

#include <string>

namespace prizma {

/// What an OpenCL error code means, in words a person can act on.
std::string clErrorText(cl_int code);

/// "Could not `action`: ..." as an error, or success. `action` reads like "upload the geometry".
Result<void> checkCl(cl_int code, const std::string& action);

} // namespace prizma
