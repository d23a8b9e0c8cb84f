#pragma once

#include <expected>
#include <string>
#include <utility>
#include <vector>

namespace prizma {

enum class Severity { Information, Warning, Error };

/// One message about something a person gave us: what happened, where, and what was done about it.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string message; ///< A whole sentence, without the file's name.
    std::string file;    ///< The file it is about; empty if none.
    int line = 0;        ///< 1-based; 0 if unknown.

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or the one error that kept it from being made.
template <class T>
using Result = std::expected<T, Diagnostic>;

/// An error result about `file` (which may be empty).
inline std::unexpected<Diagnostic> failure(std::string message, std::string file = {}, int line = 0) {
    return std::unexpected(Diagnostic{Severity::Error, std::move(message), std::move(file), line});
}

/// "file:12: message", as shown on a terminal and in the log panel.
std::string describe(const Diagnostic& diagnostic);

} // namespace prizma
