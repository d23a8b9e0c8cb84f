#pragma once

#include <string>

namespace prizma {

/// What a clip does beyond its ends.
enum class LoopMode {
    AsClip, ///< As its file says: loop or once.
    Loop,
    Once, ///< Holds its first pose before, its last one after.
    PingPong
};

/// How an object plays its clip on the timeline. Time runs as offset + speed · seconds.
///
/// A cross-fade is written down as what it blends from and when it starts on the timeline, not as a share
/// that somebody counts up while playing: so a pose depends on nothing but the object and the time, and
/// scrubbing in any order, playing, and rendering a frame alone all show the same picture.
struct Playback {
    double offset = 0.0; ///< Seconds into the clip when the timeline is at 0.
    double speed = 1.0;  ///< Clip seconds a timeline second; negative plays backwards.
    LoopMode loop = LoopMode::AsClip;
    double fps = 0.0; ///< Frames a second in place of the clip's own rate; 0 for that.

    std::string fadeFrom;     ///< Name of the clip that played before; empty for the bind pose.
    double fadeStart = 0.0;   ///< Timeline seconds at which the fade begins.
    double fadeSeconds = 0.0; ///< How long it takes; 0 for no fade.

    friend bool operator==(const Playback&, const Playback&) = default;
};

} // namespace prizma
