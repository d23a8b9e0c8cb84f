#pragma once

#include <optional>
#include <string>

namespace prizma {

/// Text as UTF-8 without a byte order mark, from UTF-8, UTF-16 (with a mark) or, where it is neither,
/// Latin-1. Nothing if it is no text at all: it holds zero bytes.
std::optional<std::string> toUtf8(std::string text);

} // namespace prizma
