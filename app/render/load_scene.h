#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace prizma {

/// What the files of a command line hold.
struct LoadedFiles {
    Scene scene;
    Diagnostics warnings;
    bool isProject = false;
};

/// Reads a project, or models and the animations that belong to them. `upAxis` ("y" or "z") is that of bare
/// models; empty: what is usual for each. Any file that cannot be read is an error.
Result<LoadedFiles> loadFiles(const std::vector<std::string>& files, const std::string& upAxis = {});

/// The same as a scene to be drawn: bare models get lights and a camera that present them in a picture of
/// this aspect (width / height). Warnings go to standard error.
Result<Scene> loadScene(const std::vector<std::string>& files, const std::string& upAxis, double aspect);
Result<Scene> loadScene(const std::string& file, const std::string& upAxis, double aspect);

/// Says an error on standard error in one line and ends the program with exit code 1.
[[noreturn]] void fail(const Diagnostic& error);

} // namespace prizma
