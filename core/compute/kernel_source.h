#pragma once

#include <string>
#include <string_view>

namespace prizma {

/// The text of a file in kernels/ as built into the program ("ray_shader.cl"); empty if there is none of that
/// name.
std::string_view kernelFile(std::string_view name);

/// The file with every #include "..." replaced by that file's text, with #line directives so that the
/// compiler's messages name the right file and line.
std::string expandedKernelSource(std::string_view name);

/// The same for a text from elsewhere, as if it were a file of that name beside the kernels.
std::string expandedKernelSource(std::string_view name, std::string_view text);

} // namespace prizma
