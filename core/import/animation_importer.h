#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"
#include "core/scene/object.h"

#include <string>
#include <vector>

namespace prizma {

/// Clips of an animation file, paired with a model's bones.
struct ImportedAnimation {
    std::string file; ///< Absolute path.
    std::vector<ClipPtr> clips;
    Diagnostics warnings; ///< Bones the animation lacks or has in excess, and the like.
};

/// Reads an animation for the model that `source` and `skeleton` describe: an SMD, the sequences of a QC, or
/// the animations of whatever assimp reads (glTF, FBX, Collada, MD5, ...). It is turned and scaled as the
/// model was. Bones pair by name. Slow: meant for a background thread. Errors name the file: missing,
/// damaged, no animation, no bone in common with the model, cancelled.
Result<ImportedAnimation> importAnimation(const std::string& file, const Skeleton& skeleton,
                                          const MeshSource& source, Progress& progress);

/// Gives the object the clips, under names of their own, and notes their file. Clips that came from the same
/// file before are replaced. Chooses the first new clip where none is playing.
void addAnimation(Object& object, const ImportedAnimation& animation);

/// Whether `file` is a mere animation of a model that is in another file; looks into SMDs.
bool isAnimationFile(const std::string& file);

/// Name filters for file dialogs: extensions without dot that `importAnimation` reads, SMD first.
std::vector<std::string> animationExtensions();

} // namespace prizma
