#pragma once

#include "core/scene/scene.h"

namespace prizma {

enum class PlayMode {
    Loop,    ///< After the last frame comes the first.
    Once,    ///< Stops at the last frame.
    PingPong ///< Forwards and backwards in turn.
};

/// Turns a clock into frames of a timeline. It has no clock of its own: each call says what time it is, in
/// seconds from any fixed moment. A frame is computed from the time that has passed since playing began,
/// never summed up call by call, so that whoever asks seldom misses frames but keeps the speed.
///
/// A loop lasts `end - start + 1` frames, as long as a clip of that many keys: between the last frame and the
/// first, a looping clip's last key blends into its first one.
class TimelinePlayer {
  public:
    /// Takes the range and the frame rate from `timeline`; its frame does not count. An end before the start
    /// counts as the start.
    void setRange(const Timeline& timeline, double now);

    /// Frames go by this many times as fast; negative plays backwards. Not finite: 0.
    void setSpeed(double speed, double now);
    double speed() const { return speed_; }

    void setPlayMode(PlayMode mode, double now);
    PlayMode playMode() const { return mode_; }

    /// Plays from `frame` on, or from the range's other end if `frame` is where there is nothing left to
    /// play.
    void play(double frame, double now);
    void pause(double now); ///< `frameAt` stays what it is now.
    bool isPlaying() const { return playing_; }

    /// Goes on from `frame`, which is brought into the range.
    void seek(double frame, double now);

    /// Within the range; while looping it may lie up to one frame behind the end.
    double frameAt(double now) const;

    /// True if a range that is played once has come to its end.
    bool isOver(double now) const;

  private:
    /// Where playing is: the frame and, in ping-pong, whether it is on the way back.
    struct Place {
        double frame = 0.0;
        bool returning = false;
    };

    double length() const { return end_ - start_; }
    Place placeAt(double now) const;
    Place pingPong(double distance) const;
    double loop(double distance) const;
    double clamped(double frame) const;
    void settle(double now); ///< What follows is counted from `now` on.

    double start_ = 0.0;
    double end_ = 0.0;
    double fps_ = 30.0;
    double speed_ = 1.0;
    PlayMode mode_ = PlayMode::Loop;
    bool playing_ = false;
    Place place_; ///< At `since_`.
    double since_ = 0.0;
};

} // namespace prizma
