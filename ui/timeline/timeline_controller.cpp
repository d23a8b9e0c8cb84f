#include "ui/timeline/timeline_controller.h"

#include "ui/document/document.h"

#include <QSettings>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace prizma {
namespace {

constexpr std::chrono::milliseconds tickInterval{16}; // A screen shows no more; late ones are dropped.
const QString modeKey = QStringLiteral("timeline/playMode");

PlayMode rememberedMode() {
    const int stored = QSettings().value(modeKey, 0).toInt();
    return stored >= 0 && stored <= static_cast<int>(PlayMode::PingPong) ? static_cast<PlayMode>(stored)
                                                                         : PlayMode::Loop;
}

/// The whole frame that is on the screen at `frame`, whatever rounding made of it.
double wholeFrame(double frame) {
    return std::floor(frame + 1e-6);
}

} // namespace

TimelineController::TimelineController(Document& document, QObject* parent, Clock clock)
    : QObject(parent), document_(document), clock_(std::move(clock)), timer_(this) {
    elapsed_.start();
    if (!clock_)
        clock_ = [this] { return static_cast<double>(elapsed_.nsecsElapsed()) * 1e-9; };
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(tickInterval);
    player_.setRange(document.scene().timeline, clock_());
    player_.setPlayMode(rememberedMode(), clock_());
    connect(&timer_, &QTimer::timeout, this, &TimelineController::tick);
    connect(&document, &Document::sceneChanged, this, &TimelineController::followDocument);
    connect(&document, &Document::replaced, this, [this] {
        if (!isPlaying())
            return;
        timer_.stop();
        player_.pause(clock_());
        Q_EMIT playingChanged();
    });
}

void TimelineController::play() {
    start(1.0);
}

void TimelineController::playBackwards() {
    start(-1.0);
}

void TimelineController::start(double direction) {
    if (isPlaying() && direction == direction_)
        return;
    const double now = clock_();
    direction_ = direction;
    player_.setSpeed(speed_ * direction_, now);
    if (!isPlaying()) {
        player_.play(document_.scene().timeline.frame, now);
        shownFrame_ = document_.scene().timeline.frame;
    }
    if (!scrubbing_)
        timer_.start();
    Q_EMIT playingChanged();
}

void TimelineController::pause() {
    if (!isPlaying())
        return;
    timer_.stop();
    player_.pause(clock_());
    show(wholeFrame(document_.scene().timeline.frame));
    Q_EMIT playingChanged();
}

void TimelineController::stop() {
    pause();
    goToStart();
}

void TimelineController::setPlaying(bool playing) {
    if (playing)
        play();
    else
        pause();
}

void TimelineController::goTo(double frame) {
    if (!std::isfinite(frame))
        return;
    const double start = document_.scene().timeline.start;
    const double end = document_.scene().timeline.end;
    frame = std::clamp(frame, start, std::max(start, end));
    player_.seek(frame, clock_());
    show(frame);
}

void TimelineController::goToStart() {
    goTo(document_.scene().timeline.start);
}

void TimelineController::goToEnd() {
    goTo(document_.scene().timeline.end);
}

void TimelineController::stepBy(int frames) {
    pause();
    const double frame = document_.scene().timeline.frame;
    goTo((frames > 0 ? std::floor(frame) : std::ceil(frame)) + frames);
}

void TimelineController::beginScrub() {
    scrubbing_ = true;
    timer_.stop();
}

void TimelineController::endScrub() {
    scrubbing_ = false;
    if (!isPlaying())
        return;
    player_.seek(document_.scene().timeline.frame, clock_());
    timer_.start();
}

void TimelineController::setPlayMode(PlayMode mode) {
    player_.setPlayMode(mode, clock_());
    QSettings().setValue(modeKey, static_cast<int>(mode));
    Q_EMIT settingsChanged();
}

void TimelineController::setSpeed(double speed) {
    speed_ = speed;
    player_.setSpeed(speed_ * direction_, clock_());
    Q_EMIT settingsChanged();
}

void TimelineController::tick() {
    const double now = clock_();
    show(player_.frameAt(now));
    if (player_.isOver(now))
        pause();
}

void TimelineController::show(double frame) {
    shownFrame_ = frame;
    document_.setFrame(frame);
}

void TimelineController::followDocument() {
    const double now = clock_();
    const Timeline& timeline = document_.scene().timeline;
    player_.setRange(timeline, now);
    // Somebody else moved in time: the project's file, or the property panel.
    if (timeline.frame != shownFrame_) {
        shownFrame_ = timeline.frame;
        player_.seek(timeline.frame, now);
    }
}

} // namespace prizma
