#pragma once

#include "core/import/model_importer.h"
#include "core/import/smd_skeleton.h"

#include <set>
#include <string>

namespace prizma {

/// Reads a QC script: its bodies as one mesh, its sequences as clips. `file` is an absolute path. A sequence,
/// or one of several bodies, that cannot be read is left out with a warning. Errors: as readQc; no body that
/// can be read.
Result<ImportedModel> importQc(const std::string& file, const ImportOptions& options, Progress& progress);

/// The same without pictures and without warnings of their absence: for who wants the clips.
Result<ImportedModel> importQcClips(const std::string& file, const ImportOptions& options,
                                    Progress& progress);

/// The absolute paths of the models, animations and flexes that a QC script names and that exist.
std::set<std::string> filesOfQc(const std::string& file);

/// The axis that a QC script says is up and the scale of its first body: how an animation for it is to be
/// read. As for a bare SMD (Z, 1) if it does not say or cannot be read.
SmdSpace spaceOfQc(const std::string& file);

} // namespace prizma
