#include "core/animation/pose.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

class PoseTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void bindPoseMovesNothing();
    void keysAreMetExactly();
    void betweenKeysRotationsStayUnit();
    void loopHasNoPop();
    void clipThatDoesNotLoopHoldsItsEnds();
    void timesThatAreNoNumbersAreHarmless();

  private:
    const MeshPtr mesh_ = makeBendingMesh();
    const ClipPtr clip_ = makeBendClip();
};

void PoseTest::bindPoseMovesNothing() {
    for (const glm::mat4& matrix : skinningMatrices(*mesh_->skeleton, bindPose(*mesh_->skeleton)))
        for (int column = 0; column < 4; ++column)
            QVERIFY(glm::length(matrix[column] - glm::mat4(1.0f)[column]) < 1e-6f);
}

void PoseTest::keysAreMetExactly() {
    const auto& frames = clip_->tracks[0].frames;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Pose pose = evaluateClip(*mesh_->skeleton, *clip_, static_cast<double>(i) / clip_->fps);
        QVERIFY(std::abs(glm::dot(pose[1].rotation, frames[i].rotation)) > 0.999999f);
        QVERIFY(glm::length(pose[1].translation - frames[i].translation) < 1e-6f);
    }
}

void PoseTest::betweenKeysRotationsStayUnit() {
    for (int i = 0; i < 400; ++i) {
        const Pose pose = evaluateClip(*mesh_->skeleton, *clip_, i * 0.013 - 2.0);
        QVERIFY(std::abs(glm::length(pose[1].rotation) - 1.0f) < 1e-5f);
    }
}

void PoseTest::loopHasNoPop() {
    const double period = clip_->frameCount / clip_->fps;
    for (int i = -3; i <= 3; ++i) {
        const Pose before = evaluateClip(*mesh_->skeleton, *clip_, i * period - 1e-4);
        const Pose after = evaluateClip(*mesh_->skeleton, *clip_, i * period + 1e-4);
        QVERIFY(std::abs(glm::dot(before[1].rotation, after[1].rotation)) > 0.99999f);
    }
}

void PoseTest::clipThatDoesNotLoopHoldsItsEnds() {
    Clip clip = *clip_;
    clip.loops = false;
    const auto& frames = clip.tracks[0].frames;
    QCOMPARE(evaluateClip(*mesh_->skeleton, clip, -5.0)[1], frames.front());
    const Pose end = evaluateClip(*mesh_->skeleton, clip, 1e6);
    QVERIFY(std::abs(glm::dot(end[1].rotation, frames.back().rotation)) > 0.999999f);
}

void PoseTest::timesThatAreNoNumbersAreHarmless() {
    for (const double seconds : {std::nan(""), double(INFINITY), -double(INFINITY), 1e300})
        for (const BonePose& bone : evaluateClip(*mesh_->skeleton, *clip_, seconds))
            QVERIFY(std::isfinite(glm::length(bone.rotation)) &&
                    std::isfinite(glm::length(bone.translation)));
}

QTEST_GUILESS_MAIN(PoseTest)
#include "tst_pose.moc"
