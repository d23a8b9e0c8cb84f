#pragma once

#include "core/scene/clip.h"
#include "core/scene/object.h"

#include <string>
#include <vector>

namespace prizma {

/// A clip at one of its frames; no clip is the bind pose.
struct ClipMoment {
    ClipPtr clip;
    double frame = 0.0; ///< As `clipFrame` gives it.

    friend bool operator==(const ClipMoment&, const ClipMoment&) = default;
};

/// All that an object's pose depends on. Equal keys are equal poses: what is posed already is not posed
/// again.
struct PoseKey {
    ClipMoment now;
    ClipMoment before;                ///< What a cross-fade comes from.
    double share = 1.0;               ///< Of `now` in the blend, 0 to 1.
    std::vector<double> morphWeights; ///< One a morph target of the mesh; empty if all are 0.

    friend bool operator==(const PoseKey&, const PoseKey&) = default;
};

/// Whether the object's vertices are computed on the device: it is Dynamic and has bones or morph targets.
bool isPosed(const Object& object);

/// The object's clip of that name, or null.
ClipPtr findClip(const Object& object, const std::string& name);

/// The pose of an object at `seconds` of the timeline: a pure function. Clips that the object lacks count as
/// the bind pose.
PoseKey poseKeyOf(const Object& object, double seconds);

/// Makes the object go over to another of its clips (empty: the bind pose) at `seconds` of the timeline,
/// within `fadeSeconds`; 0 switches at once. It comes from the clip it plays: a fade in progress is cut
/// short.
void changeClip(Object& object, const std::string& clip, double seconds, double fadeSeconds);

} // namespace prizma
