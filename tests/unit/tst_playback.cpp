#include "core/animation/playback.h"

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
Playback playing(LoopMode mode, double frame = 10.0, double speed = 1.0) {
    Playback playback;
    playback.setRange({20.0, 10, 19, 0.0}, 100.0);
    playback.setLoopMode(mode, 100.0);
    playback.setSpeed(speed, 100.0);
    playback.play(frame, 100.0);
    return playback;
}

} // namespace

class TestPlayback : public QObject {
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

void TestPlayback::dropsFramesNotSpeed() {
    // However seldom or irregularly somebody asks, the frame is that of the clock.
    std::mt19937 random(1);
    std::exponential_distribution<double> late(3.0);
    Playback seldom = playing(LoopMode::Loop);
    const Playback never = playing(LoopMode::Loop);
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

void TestPlayback::loopsWithoutAPause() {
    const Playback playback = playing(LoopMode::Loop);
    QVERIFY(isNear(playback.frameAt(100.0), 10.0));
    QVERIFY(isNear(playback.frameAt(100.45), 19.0));
    QVERIFY(isNear(playback.frameAt(100.475), 19.5)); // the last frame lasts as long as any other
    QVERIFY(isNear(playback.frameAt(100.5), 10.0));
    QVERIFY(isNear(playback.frameAt(105.1), 12.0));
    QVERIFY(!playback.isOver(1000.0));
}

void TestPlayback::stopsAtTheEnd() {
    const Playback playback = playing(LoopMode::Once, 12.0);
    QVERIFY(isNear(playback.frameAt(100.1), 14.0));
    QVERIFY(!playback.isOver(100.34));
    QVERIFY(playback.isOver(100.36));
    QCOMPARE(playback.frameAt(100.36), 19.0);
    QCOMPARE(playback.frameAt(1e6), 19.0);
    const Playback back = playing(LoopMode::Once, 12.0, -1.0);
    QVERIFY(!back.isOver(100.09));
    QVERIFY(back.isOver(100.11));
    QCOMPARE(back.frameAt(100.11), 10.0);
}

void TestPlayback::beginsAnewWhenOver() {
    QCOMPARE(playing(LoopMode::Once, 19.0).frameAt(100.0), 10.0);
    QCOMPARE(playing(LoopMode::Once, 500.0).frameAt(100.0), 10.0);
    QCOMPARE(playing(LoopMode::Once, 10.0, -1.0).frameAt(100.0), 19.0);
    QCOMPARE(playing(LoopMode::Once, 19.0, -1.0).frameAt(100.0), 19.0); // there is a way to go
}

void TestPlayback::pingPongTurns() {
    Playback playback = playing(LoopMode::PingPong);
    QVERIFY(isNear(playback.frameAt(100.45), 19.0));
    QVERIFY(isNear(playback.frameAt(100.5), 18.0));
    QVERIFY(isNear(playback.frameAt(100.9), 10.0));
    QVERIFY(isNear(playback.frameAt(101.0), 12.0));
    // On the way back a seek keeps the direction.
    playback.seek(15.0, 100.6);
    QVERIFY(isNear(playback.frameAt(100.65), 14.0));
    const Playback back = playing(LoopMode::PingPong, 12.0, -1.0);
    QVERIFY(isNear(back.frameAt(100.1), 10.0));
    QVERIFY(isNear(back.frameAt(100.15), 11.0));
}

void TestPlayback::backwards() {
    const Playback playback = playing(LoopMode::Loop, 12.0, -2.0);
    QVERIFY(isNear(playback.frameAt(100.05), 10.0));
    QVERIFY(isNear(playback.frameAt(100.0625), 19.5));
    QVERIFY(isNear(playback.frameAt(100.1), 18.0));
}

void TestPlayback::changesOfSpeedDoNotJump() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> speed(-5.0, 5.0);
    for (const LoopMode mode : {LoopMode::Loop, LoopMode::Once, LoopMode::PingPong}) {
        Playback playback = playing(mode, 14.0);
        double now = 100.0;
        for (int i = 0; i < 200; ++i) {
            now += 0.137;
            const double before = playback.frameAt(now);
            playback.setSpeed(speed(random), now);
            QVERIFY(isNear(playback.frameAt(now), before));
        }
    }
    // A speed that doubles counts from now on only.
    Playback playback = playing(LoopMode::Loop);
    playback.setSpeed(2.0, 100.1);
    QVERIFY(isNear(playback.frameAt(100.2), 16.0));
}

void TestPlayback::seekGoesOnFromThere() {
    Playback playback = playing(LoopMode::Loop);
    playback.seek(15.0, 107.77);
    QVERIFY(isNear(playback.frameAt(107.77), 15.0));
    QVERIFY(isNear(playback.frameAt(107.87), 17.0));
    playback.seek(-1e9, 108.0);
    QCOMPARE(playback.frameAt(108.0), 10.0);
}

void TestPlayback::pauseHolds() {
    Playback playback = playing(LoopMode::Loop);
    playback.pause(100.2);
    QVERIFY(!playback.isPlaying());
    QVERIFY(isNear(playback.frameAt(500.0), 14.0));
    playback.play(playback.frameAt(500.0), 500.0);
    QVERIFY(isNear(playback.frameAt(500.1), 16.0));
}

void TestPlayback::staysInTheRange() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1e4, 1e4);
    for (int i = 0; i < 5000; ++i) {
        Playback playback;
        const int start = static_cast<int>(any(random));
        const int end = start + static_cast<int>(random() % 50) - 3;
        const auto mode = static_cast<LoopMode>(random() % 3);
        playback.setRange({std::abs(any(random)), start, end, 0.0}, 0.0);
        playback.setLoopMode(mode, 0.0);
        playback.setSpeed(any(random), 0.0);
        playback.play(any(random), 0.0);
        double now = 0.0;
        for (int k = 0; k < 10; ++k) {
            now += std::abs(any(random));
            const double frame = playback.frameAt(now);
            const double last = std::max(start, end);
            QVERIFY(frame >= start);
            QVERIFY(mode == LoopMode::Loop ? frame < last + 1.0 : frame <= last);
            if (k == 5)
                playback.setLoopMode(static_cast<LoopMode>(random() % 3), now);
            if (k == 5 && playback.loopMode() != mode)
                break;
        }
    }
}

void TestPlayback::degenerateRanges() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const LoopMode mode : {LoopMode::Loop, LoopMode::Once, LoopMode::PingPong}) {
        Playback playback;
        playback.setRange({30.0, 7, 3, 0.0}, 0.0); // the end before the start
        playback.setLoopMode(mode, 0.0);
        playback.play(std::nan(""), 0.0);
        QVERIFY(playback.frameAt(1.7) >= 7.0 && playback.frameAt(1.7) < 8.0);
        playback.setRange({std::nan(""), 0, 10, 0.0}, 2.0);
        playback.setSpeed(infinity, 2.0);
        playback.seek(4.0, 2.0);
        QCOMPARE(playback.frameAt(100.0), 4.0);
    }
}

QTEST_APPLESS_MAIN(TestPlayback)
#include "tst_playback.moc"
