#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>

namespace prizma {

/// Keys of a project file that this version does not know. They are written back where they were found.
struct UnknownKeys;
using UnknownKeysPtr = std::shared_ptr<const UnknownKeys>;

struct Project {
    Scene scene;
    UnknownKeysPtr unknownKeys;
    Diagnostics warnings; ///< Models or textures that could not be loaded: the object stays, without a mesh.
};

/// Reads a .prizma file with all models and textures it refers to. Slow: meant for a background thread.
/// Errors name file and line: not JSON, a newer version, values of a wrong type.
Result<Project> loadProject(const std::string& file, Progress& progress);

/// Writes atomically (to a temporary file that then replaces the old one); paths are stored relative to the
/// file.
Result<void> saveProject(const std::string& file, const Scene& scene, const UnknownKeysPtr& unknownKeys = {});

} // namespace prizma
