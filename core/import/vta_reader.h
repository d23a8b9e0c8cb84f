#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prizma {

struct VtaVertex {
    int id = 0;
    glm::vec3 position{0.0F}, normal{0.0F}; ///< Absolute, in the file's model space.
};

struct VtaFrame {
    std::string name; ///< From the remark behind its "time" in the skeleton block; empty if there is none.
    int time = 0;
    std::vector<VtaVertex> vertices; ///< By id, each once.
};

/// A file of flexes. The first frame has all vertices, unmoved; each later one is a shape and has only the
/// vertices that move.
struct VtaFile {
    std::vector<VtaFrame> frames;
    Diagnostics warnings;
};

/// Reads the text of a VTA file. Errors, with the line: not a VTA, a block that does not end, fields that are
/// missing or no finite numbers, cancelled.
Result<VtaFile> readVta(std::string_view text, const std::string& file, const ProgressPart& progress);

} // namespace prizma
