#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace prizma {

struct ImportOptions {
    UpAxis upAxis = UpAxis::Y; ///< The file's; Z is turned so that Y is up.
    double unitScale = 1.0;    ///< Scene units a unit of the file.
};

/// What a model file holds, ready to be put into a scene.
struct ImportedModel {
    MeshPtr mesh;
    std::vector<Material> materials; ///< One a slot of the mesh, ids not yet given.
    std::vector<ClipPtr> clips;
    Diagnostics warnings; ///< Missing textures and the like; the model is usable all the same.
};

/// Reads a model file (OBJ with MTL and textures, and whatever else assimp reads). Slow: meant for a
/// background thread. Errors name the file: missing, empty, damaged, not a model, no triangles, cancelled.
Result<ImportedModel> importModel(const std::string& file, const ImportOptions& options, Progress& progress);

/// Name filters for file dialogs: extensions without dot that `importModel` reads, OBJ first.
std::vector<std::string> modelExtensions();

/// Puts an imported model into the scene as one object: adds its materials, under their own names where these
/// are free, and gives back the object's id. The object is Dynamic if its mesh is skinned.
Id addModel(Scene& scene, const ImportedModel& model, const MeshSource& source);

} // namespace prizma
