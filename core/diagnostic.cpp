#include "core/diagnostic.h"

namespace prizma {

std::string describe(const Diagnostic& diagnostic) {
    if (diagnostic.file.empty())
        return diagnostic.message;
    const std::string line = diagnostic.line > 0 ? ":" + std::to_string(diagnostic.line) : std::string();
    return diagnostic.file + line + ": " + diagnostic.message;
}

} // namespace prizma
