#pragma once

#include "core/import/model_importer.h"
#include "core/import/smd_skeleton.h"

#include <string>

namespace prizma {

/// Reads a reference SMD with its textures, and the flexes of a VTA file of the same name beside it. `file`
/// is an absolute path. Errors: as readSmd, and an animation that was taken for a model.
Result<ImportedModel> importSmd(const std::string& file, const ImportOptions& options, Progress& progress);

/// The same of an SMD that was read already, without pictures and flexes. What the fuzzer calls.
Result<ImportedModel> buildSmdModel(const SmdFile& smd, const std::string& file,
                                    const ImportOptions& options);

/// An SMD animation, read by itself.
struct SmdAnimation {
    Skeleton skeleton;
    Clip clip; ///< Named after the file, 30 frames a second.
    Diagnostics warnings;
};
Result<SmdAnimation> importSmdAnimation(const std::string& file, const SmdSpace& space,
                                        const ProgressPart& progress);

} // namespace prizma
