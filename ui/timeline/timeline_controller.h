#pragma once

#include "core/animation/timeline_player.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>

namespace prizma {

class Document;

/// Moves the document in time: plays, steps and scrubs its timeline. The only one with a timer, which runs
/// only while playing; what frame it is, TimelinePlayer knows.
class TimelineController : public QObject {
    Q_OBJECT

  public:
    using Clock = std::function<double()>; ///< Seconds from any fixed moment.

    /// Keeps a reference to `document`. Without a `clock`, time is that of the computer.
    explicit TimelineController(Document& document, QObject* parent = nullptr, Clock clock = {});

    /// Playing that is held up while somebody scrubs counts as playing.
    bool isPlaying() const { return player_.isPlaying(); }
    bool isBackwards() const { return direction_ < 0.0; }

    void play(); ///< From the present frame, at the chosen speed.
    void playBackwards();
    void pause(); ///< On a whole frame.
    void stop();  ///< Pauses, and goes back to the start.

    /// Plays if `playing`, else pauses.
    void setPlaying(bool playing);

    void goTo(double frame); ///< Within the range. Playing goes on from there.
    void goToStart();
    void goToEnd();
    void stepBy(int frames); ///< Pauses, and goes to the next or the previous whole frame.

    /// From `beginScrub` to `endScrub` the frame is where `goTo` puts it, also while playing.
    void beginScrub();
    void endScrub();

    PlayMode playMode() const { return player_.playMode(); }
    void setPlayMode(PlayMode mode); ///< Remembered for the next start.
    double speed() const { return speed_; }
    void setSpeed(double speed); ///< 1 is real time; negative plays backwards.

  Q_SIGNALS:
    void playingChanged();  ///< Playing or paused, forwards or backwards.
    void settingsChanged(); ///< Speed or mode.

  private:
    void start(double direction);
    void tick();
    void show(double frame);
    void followDocument();

    Document& document_;
    Clock clock_;
    QElapsedTimer elapsed_;
    QTimer timer_;
    TimelinePlayer player_;
    double speed_ = 1.0;
    double direction_ = 1.0;  ///< -1: the other way than `speed_` says.
    double shownFrame_ = 0.0; ///< That this object put into the document last.
    bool scrubbing_ = false;
};

} // namespace prizma
