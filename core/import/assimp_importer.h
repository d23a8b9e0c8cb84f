#pragma once

#include "core/import/model_importer.h"

namespace prizma {

/// Reads a model by assimp. `file` is an absolute path to a file that exists and is not empty.
Result<ImportedModel> importWithAssimp(const std::string& file, const ImportOptions& options,
                                       Progress& progress);

/// The animations of a file and the bones that they move, with or without a model there.
struct AssimpAnimations {
    Skeleton skeleton;
    std::vector<ClipPtr>
        clips; ///< For that skeleton. The only one of a file that has no name is named after it.
};
Result<AssimpAnimations> importAnimationsWithAssimp(const std::string& file, const ImportOptions& options,
                                                    Progress& progress);

} // namespace prizma
