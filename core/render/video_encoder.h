#pragma once

#include "core/diagnostic.h"
#include "core/progress.h"

#include <string>
#include <vector>

namespace prizma {

struct VideoOptions {
    std::vector<std::string> pictures; ///< PNG files of one size, in the order in which they are shown.
    double fps = 30.0;
    std::string output; ///< Ends in .mp4 (H.264) or .webm (VP9).
};

/// Whether the program ffmpeg is installed: it makes the videos.
bool isVideoEncoderInstalled();

/// What to say if it is not.
Diagnostic missingVideoEncoder();

/// Why these options make no video, or an empty string.
std::string findFault(const VideoOptions& options);

/// Makes a video of pictures with the program ffmpeg. The file appears under its name once it is whole.
/// Errors: ffmpeg is not installed (says how to get it), what ffmpeg itself says, a picture that cannot be
/// read, cancelled. `progress` counts pictures.
Result<void> encodeVideo(const VideoOptions& options, Progress& progress);

} // namespace prizma
