#pragma once

#include "core/scene/skeleton.h"

#include <memory>
#include <string>
#include <vector>

namespace prizma {

/// Keys of one bone, one a frame, equally spaced. A bone without a track keeps its bind pose.
struct BoneTrack {
    int bone = 0; ///< Index into the skeleton the clip was paired with.
    std::vector<BonePose> frames;
};

/// A named piece of animation for one skeleton.
struct Clip {
    std::string name;
    double fps = 30.0;
    int frameCount = 0;
    bool loops = true;
    std::vector<BoneTrack> tracks;
};

using ClipPtr = std::shared_ptr<const Clip>;

} // namespace prizma
