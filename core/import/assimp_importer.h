#pragma once

#include "core/import/model_importer.h"

namespace prizma {

/// Reads a model by assimp. `file` is an absolute path to a file that exists and is not empty.
Result<ImportedModel> importWithAssimp(const std::string& file, const ImportOptions& options,
                                       Progress& progress);

} // namespace prizma
