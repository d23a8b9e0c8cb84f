#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <filesystem>

namespace prizma::bench {

/// Writes what other renderers need to draw the same picture: all visible triangles in world space as OBJ,
/// and beside it `file`.json with the camera, the first light and the background (tests/bench/cycles.py reads
/// it). Objects are written in their bind pose, materials not at all. Errors: a file that cannot be written.
Result<void> exportScene(const Scene& scene, const std::filesystem::path& file);

} // namespace prizma::bench
