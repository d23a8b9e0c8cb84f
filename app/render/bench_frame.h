#pragma once

#include <CLI/CLI.hpp>

namespace prizma {

/// Adds `bench frame`.
void addFrameBench(CLI::App& bench);

} // namespace prizma
