#pragma once

#include "core/progress.h"
#include "core/render/offline_render.h"

#include <functional>
#include <string>

namespace prizma {

/// Which frames of the timeline to render, and into which files.
struct SequenceOptions {
    OfflineOptions picture;
    int first = 0; ///< Frames of the timeline, both inclusive.
    int last = 0;
    std::string output;     ///< Ends in .png or .exr; a run of # stands for the frame's number.
    bool overwrite = false; ///< Renders frames whose file is there already, too.
};

/// One frame that is done.
struct SequenceFrame {
    int frame = 0;
    std::string file;
    const OfflinePicture* picture = nullptr; ///< Null if the file was there and the frame was left out.
};

struct SequenceSummary {
    int rendered = 0;
    int skipped = 0; ///< Their files were there.
};

/// Why these options make no sequence, or an empty string: another extension, no # for several frames, a last
/// frame before the first, a folder that is not there.
std::string findFault(const SequenceOptions& options);

/// The file of one frame: the run of # in `output` becomes the frame's number with at least as many digits.
std::string frameFile(const std::string& output, int frame);

/// Renders frame after frame of `scene`. A frame's file appears under its name once it is whole, so after a
/// cancelled or broken run the next one goes on where that ended. `progress` counts frames; cancelling it
/// ends the run within a fraction of a second, with an error. `frameDone` is called after each frame.
Result<SequenceSummary> renderSequence(Renderer& renderer, Scene scene, const SequenceOptions& options,
                                       Progress& progress,
                                       const std::function<void(const SequenceFrame&)>& frameDone = {});

} // namespace prizma
