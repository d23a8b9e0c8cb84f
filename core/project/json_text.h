#pragma once

#include "core/diagnostic.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace prizma {

/// Keeps the order of keys, so that a saved file reads like the one that was opened.
using Json = nlohmann::ordered_json;

/// A parsed file, and on which line the value under each path ("/lights/0/color") is.
struct JsonText {
    Json root;
    std::map<std::string, int> lines;

    /// The line of the value at `path`, or of the nearest thing around it.
    int lineOf(std::string path) const;
};

/// Errors name `file` and the line.
Result<JsonText> parseJson(const std::string& text, const std::string& file);

/// JSON as people write it: one key a line, short lists of numbers on one line.
std::string formatJson(const Json& json);

} // namespace prizma
