#pragma once

#include "core/render/picture_sequence.h"
#include "core/render/video_encoder.h"

#include <functional>
#include <string>

namespace prizma {

enum class AnimationFormat { Png, Png16, Exr, Mp4, WebM };

bool isVideo(AnimationFormat format);
std::string_view extensionOf(AnimationFormat format); ///< "png", "exr", "mp4", "webm".

/// Frames of the timeline as a sequence of pictures, or as a video. A video's pictures are rendered into a
/// folder beside it first, so that a run that was cancelled goes on where it ended.
struct AnimationExport {
    AnimationFormat format = AnimationFormat::Png;
    OfflineOptions picture;
    int first = 0; ///< Both inclusive.
    int last = 0;
    double fps = 30.0;         ///< Of a video.
    std::string output;        ///< Pictures: with a run of # for the frame's number. A video: its file.
    bool overwrite = false;    ///< Renders frames that are there already anew.
    bool keepPictures = false; ///< Leaves a video's pictures where they are.
};

/// The pictures that are rendered for it.
SequenceOptions sequenceOf(const AnimationExport& animation);

/// Why it cannot be made, or an empty string.
std::string findFault(const AnimationExport& animation);

/// How many of its frames are rendered already and would be left out.
int finishedFrames(const AnimationExport& animation);

/// Renders what is missing, and makes the video. `progress` counts frames; when all are rendered,
/// `videoBegins` is called and it counts anew. Errors: those of `renderSequence` and `encodeVideo`.
Result<SequenceSummary> exportAnimation(Renderer& renderer, const Scene& scene,
                                        const AnimationExport& animation, Progress& progress,
                                        const std::function<void()>& videoBegins = {});

} // namespace prizma
