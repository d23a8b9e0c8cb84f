#pragma once

#include "core/import/smd_file.h"
#include "core/scene/clip.h"
#include "core/scene/object.h"

#include <string>
#include <vector>

namespace prizma {

/// How an SMD file's points get into object space. The scale goes into the bones' places, so that poses keep
/// scale 1; the turn goes into the roots.
struct SmdSpace {
    UpAxis upAxis = UpAxis::Z;
    double scale = 1.0; ///< Scene units a unit of the file.
};

struct SmdSkeleton {
    Skeleton skeleton;               ///< Bones in the order of SmdFile::bones.
    std::vector<glm::dmat4> globals; ///< Bone space of the bind pose to object space.
};

/// The bones as the first frame has them: the bind pose. Bones that the first frame lacks stand where they
/// first appear, or else at their parents, with a warning. Errors: places too large to compute with.
Result<SmdSkeleton> makeSmdSkeleton(const SmdFile& smd, const SmdSpace& space, const std::string& file,
                                    Diagnostics& warnings);

/// All frames as a clip for the skeleton of the same file. A bone that a frame lacks stays where it was, with
/// a warning. Errors: too many frames and bones in too short a file; no frame.
Result<Clip> makeSmdClip(const SmdFile& smd, const SmdSpace& space, const std::string& file,
                         Diagnostics& warnings);

} // namespace prizma
