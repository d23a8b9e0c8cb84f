#include "core/animation/timeline_player.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace prizma;

namespace {

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

/// Frames 10 to 19 at 20 frames a second, playing since 100 s.
TimelinePlayer playing(PlayMode mode, double frame = 10.0, double speed = 1.0) {
    TimelinePlayer player;
    player.setRange({20.0, 10, 19, 0.0}, 100.0);
    player.setPlayMode(mode, 100.0);
    player.setSpeed(speed, 100.0);
    player.play(frame, 100.0);
    return player;
}

} // namespace

class TestTimelinePlayer : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void dropsFramesNotSpeed();
    void loopsWithoutAPause();
    void stopsAtTheEnd();
    void beginsAnewWhenOver();
    void pingPongTurns();
    void backwards();
    void changesOfSpeedDoNotJump();
    void seekGoesOnFromThere();
    void pauseHolds();
    void staysInTheRange();
    void degenerateRanges();
};

void TestTimelinePlayer::dropsFramesNotSpeed() {
    // However seldom or irregularly somebody asks, the frame is that of the clock.
    std::mt19937 random(1);
    std::exponential_distribution<double> late(3.0);
    TimelinePlayer seldom = playing(PlayMode::Loop);
    const TimelinePlayer never = playing(PlayMode::Loop);
    double now = 100.0;
    for (int i = 0; i < 1000; ++i) {
        now += late(random);
        const double expected = 10.0 + std::fmod((now - 100.0) * 20.0, 10.0);
        QVERIFY(std::abs(seldom.frameAt(now) - expected) < 1e-6);
        // Calls in between that change nothing do not add up to an error, either.
        seldom.setSpeed(1.0, now);
        QVERIFY(std::abs(seldom.frameAt(now) - never.frameAt(now)) < 1e-6);
    }
}

void TestTimelinePlayer::loopsWithoutAPause() {
    const TimelinePlayer player = playing(PlayMode::Loop);
    QVERIFY(isNear(player.frameAt(100.0), 10.0));
    QVERIFY(isNear(player.frameAt(100.45), 19.0));
    QVERIFY(isNear(player.frameAt(100.475), 19.5)); // the last frame lasts as long as any other
    QVERIFY(isNear(player.frameAt(100.5), 10.0));
    QVERIFY(isNear(player.frameAt(105.1), 12.0));
    QVERIFY(!player.isOver(1000.0));
}

void TestTimelinePlayer::stopsAtTheEnd() {
    const TimelinePlayer player = playing(PlayMode::Once, 12.0);
    QVERIFY(isNear(player.frameAt(100.1), 14.0));
    QVERIFY(!player.isOver(100.34));
    QVERIFY(player.isOver(100.36));
    QCOMPARE(player.frameAt(100.36), 19.0);
    QCOMPARE(player.frameAt(1e6), 19.0);
    const TimelinePlayer back = playing(PlayMode::Once, 12.0, -1.0);
    QVERIFY(!back.isOver(100.09));
    QVERIFY(back.isOver(100.11));
    QCOMPARE(back.frameAt(100.11), 10.0);
}

void TestTimelinePlayer::beginsAnewWhenOver() {
    QCOMPARE(playing(PlayMode::Once, 19.0).frameAt(100.0), 10.0);
    QCOMPARE(playing(PlayMode::Once, 500.0).frameAt(100.0), 10.0);
    QCOMPARE(playing(PlayMode::Once, 10.0, -1.0).frameAt(100.0), 19.0);
    QCOMPARE(playing(PlayMode::Once, 19.0, -1.0).frameAt(100.0), 19.0); // there is a way to go
}

void TestTimelinePlayer::pingPongTurns() {
    TimelinePlayer player = playing(PlayMode::PingPong);
    QVERIFY(isNear(player.frameAt(100.45), 19.0));
    QVERIFY(isNear(player.frameAt(100.5), 18.0));
    QVERIFY(isNear(player.frameAt(100.9), 10.0));
    QVERIFY(isNear(player.frameAt(101.0), 12.0));
    // On the way back a seek keeps the direction.
    player.seek(15.0, 100.6);
    QVERIFY(isNear(player.frameAt(100.65), 14.0));
    const TimelinePlayer back = playing(PlayMode::PingPong, 12.0, -1.0);
    QVERIFY(isNear(back.frameAt(100.1), 10.0));
    QVERIFY(isNear(back.frameAt(100.15), 11.0));
}

void TestTimelinePlayer::backwards() {
    const TimelinePlayer player = playing(PlayMode::Loop, 12.0, -2.0);
    QVERIFY(isNear(player.frameAt(100.05), 10.0));
    QVERIFY(isNear(player.frameAt(100.0625), 19.5));
    QVERIFY(isNear(player.frameAt(100.1), 18.0));
}

void TestTimelinePlayer::changesOfSpeedDoNotJump() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> speed(-5.0, 5.0);
    for (const PlayMode mode : {PlayMode::Loop, PlayMode::Once, PlayMode::PingPong}) {
        TimelinePlayer player = playing(mode, 14.0);
        double now = 100.0;
        for (int i = 0; i < 200; ++i) {
            now += 0.137;
            const double before = player.frameAt(now);
            player.setSpeed(speed(random), now);
            QVERIFY(isNear(player.frameAt(now), before));
        }
    }
    // A speed that doubles counts from now on only.
    TimelinePlayer player = playing(PlayMode::Loop);
    player.setSpeed(2.0, 100.1);
    QVERIFY(isNear(player.frameAt(100.2), 16.0));
}

void TestTimelinePlayer::seekGoesOnFromThere() {
    TimelinePlayer player = playing(PlayMode::Loop);
    player.seek(15.0, 107.77);
    QVERIFY(isNear(player.frameAt(107.77), 15.0));
    QVERIFY(isNear(player.frameAt(107.87), 17.0));
    player.seek(-1e9, 108.0);
    QCOMPARE(player.frameAt(108.0), 10.0);
}

void TestTimelinePlayer::pauseHolds() {
    TimelinePlayer player = playing(PlayMode::Loop);
    player.pause(100.2);
    QVERIFY(!player.isPlaying());
    QVERIFY(isNear(player.frameAt(500.0), 14.0));
    player.play(player.frameAt(500.0), 500.0);
    QVERIFY(isNear(player.frameAt(500.1), 16.0));
}

void TestTimelinePlayer::staysInTheRange() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1e4, 1e4);
    for (int i = 0; i < 5000; ++i) {
        TimelinePlayer player;
        const int start = static_cast<int>(any(random));
        const int end = start + static_cast<int>(random() % 50) - 3;
        const auto mode = static_cast<PlayMode>(random() % 3);
        player.setRange({std::abs(any(random)), start, end, 0.0}, 0.0);
        player.setPlayMode(mode, 0.0);
        player.setSpeed(any(random), 0.0);
        player.play(any(random), 0.0);
        double now = 0.0;
        for (int k = 0; k < 10; ++k) {
            now += std::abs(any(random));
            const double frame = player.frameAt(now);
            const double last = std::max(start, end);
            QVERIFY(frame >= start);
            QVERIFY(mode == PlayMode::Loop ? frame < last + 1.0 : frame <= last);
            if (k == 5)
                player.setPlayMode(static_cast<PlayMode>(random() % 3), now);
            if (k == 5 && player.playMode() != mode)
                break;
        }
    }
}

void TestTimelinePlayer::degenerateRanges() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const PlayMode mode : {PlayMode::Loop, PlayMode::Once, PlayMode::PingPong}) {
        TimelinePlayer player;
        player.setRange({30.0, 7, 3, 0.0}, 0.0); // the end before the start
        player.setPlayMode(mode, 0.0);
        player.play(std::nan(""), 0.0);
        QVERIFY(player.frameAt(1.7) >= 7.0 && player.frameAt(1.7) < 8.0);
        player.setRange({std::nan(""), 0, 10, 0.0}, 2.0);
        player.setSpeed(infinity, 2.0);
        player.seek(4.0, 2.0);
        QCOMPARE(player.frameAt(100.0), 4.0);
    }
}

QTEST_APPLESS_MAIN(TestTimelinePlayer)
#include "tst_timeline_player.moc"
