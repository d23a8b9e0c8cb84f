#pragma once

#include "core/render/statistics.h"

#include <nlohmann/json.hpp>

#include <string>

namespace prizma {

nlohmann::ordered_json toJson(const PassTimes& times);

/// Where the time went, in a line of text.
std::string describe(const PassTimes& times);

} // namespace prizma
