#pragma once

#include <CLI/CLI.hpp>

namespace prizma {

/// Each adds one subcommand. What it does runs in the subcommand's callback, which throws CLI::RuntimeError
/// with the exit code after it has said on standard error, in one line, what is wrong.
void addDevicesCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addPoseCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);

} // namespace prizma
