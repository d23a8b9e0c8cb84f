#pragma once

#include <CLI/CLI.hpp>

namespace prizma {

/// Adds `bench animate` and `bench play`.
void addAnimationBenches(CLI::App& bench);

} // namespace prizma
