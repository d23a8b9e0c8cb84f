// The timeline in the real window: clips are chosen and looked at, time is moved in by mouse, keys and
// playing, and the picture follows.
#include "tests/ui/ui_test_support.h"

#include "core/animation/pose_key.h"
#include "core/compute/device.h"
#include "ui/timeline/clip_list.h"
#include "ui/timeline/ruler_scale.h"
#include "ui/timeline/timeline_controller.h"
#include "ui/timeline/timeline_panel.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/viewport/skeleton_overlay.h"
#include "ui/viewport/viewport.h"

#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <random>
#include <set>

using namespace prizma;
using namespace prizma::test;

namespace {

void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, buttons, modifiers);
    QApplication::sendEvent(&widget, &move);
}

/// Up to what clocks round.
bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

} // namespace

class TestTimeline : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() {
        isolation_ = std::make_unique<Isolation>();
        if (chooseDevice(listDevices(), {}) < 0)
            QSKIP("There is no OpenCL device here.");
    }
    void init();
    void cleanup() { window_.reset(); }

    void clickChoosesAClip();
    void doubleClickFitsTheTimeline();
    void hoveringPreviews();
    void keyboardPreviewsUntilReturn();
    void listFollowsTheSelection();
    void scrubbingMovesTime();
    void scrubbingWhilePlaying();
    void playingShowsMovingPictures();
    void pausedPictureIsSharp();
    void stillScenesPlaySharply();
    void keysWork();
    void keysLeaveTextFieldsAlone();
    void fieldsMoveAndSetTheRange();
    void playingIsNoModification();
    void anotherSceneStopsPlaying();
    void rulerZoomsAndShowsAllAgain();
    void bonesTellTheirNames();
    void robotWalks();

    void controllerKeepsRealTime();
    void controllerStopsOnWholeFrames();
    void controllerRemembersTheMode();
    void rulerScaleIsConsistent();
    void rulerMarksAreRound();

  private:
    const Scene& scene() const { return window_->document().scene(); }
    const Object& strip() const { return scene().objects[1]; }
    double frame() const { return scene().timeline.frame; }
    Viewport& viewport() const { return window_->viewport(); }
    TimelineRuler& ruler() const { return window_->timelinePanel().ruler(); }
    TimelineController& controller() const { return window_->timeline(); }
    QTreeWidget& clips() const { return window_->timelinePanel().clips().list(); }
    int steps() const { return window_->document().undoStack().count(); }

    QPoint placeOf(double frameNumber) const {
        return {static_cast<int>(std::lround(ruler().xOf(frameNumber))), ruler().height() / 2};
    }
    QPoint rowOf(int row) const { return clips().visualItemRect(clips().topLevelItem(row)).center(); }
    void chooseBend() { QTest::mouseClick(clips().viewport(), Qt::LeftButton, {}, rowOf(1)); }

    /// The finished picture of the scene as it is now, at full resolution; null if that takes too long.
    FramePtr settledFrame() {
        FramePtr shown;
        const auto settled = [&] {
            shown = viewport().lastFrame();
            return shown && shown->isFinal && shown->width == viewport().width() &&
                   shown->scene == window_->document().shownScene();
        };
        return QTest::qWaitFor(settled, 20000) ? shown : nullptr;
    }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<MainWindow> window_;
};

/// Opens the window, imports a strip that bends, and asks for few samples.
void TestTimeline::init() {
    QSettings().clear();
    window_ = showWindow();
    window_->importFile(QStringLiteral(PRIZMA_TEST_DATA "/bend.gltf"));
    QTRY_COMPARE(scene().objects.size(), 2U);
    window_->document().edit(QStringLiteral("Prepare"), [](Scene& s) { s.render.samples = 2; });
}

void TestTimeline::clickChoosesAClip() {
    QCOMPARE(clips().topLevelItemCount(), 2);
    QCOMPARE(clips().topLevelItem(1)->text(0), QStringLiteral("bend"));
    QCOMPARE(clips().topLevelItem(1)->text(1), QString::number(strip().clips[0]->frameCount));
    const int before = steps();
    chooseBend();
    QCOMPARE(strip().clip, std::string("bend"));
    QCOMPARE(steps(), before + 1);
    QVERIFY(clips().topLevelItem(1)->font(0).bold());
    chooseBend();
    QCOMPARE(steps(), before + 1); // nothing has changed
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(strip().clip, std::string());
    QVERIFY(clips().topLevelItem(0)->font(0).bold());
    QVERIFY(!clips().topLevelItem(1)->font(0).bold());
    trigger(*window_, QStringLiteral("Edit/Redo"));
    QCOMPARE(strip().clip, std::string("bend"));
    QTest::mouseClick(clips().viewport(), Qt::LeftButton, {}, rowOf(0));
    QCOMPARE(strip().clip, std::string());
}

void TestTimeline::doubleClickFitsTheTimeline() {
    chooseBend();
    QTest::mouseDClick(clips().viewport(), Qt::LeftButton, {}, rowOf(1));
    QCOMPARE(scene().timeline.start, 0);
    QCOMPARE(scene().timeline.end, 30); // 31 keys
    QCOMPARE(scene().timeline.fps, strip().clips[0]->fps);
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(scene().timeline.end, 120);
    QTest::mouseClick(window_->findChild<QToolButton*>(QStringLiteral("fitRange")), Qt::LeftButton);
    QCOMPARE(scene().timeline.end, 30);
}

void TestTimeline::hoveringPreviews() {
    const FramePtr still = settledFrame();
    QVERIFY(still);
    const Scene before = scene();
    const int stepsBefore = steps();
    moveMouse(*clips().viewport(), rowOf(1));
    QVERIFY(window_->document().hasPreview());
    // The clip plays in the view, from its beginning.
    std::set<double> times;
    QTRY_VERIFY(viewport().lastFrame()->scene.objects[1].clip == "bend" &&
                (times.insert(viewport().lastFrame()->scene.objects[1].playback.offset), times.size() > 3));
    QVERIFY(viewport().lastFrame()->pixels != still->pixels);
    QVERIFY(scene() == before);
    QCOMPARE(steps(), stepsBefore);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(clips().viewport(), &leave);
    QVERIFY(!window_->document().hasPreview());
    const FramePtr again = settledFrame();
    QVERIFY(again);
    QCOMPARE(again->pixels, still->pixels);
}

void TestTimeline::keyboardPreviewsUntilReturn() {
    clips().setFocus();
    QTRY_VERIFY(clips().hasFocus());
    const int before = steps();
    QTest::keyClick(&clips(), Qt::Key_Down);
    QVERIFY(window_->document().hasPreview());
    QCOMPARE(strip().clip, std::string());
    viewport().setFocus();
    QVERIFY(!window_->document().hasPreview());
    QCOMPARE(clips().currentIndex().row(), 0);
    clips().setFocus();
    QTest::keyClick(&clips(), Qt::Key_Down);
    QTest::keyClick(&clips(), Qt::Key_Return);
    QVERIFY(!window_->document().hasPreview());
    QCOMPARE(strip().clip, std::string("bend"));
    QCOMPARE(steps(), before + 1);
}

void TestTimeline::listFollowsTheSelection() {
    // The only object with clips is meant as long as nothing says otherwise.
    window_->document().setSelection({});
    QVERIFY(clips().isVisible());
    window_->document().setSelection({{EntityKind::Object, strip().id}});
    trigger(*window_, QStringLiteral("Edit/Duplicate"));
    const Id copy = scene().objects.back().id;
    QVERIFY(clips().headerItem()->text(0).contains(toQString(scene().objects.back().name)));
    chooseBend();
    QCOMPARE(scene().findObject(copy)->clip, std::string("bend"));
    QCOMPARE(strip().clip, std::string());
    window_->document().setSelection({});
    QVERIFY(!clips().isVisible()); // two that it may be
    trigger(*window_, QStringLiteral("Edit/Undo"));
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QVERIFY(clips().isVisible());
}

void TestTimeline::scrubbingMovesTime() {
    chooseBend();
    const FramePtr straight = settledFrame();
    QVERIFY(straight);
    const int before = steps();
    QTest::mousePress(&ruler(), Qt::LeftButton, {}, placeOf(5));
    QCOMPARE(frame(), 5.0);
    for (int i = 6; i <= 15; ++i) {
        moveMouse(ruler(), placeOf(i), Qt::LeftButton);
        QCOMPARE(frame(), static_cast<double>(i)); // at once: it never lags behind the mouse
    }
    const FramePtr bent = settledFrame(); // sharp while the hand rests, although the button is still down
    QVERIFY(bent);
    QVERIFY(bent->pixels != straight->pixels);
    moveMouse(ruler(), placeOf(20) + QPoint(1, 0), Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(frame() > 20.0 && frame() < 21.0);
    moveMouse(ruler(), {-50, 3}, Qt::LeftButton);
    QCOMPARE(frame(), 0.0);
    moveMouse(ruler(), {ruler().width() + 50, 3}, Qt::LeftButton);
    QCOMPARE(frame(), 120.0);
    moveMouse(ruler(), placeOf(0), Qt::LeftButton);
    QTest::mouseRelease(&ruler(), Qt::LeftButton, {}, placeOf(0));
    QCOMPARE(steps(), before);
    const FramePtr again = settledFrame();
    QVERIFY(again);
    QCOMPARE(again->pixels, straight->pixels);
}

void TestTimeline::scrubbingWhilePlaying() {
    chooseBend();
    controller().play();
    QTRY_VERIFY(frame() > 0.0);
    QTest::mousePress(&ruler(), Qt::LeftButton, {}, placeOf(60));
    QTest::qWait(80);
    QCOMPARE(frame(), 60.0); // held by the hand
    moveMouse(ruler(), placeOf(90), Qt::LeftButton);
    QTest::qWait(80);
    QCOMPARE(frame(), 90.0);
    QVERIFY(controller().isPlaying());
    QTest::mouseRelease(&ruler(), Qt::LeftButton, {}, placeOf(90));
    QTRY_VERIFY(frame() > 90.0);
    controller().pause();
}

void TestTimeline::playingShowsMovingPictures() {
    chooseBend();
    const FramePtr still = settledFrame();
    QVERIFY(still);
    QTest::keyClick(&viewport(), Qt::Key_Space);
    QVERIFY(controller().isPlaying());
    std::set<double> frames;
    std::set<std::vector<std::uint8_t>> pictures;
    const auto watch = [&] {
        frames.insert(viewport().lastFrame()->scene.timeline.frame);
        pictures.insert(viewport().lastFrame()->pixels);
        return frames.size() >= 5 && pictures.size() >= 5;
    };
    QVERIFY(QTest::qWaitFor(watch, 20000));
    QTest::keyClick(&viewport(), Qt::Key_Space);
    QVERIFY(!controller().isPlaying());
    QCOMPARE(frame(), std::floor(frame()));
}

void TestTimeline::pausedPictureIsSharp() {
    chooseBend();
    QVERIFY(settledFrame());
    controller().play();
    QTRY_VERIFY(viewport().lastFrame()->scene.timeline.frame > 3.0);
    controller().pause();
    const FramePtr sharp = settledFrame();
    QVERIFY(sharp);
    QCOMPARE(sharp->width, viewport().width());
    QCOMPARE(sharp->scene.timeline.frame, frame());
}

void TestTimeline::stillScenesPlaySharply() {
    const FramePtr still = settledFrame(); // of the bind pose
    QVERIFY(still);
    controller().play();
    QTRY_VERIFY(frame() > 10.0);
    QCOMPARE(viewport().lastFrame()->pixels, still->pixels);
    controller().pause();
}

void TestTimeline::keysWork() {
    for (QWidget* widget : std::initializer_list<QWidget*>{&viewport(), &ruler()}) {
        widget->setFocus();
        QTRY_VERIFY(widget->hasFocus());
        QTest::keyClick(widget, Qt::Key_Home);
        QCOMPARE(frame(), 0.0);
        QTest::keyClick(widget, Qt::Key_Right);
        QTest::keyClick(widget, Qt::Key_Right);
        QCOMPARE(frame(), 2.0);
        QTest::keyClick(widget, Qt::Key_Left);
        QCOMPARE(frame(), 1.0);
        QTest::keyClick(widget, Qt::Key_End);
        QCOMPARE(frame(), 120.0);
        QTest::keyClick(widget, Qt::Key_Right);
        QCOMPARE(frame(), 120.0);
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY(controller().isPlaying());
        QTest::keyClick(widget, Qt::Key_Left); // a step pauses
        QVERIFY(!controller().isPlaying());
        QTest::keyClick(widget, Qt::Key_Space, Qt::ShiftModifier);
        QVERIFY(controller().isPlaying() && controller().isBackwards());
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY(!controller().isPlaying());
    }
    const Camera before = scene().camera;
    QTest::keyClick(&viewport(), Qt::Key_F, Qt::ShiftModifier); // what Home once did
    QVERIFY(scene().camera != before);
}

void TestTimeline::keysLeaveTextFieldsAlone() {
    controller().goTo(10.0);
    NumberField* end = window_->timelinePanel().findChild<NumberField*>(QStringLiteral("end"));
    QVERIFY(end);
    end->setFocus();
    QTRY_VERIFY(end->hasFocus());
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End, Qt::Key_Left, Qt::Key_Right, Qt::Key_Space})
        QTest::keyClick(end, key);
    QCOMPARE(frame(), 10.0);
    QVERIFY(!controller().isPlaying());
}

void TestTimeline::fieldsMoveAndSetTheRange() {
    const auto field = [this](const char* name) {
        viewport().setFocus(); // what was typed before is done
        return window_->timelinePanel().findChild<NumberField*>(QString::fromLatin1(name));
    };
    const int before = steps();
    typeInto(*field("frame"), QStringLiteral("12"));
    QCOMPARE(frame(), 12.0);
    QCOMPARE(field("time")->value(), 0.4);
    typeInto(*field("time"), QStringLiteral("1.5"));
    QCOMPARE(frame(), 45.0);
    NumberField* time = field("time"); // stepping keeps to whole frames, although a third is no round number
    time->setFocus();
    QTRY_VERIFY(time->hasFocus());
    for (int i = 1; i <= 10; ++i) {
        QTest::keyClick(time, Qt::Key_Up);
        QCOMPARE(frame(), 45.0 + i);
    }
    controller().goTo(45.0);
    QCOMPARE(steps(), before);

    typeInto(*field("end"), QStringLiteral("60"));
    QCOMPARE(scene().timeline.end, 60);
    typeInto(*field("start"), QStringLiteral("99")); // no further than the end
    QCOMPARE(scene().timeline.start, 60);
    typeInto(*field("start"), QStringLiteral("10"));
    QCOMPARE(scene().timeline.start, 10);
    typeInto(*field("fps"), QStringLiteral("15"));
    QCOMPARE(scene().timeline.fps, 15.0);
    QCOMPARE(field("time")->value(), 3.0);
    QCOMPARE(steps(), before + 4);
    drag(*field("end"), 40); // one drag is one step
    QVERIFY(scene().timeline.end > 60);
    QCOMPARE(steps(), before + 5);
    for (int i = 0; i < 5; ++i)
        trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(scene().timeline.start, 0);
    QCOMPARE(scene().timeline.end, 120);
    QCOMPARE(scene().timeline.fps, 30.0);
    QCOMPARE(frame(), 45.0);
    typeInto(*field("speed"), QStringLiteral("-2"));
    QCOMPARE(controller().speed(), -2.0);
}

void TestTimeline::playingIsNoModification() {
    chooseBend();
    QCOMPARE(window_->document().save(isolation_->path(QStringLiteral("playing.prizma"))), QString());
    QVERIFY(!window_->isWindowModified());
    const int before = steps();
    controller().play();
    QTRY_VERIFY(frame() > 2.0);
    controller().pause();
    QTest::mouseClick(&ruler(), Qt::LeftButton, {}, placeOf(33));
    QCOMPARE(frame(), 33.0);
    QVERIFY(!window_->isWindowModified());
    QCOMPARE(steps(), before);
    trigger(*window_, QStringLiteral("Edit/Undo")); // of the clip
    QCOMPARE(strip().clip, std::string());
    QCOMPARE(frame(), 33.0);
}

void TestTimeline::anotherSceneStopsPlaying() {
    controller().play();
    QVERIFY(controller().isPlaying());
    Scene other = scene();
    other.timeline.frame = 77.0;
    window_->document().reset(other, {});
    QVERIFY(!controller().isPlaying());
    QTest::qWait(60);
    QCOMPARE(frame(), 77.0);
    QTest::keyClick(&viewport(), Qt::Key_Right);
    QCOMPARE(frame(), 78.0);
}

void TestTimeline::rulerZoomsAndShowsAllAgain() {
    const double whole = ruler().xOf(1.0) - ruler().xOf(0.0);
    const QPoint middle = placeOf(60);
    QWheelEvent turn(middle, ruler().mapToGlobal(middle), {}, {0, 360}, Qt::NoButton, {}, Qt::NoScrollPhase,
                     false);
    QApplication::sendEvent(&ruler(), &turn);
    QVERIFY(ruler().xOf(1.0) - ruler().xOf(0.0) > 1.5 * whole);
    QVERIFY(std::abs(ruler().xOf(60.0) - middle.x()) < 1.5);
    QTest::mouseDClick(&ruler(), Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(ruler().xOf(1.0) - ruler().xOf(0.0) - whole) < 1e-9);
    // The whole range stays in view when it changes.
    window_->document().setProperty({{EntityKind::Timeline}}, "end", 1000);
    QVERIFY(ruler().xOf(0.0) >= 0.0 && ruler().xOf(1000.0) <= ruler().width());
}

void TestTimeline::bonesTellTheirNames() {
    chooseBend();
    auto* overlay = window_->findChild<SkeletonOverlay*>();
    QVERIFY(overlay && !overlay->isVisible());
    trigger(*window_, QStringLiteral("View/Skeletons"));
    QVERIFY(overlay->isVisible());
    QVERIFY(settledFrame());
    QTRY_VERIFY(overlay->placeOf(QStringLiteral("tip")));
    const QPointF tip = *overlay->placeOf(QStringLiteral("tip"));
    const QPointF root = *overlay->placeOf(QStringLiteral("root"));
    moveMouse(viewport(), tip.toPoint());
    QCOMPARE(overlay->hoveredBone(), QStringLiteral("tip"));
    moveMouse(viewport(), ((tip + root) / 2.0).toPoint());
    QCOMPARE(overlay->hoveredBone(), QStringLiteral("root"));
    moveMouse(viewport(), {2, 2});
    QCOMPARE(overlay->hoveredBone(), QString());
    // The overlay lets the mouse through: a drag orbits, and the bones follow the picture.
    const Camera before = scene().camera;
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, {200, 200});
    for (int i = 1; i <= 8; ++i)
        moveMouse(viewport(), {200 + 4 * i, 200 + 8 * i}, Qt::LeftButton);
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, {232, 264});
    QVERIFY(scene().camera != before);
    QTRY_VERIFY(overlay->placeOf(QStringLiteral("root")) &&
                *overlay->placeOf(QStringLiteral("root")) != root);
    trigger(*window_, QStringLiteral("View/Skeletons"));
    QVERIFY(!overlay->isVisible());
}

/// The whole way of somebody with a model of many sequences: import it, point at one, choose it, play.
void TestTimeline::robotWalks() {
    const QString folder = qEnvironmentVariable("PRIZMA_ASSETS");
    const QString file = folder + QStringLiteral("/smd/robot/robot.qc");
    if (folder.isEmpty() || !QFile::exists(file))
        QSKIP("PRIZMA_ASSETS has no smd/robot.");
    window_->importFile(file);
    QTRY_COMPARE_WITH_TIMEOUT(scene().objects.size(), 3U, 20000);
    window_->viewport().frameSelected();
    // Scrolling brings another clip under the pointer.
    moveMouse(*clips().viewport(), rowOf(1));
    const QString firstClip = clips().topLevelItem(1)->text(0);
    QTRY_COMPARE(toQString(window_->document().shownScene().objects[2].clip), firstClip);
    const QPoint pointer = rowOf(1);
    QWheelEvent turn(pointer, clips().viewport()->mapToGlobal(pointer), {}, {0, -240}, Qt::NoButton, {},
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(clips().viewport(), &turn);
    QTRY_VERIFY(clips().itemAt(pointer)->text(0) != firstClip);
    QTRY_COMPARE(toQString(window_->document().shownScene().objects[2].clip),
                 clips().itemAt(pointer)->text(0));

    const auto rows = clips().findItems(QStringLiteral("Walking"), Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    clips().scrollToItem(rows.front());
    const QPoint place = clips().visualItemRect(rows.front()).center();
    moveMouse(*clips().viewport(), place);
    QTRY_VERIFY_WITH_TIMEOUT(viewport().lastFrame(), 60000); // kernels may have to be compiled first
    QTRY_VERIFY(viewport().lastFrame()->scene.objects.size() == 3 &&
                viewport().lastFrame()->scene.objects[2].clip == "Walking");
    QCOMPARE(scene().objects[2].clip, std::string());
    QTest::mouseClick(clips().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(clips().viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(scene().objects[2].clip, std::string("Walking"));
    const ClipPtr walking = findClip(scene().objects[2], "Walking");
    QVERIFY(walking);
    QCOMPARE(scene().timeline.fps, walking->fps);
    QVERIFY(scene().timeline.end > 0 && scene().timeline.end < walking->frameCount);

    // Each frame is another picture, and the same frame the same one, whatever was shown in between.
    std::vector<FramePtr> pictures;
    for (const int number : {0, 5, 10, 0}) {
        controller().goTo(number);
        pictures.push_back(settledFrame());
        QVERIFY(pictures.back());
    }
    QVERIFY(pictures[0]->pixels != pictures[1]->pixels && pictures[1]->pixels != pictures[2]->pixels);
    QCOMPARE(pictures[3]->pixels, pictures[0]->pixels);
    controller().play();
    std::set<double> shown;
    const auto watch = [&] {
        shown.insert(viewport().lastFrame()->scene.timeline.frame);
        return shown.size() >= 10;
    };
    QVERIFY(QTest::qWaitFor(watch, 20000));
    controller().pause();
}

void TestTimeline::controllerKeepsRealTime() {
    double now = 100.0;
    Document document;
    TimelineController timeline(document, nullptr, [&now] { return now; });
    document.edit(QStringLiteral("range"), [](Scene& s) { s.timeline = {10.0, 0, 9, 0.0}; });
    timeline.play();
    now += 0.55;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 5.5));
    now += 1e3; // nobody had time for a thousand seconds: it is where it would be
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 5.5));
    now += 0.2;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 7.5));
    timeline.setSpeed(-1.0);
    now += 0.3;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 4.5));
    // A range that changes while it plays.
    document.edit(QStringLiteral("range"), [](Scene& s) { s.timeline.fps = 20.0; });
    now += 0.1;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 2.5));
    // Somebody else who moves in time.
    document.setFrame(8.0);
    now += 0.1;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 6.0));
}

void TestTimeline::controllerStopsOnWholeFrames() {
    double now = 5.0;
    Document document;
    TimelineController timeline(document, nullptr, [&now] { return now; });
    document.edit(QStringLiteral("range"), [](Scene& s) { s.timeline = {10.0, 2, 9, 2.0}; });
    timeline.setPlayMode(PlayMode::Once);
    timeline.play();
    now += 0.36;
    QTRY_VERIFY(document.scene().timeline.frame > 5.0);
    timeline.pause();
    QCOMPARE(document.scene().timeline.frame, 5.0);
    timeline.stepBy(1);
    QCOMPARE(document.scene().timeline.frame, 6.0);
    document.setFrame(6.5);
    timeline.stepBy(-1);
    QCOMPARE(document.scene().timeline.frame, 6.0);
    timeline.play();
    now += 60.0;
    QTRY_VERIFY(!timeline.isPlaying()); // by itself, at the end
    QCOMPARE(document.scene().timeline.frame, 9.0);
    timeline.play(); // once more from the start
    QCOMPARE(document.scene().timeline.frame, 9.0);
    now += 0.1;
    QTRY_VERIFY(isNear(document.scene().timeline.frame, 3.0));
    timeline.stop();
    QVERIFY(!timeline.isPlaying());
    QCOMPARE(document.scene().timeline.frame, 2.0);
    timeline.goTo(std::nan(""));
    timeline.goTo(1e9);
    QCOMPARE(document.scene().timeline.frame, 9.0);
}

void TestTimeline::controllerRemembersTheMode() {
    controller().setPlayMode(PlayMode::PingPong);
    QVERIFY(findAction(*window_->menuBar(), QStringLiteral("Playback/Back and Forth"))->isChecked());
    trigger(*window_, QStringLiteral("Playback/Once"));
    QVERIFY(controller().playMode() == PlayMode::Once);
    Document document;
    QVERIFY(TimelineController(document).playMode() == PlayMode::Once);
}

void TestTimeline::rulerScaleIsConsistent() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1000.0, 1000.0);
    for (int i = 0; i < 2000; ++i) {
        const double first = any(random);
        const RulerScale scale(first, first + std::abs(any(random)), std::abs(any(random)) + 10.0);
        const double f = any(random);
        QVERIFY(std::abs(scale.frameAt(scale.xOf(f)) - f) < 1e-6);
        const double x = std::abs(any(random));
        const RulerScale zoomed = scale.zoomed(std::exp(any(random) / 300.0), x);
        QVERIFY(std::abs(zoomed.frameAt(x) - scale.frameAt(x)) < 1e-3);
        QVERIFY(zoomed.last() > zoomed.first());
        const RulerScale panned = scale.panned(x);
        QVERIFY(std::abs(panned.xOf(f) - scale.xOf(f) - x) < 1e-3);
    }
}

void TestTimeline::rulerMarksAreRound() {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> exponent(0.1, 7.5);
    for (int i = 0; i < 2000; ++i) {
        const RulerScale scale(0.0, std::pow(10.0, exponent(random)), 800.0);
        const int step = scale.markStep(40.0);
        QVERIFY(step * scale.pixelsPerFrame() >= 40.0 - 1e-9);
        QVERIFY(step == 1 || step / 2.5 * scale.pixelsPerFrame() < 40.0 + 1e-9); // no more than needed
        int digits = step;
        while (digits % 10 == 0)
            digits /= 10;
        QVERIFY(digits == 1 || digits == 2 || digits == 5);
    }
}

QTEST_MAIN(TestTimeline)
#include "tst_timeline.moc"
