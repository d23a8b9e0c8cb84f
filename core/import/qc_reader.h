#pragma once

#include "core/diagnostic.h"
#include "core/scene/object.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prizma {

/// A morph target that a QC picks out of a VTA file.
struct QcFlex {
    std::string name;
    int frame = 0; ///< Number of the frame in the VTA, the first (the unmoved shape) being 0.
};

/// A reference model that the script takes in. Names of files are as written.
struct QcBody {
    std::string file;
    double scale = 1.0;
    std::string flexFile; ///< Empty if none.
    std::vector<QcFlex> flexes;
    std::string script; ///< Where it was read, for messages.
    int line = 0;
};

struct QcSequence {
    std::string name, file;
    double fps = 30.0;
    bool loops = false;
    double scale = 1.0;
    std::optional<std::pair<int, int>> frames; ///< First and last, if only a part is meant.
    std::string script;
    int line = 0;
};

/// What a QC script says of a model: the lines that shape it; all others are passed over.
struct QcModel {
    std::vector<QcBody> bodies;
    std::vector<QcSequence> sequences;
    std::vector<std::string> folders;        ///< $cd: where models may be.
    std::vector<std::string> textureFolders; ///< $cdtexture, $cdmaterials.
    std::optional<UpAxis> upAxis;
    Diagnostics warnings;
};

struct QcScript {
    std::string file; ///< Names it in messages.
    std::string text;
};

/// Gives the script that a line $include means. An error becomes a warning.
using QcIncluder = std::function<Result<QcScript>(const std::string& name)>;

/// Reads a QC script and what it includes. Of each body group the first choice is taken. Errors, with the
/// line: a command that lacks what it needs, a brace that is not closed, includes without end, absurdly many
/// bodies or sequences.
Result<QcModel> readQc(const QcScript& script, const QcIncluder& include);

} // namespace prizma
