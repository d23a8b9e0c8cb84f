#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <string>

namespace prizma {

/// A project, or a bare model with lights and a camera that present it in a picture of this aspect (width /
/// height). Warnings go to standard error.
Result<Scene> loadScene(const std::string& file, const std::string& upAxis, double aspect);

/// Says an error on standard error in one line and ends the program with exit code 1.
[[noreturn]] void fail(const Diagnostic& error);

} // namespace prizma
