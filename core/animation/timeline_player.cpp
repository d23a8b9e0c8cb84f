#include "core/animation/timeline_player.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// `value` modulo `period`, in [0, period) also for negative values.
double wrapped(double value, double period) {
    const double rest = value - std::floor(value / period) * period;
    return rest < period ? rest : 0.0; // rounding may give the period itself
}

} // namespace

void TimelinePlayer::setRange(const Timeline& timeline, double now) {
    const double end = std::max(timeline.start, timeline.end);
    const double fps = std::isfinite(timeline.fps) ? std::max(timeline.fps, 0.0) : 0.0;
    if (timeline.start == start_ && end == end_ && fps == fps_)
        return;
    settle(now);
    start_ = timeline.start;
    end_ = end;
    fps_ = fps;
    place_.frame = clamped(place_.frame);
}

void TimelinePlayer::setSpeed(double speed, double now) {
    settle(now);
    speed_ = std::isfinite(speed) ? speed : 0.0;
}

void TimelinePlayer::setPlayMode(PlayMode mode, double now) {
    settle(now);
    mode_ = mode;
    place_ = {clamped(place_.frame), false};
}

void TimelinePlayer::play(double frame, double now) {
    seek(frame, now);
    playing_ = true;
    if (isOver(now))
        place_.frame = speed_ < 0.0 ? end_ : start_;
}

void TimelinePlayer::pause(double now) {
    settle(now);
    playing_ = false;
}

void TimelinePlayer::seek(double frame, double now) {
    settle(now);
    place_.frame = clamped(frame);
}

double TimelinePlayer::frameAt(double now) const {
    return placeAt(now).frame;
}

bool TimelinePlayer::isOver(double now) const {
    const double frame = frameAt(now);
    return mode_ == PlayMode::Once && ((speed_ > 0.0 && frame >= end_) || (speed_ < 0.0 && frame <= start_));
}

double TimelinePlayer::clamped(double frame) const {
    if (!std::isfinite(frame))
        return start_;
    // A loop goes on behind the last frame until it is over.
    const double last = mode_ == PlayMode::Loop ? std::nextafter(end_ + 1.0, start_) : end_;
    return std::clamp(frame, start_, last);
}

TimelinePlayer::Place TimelinePlayer::placeAt(double now) const {
    if (!playing_)
        return place_;
    const double distance = (now - since_) * fps_ * speed_;
    switch (mode_) {
    case PlayMode::Loop:
        return {loop(distance), false};
    case PlayMode::PingPong:
        return pingPong(distance);
    case PlayMode::Once:
        break;
    }
    return {clamped(place_.frame + distance), false};
}

double TimelinePlayer::loop(double distance) const {
    return start_ + wrapped(place_.frame - start_ + distance, length() + 1.0);
}

/// The way there and back as one way of twice the length.
TimelinePlayer::Place TimelinePlayer::pingPong(double distance) const {
    if (length() == 0.0)
        return {start_, false};
    const double there = place_.frame - start_;
    const double way =
        wrapped((place_.returning ? 2.0 * length() - there : there) + distance, 2.0 * length());
    return way <= length() ? Place{start_ + way, false} : Place{start_ + 2.0 * length() - way, true};
}

void TimelinePlayer::settle(double now) {
    place_ = placeAt(now);
    since_ = now;
}

} // namespace prizma
