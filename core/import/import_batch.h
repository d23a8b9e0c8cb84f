#pragma once

#include "core/import/animation_importer.h"
#include "core/import/model_importer.h"

#include <string>
#include <vector>

namespace prizma {

struct BatchModel {
    MeshSource source;
    ImportedModel model;
    std::vector<ImportedAnimation> animations;
};

/// Models and animations that are brought in together.
struct ImportBatch {
    std::vector<BatchModel> models;
    Diagnostics faults; ///< One error for each file that could not be read; the others are usable.
};

struct BatchFiles {
    std::vector<std::string> models, animations; ///< In the order given.
};

/// Tells models and mere animations apart; looks into SMDs. Leaves out what comes with another of the files:
/// the flexes (VTA) of an SMD, and all that a QC names.
BatchFiles sortFiles(const std::vector<std::string>& files);

/// Reads the models, each with its options, and then the animations. Each goes to the model that it suits
/// best. `options` has one entry a model.
ImportBatch importBatch(const BatchFiles& files, const std::vector<ImportOptions>& options,
                        Progress& progress);

/// Adds the model as one object with its clips and gives the object's id.
Id addModel(Scene& scene, const BatchModel& model);

/// Those of the model and of its animations.
Diagnostics warningsOf(const BatchModel& model);

} // namespace prizma
