#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>
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

/// Reads a model file: OBJ with MTL and textures, SMD and QC, and whatever else assimp reads. Slow: meant for
/// a background thread. Errors name the file: missing, empty, damaged, not a model, no triangles, cancelled.
Result<ImportedModel> importModel(const std::string& file, const ImportOptions& options, Progress& progress);

/// Name filters for file dialogs: extensions without dot that `importModel` reads, OBJ first.
std::vector<std::string> modelExtensions();

/// Whether `file` is in one of the formats of Half-Life and the Source engine that are models, by its name.
bool isValveFormat(const std::string& file);

/// The axis that is up in such a file, unless somebody knows better: Z in SMD and STL files, in a QC what it
/// says itself (it is read for that), Y in all others.
UpAxis usualUpAxis(const std::string& file);

/// What a file says that was to be imported as a model but is an animation.
inline constexpr std::string_view animationIsNoModel =
    "It is an animation, not a model: import the model that it belongs to, select it and choose File > "
    "Import "
    "Animation.";

/// Puts an imported model into the scene as one object: adds its materials, under their own names where these
/// are free, and gives back the object's id. The object is Dynamic if its mesh is skinned.
Id addModel(Scene& scene, const ImportedModel& model, const MeshSource& source);

} // namespace prizma
