#include "core/animation/clip_time.h"
#include "core/animation/pose.h"
#include "core/animation/posed_bounds.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <set>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Of `keys` frames, with random bones of a chain; `closed` repeats the first key at the end.
ClipPtr makeRandomClip(std::mt19937& random, int bones, int keys, bool closed) {
    std::normal_distribution<float> normal;
    auto clip = std::make_shared<Clip>();
    clip->name = "random";
    clip->fps = 24.0;
    clip->frameCount = keys;
    for (int bone = 0; bone < bones; ++bone) {
        BoneTrack track{bone, {}};
        for (int i = 0; i < keys; ++i)
            track.frames.push_back(
                {{normal(random), normal(random), normal(random)},
                 glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random))),
                 glm::vec3(1.0f) + 0.2f * glm::vec3(normal(random), normal(random), normal(random))});
        if (closed)
            track.frames.back() = track.frames.front();
        clip->tracks.push_back(std::move(track));
    }
    return clip;
}

SkeletonPtr makeChain(int bones) {
    auto skeleton = std::make_shared<Skeleton>();
    glm::mat4 toObject(1.0f);
    for (int i = 0; i < bones; ++i) {
        Bone bone{"bone" + std::to_string(i), i - 1, {{0.0f, 0.5f, 0.0f}, {}, glm::vec3(1.0f)}, {}};
        bone.bind.rotation = glm::angleAxis(0.1f * static_cast<float>(i), glm::vec3(0, 0, 1));
        toObject = toObject * glm::translate(glm::mat4(1.0f), bone.bind.translation) *
                   glm::mat4_cast(bone.bind.rotation);
        bone.inverseBind = glm::inverse(toObject);
        skeleton->bones.push_back(bone);
    }
    return skeleton;
}

// The reference: double precision, written from the definitions and sharing nothing with core/animation.

glm::dquat referenceSlerp(const glm::dquat& a, glm::dquat b, double share) {
    double cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
    if (cosine < 0.0) {
        b = {-b.w, -b.x, -b.y, -b.z};
        cosine = -cosine;
    }
    const double angle = std::acos(std::min(cosine, 1.0));
    if (angle < 1e-9)
        return a;
    const double wa = std::sin((1.0 - share) * angle) / std::sin(angle);
    const double wb = std::sin(share * angle) / std::sin(angle);
    return {wa * a.w + wb * b.w, wa * a.x + wb * b.x, wa * a.y + wb * b.y, wa * a.z + wb * b.z};
}

struct ReferenceBone {
    glm::dvec3 translation;
    glm::dquat rotation;
    glm::dvec3 scale;
};

ReferenceBone referenceBlend(const ReferenceBone& a, const ReferenceBone& b, double share) {
    return {a.translation * (1.0 - share) + b.translation * share,
            referenceSlerp(a.rotation, b.rotation, share), a.scale * (1.0 - share) + b.scale * share};
}

ReferenceBone widened(const BonePose& bone) {
    return {glm::dvec3(bone.translation), glm::normalize(glm::dquat(bone.rotation)), glm::dvec3(bone.scale)};
}

/// Key `i` of a clip that goes on for ever in both directions.
std::size_t referenceKey(LoopMode mode, long i, long keys, bool closed) {
    if (mode == LoopMode::Once)
        return static_cast<std::size_t>(std::clamp(i, 0L, keys - 1));
    if (mode == LoopMode::Loop) {
        const long period = closed ? keys - 1 : keys;
        return static_cast<std::size_t>(((i % period) + period) % period);
    }
    const long period = 2 * (keys - 1);
    const long inside = ((i % period) + period) % period;
    return static_cast<std::size_t>(inside < keys ? inside : period - inside);
}

ReferenceBone referenceAt(const BoneTrack& track, LoopMode mode, double frame, bool closed) {
    const auto keys = static_cast<long>(track.frames.size());
    const auto before = static_cast<long>(std::floor(frame));
    const auto at = [&](long i) { return widened(track.frames[referenceKey(mode, i, keys, closed)]); };
    return referenceBlend(at(before), at(before + 1), frame - std::floor(frame));
}

double distance(const ReferenceBone& a, const BonePose& b) {
    const glm::dquat q = glm::normalize(glm::dquat(b.rotation));
    const double cosine = std::abs(glm::dot(glm::normalize(a.rotation), q));
    return std::max({glm::length(a.translation - glm::dvec3(b.translation)),
                     glm::length(a.scale - glm::dvec3(b.scale)), std::sqrt(std::max(0.0, 1.0 - cosine))});
}

double distance(const Pose& a, const Pose& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, distance(widened(a[i]), b[i]));
    return most;
}

Object animated(const SkeletonPtr& skeleton, std::vector<ClipPtr> clips) {
    Object object;
    auto mesh = std::make_shared<Mesh>(*makeBendingMesh());
    mesh->skeleton = skeleton;
    object.mesh = mesh;
    object.dynamic = true;
    object.clips = std::move(clips);
    object.clip = object.clips.front()->name;
    return object;
}

Pose poseOf(const Object& object, double seconds) {
    return evaluatePose(*object.mesh->skeleton, poseKeyOf(object, seconds));
}

} // namespace

class PoseTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void bindPoseMovesNothing();
    void keysAreMetExactly();
    void agreesWithTheReference_data();
    void agreesWithTheReference();
    void isContinuousEverywhere_data() { agreesWithTheReference_data(); }
    void isContinuousEverywhere();
    void repeatedLastKeyIsNotShownTwice();
    void nearlyRepeatedLastKeyCounts();
    void rotationsGoTheShortWay();
    void orderOfTimesDoesNotMatter();
    void heldPoseHasOneKey();
    void fadeLeadsFromOneClipToTheOther();
    void fadeFromTheBindPose();
    void changingTheClipDoesNotJump();
    void timesThatAreNoNumbersAreHarmless();
    void oddClipsAreHarmless();
    void boundsFollowThePose();

  private:
    const MeshPtr mesh_ = makeBendingMesh();
    const ClipPtr clip_ = makeBendClip();
};

void PoseTest::bindPoseMovesNothing() {
    for (const SkeletonPtr& skeleton : {mesh_->skeleton, makeChain(20)})
        for (const glm::mat4& matrix : skinningMatrices(*skeleton, bindPose(*skeleton)))
            for (int column = 0; column < 4; ++column)
                QVERIFY(glm::length(matrix[column] - glm::mat4(1.0f)[column]) < 1e-5f);
}

void PoseTest::keysAreMetExactly() {
    const auto& frames = clip_->tracks[0].frames;
    for (std::size_t i = 0; i < frames.size(); ++i)
        QCOMPARE(poseAtFrame(*mesh_->skeleton, *clip_, static_cast<double>(i))[1], frames[i]);
}

void PoseTest::agreesWithTheReference_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("closed");
    QTest::newRow("loop") << static_cast<int>(LoopMode::Loop) << false;
    QTest::newRow("loop whose last key repeats the first") << static_cast<int>(LoopMode::Loop) << true;
    QTest::newRow("once") << static_cast<int>(LoopMode::Once) << false;
    QTest::newRow("back and forth") << static_cast<int>(LoopMode::PingPong) << false;
    QTest::newRow("back and forth, closed") << static_cast<int>(LoopMode::PingPong) << true;
}

void PoseTest::agreesWithTheReference() {
    QFETCH(int, mode);
    QFETCH(bool, closed);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> seconds(-20.0, 20.0), speed(-3.0, 3.0), fps(1.0, 90.0);
    const SkeletonPtr skeleton = makeChain(5);
    for (int round = 0; round < 40; ++round) {
        const int keys = 3 + static_cast<int>(random() % 20);
        Object object = animated(skeleton, {makeRandomClip(random, 5, keys, closed)});
        object.playback.loop = static_cast<LoopMode>(mode);
        object.playback.speed = speed(random);
        object.playback.offset = seconds(random);
        object.playback.fps = round % 2 == 0 ? 0.0 : fps(random);
        for (int i = 0; i < 50; ++i) {
            const double at = seconds(random);
            const double rate = object.playback.fps > 0.0 ? object.playback.fps : 24.0;
            const double frame = (object.playback.offset + object.playback.speed * at) * rate;
            const Pose pose = poseOf(object, at);
            for (const BoneTrack& track : object.clips[0]->tracks)
                QVERIFY(distance(referenceAt(track, static_cast<LoopMode>(mode), frame, closed),
                                 pose[static_cast<std::size_t>(track.bone)]) < 1e-3);
        }
    }
}

void PoseTest::isContinuousEverywhere() {
    QFETCH(int, mode);
    QFETCH(bool, closed);
    std::mt19937 random(12);
    const SkeletonPtr skeleton = makeChain(4);
    Object object = animated(skeleton, {makeRandomClip(random, 4, 7, closed)});
    object.playback.loop = static_cast<LoopMode>(mode);
    // Keys are of order 1 apart and 1/24 s long, so a step of 1e-5 s moves nothing by more than about 1e-3; a
    // pop would be of order 1. Steps cross every key and every end of the clip many times.
    constexpr double step = 1e-5;
    for (int key = -60; key <= 60; ++key)
        for (const double beside : {-0.5, 0.0, 0.5}) {
            const double at = (key + beside) / 24.0;
            QVERIFY(distance(poseOf(object, at - step), poseOf(object, at + step)) < 5e-3);
        }
}

void PoseTest::repeatedLastKeyIsNotShownTwice() {
    std::mt19937 random(13);
    const SkeletonPtr skeleton = makeChain(3);
    const Object object = animated(skeleton, {makeRandomClip(random, 3, 9, true)});
    const Clip& clip = *object.clips[0];
    QCOMPARE(framesToRepeat(clip), 8);
    QCOMPARE(playingSeconds(clip, object.playback), 8 / 24.0);
    // It moves all the time, at the end of a round too.
    for (int i = 0; i < 200; ++i) {
        const double at = i / 97.0;
        QVERIFY(distance(poseOf(object, at), poseOf(object, at + 0.004)) > 1e-3);
    }
    // A round later it is where it was.
    for (int i = 0; i < 50; ++i)
        QVERIFY(distance(poseOf(object, i / 31.0), poseOf(object, i / 31.0 + 5 * 8 / 24.0)) < 2e-3);
}

void PoseTest::nearlyRepeatedLastKeyCounts() {
    std::mt19937 random(14);
    Clip clip = *makeRandomClip(random, 3, 9, true);
    BonePose& last = clip.tracks[1].frames.back();
    last.translation *= 1.0f + 1e-6f; // six decimals of a text file
    last.rotation = glm::normalize(last.rotation * glm::angleAxis(2e-6f, glm::vec3(0, 1, 0)));
    QCOMPARE(framesToRepeat(clip), 8);
    last.rotation = -last.rotation; // the same rotation
    QCOMPARE(framesToRepeat(clip), 8);
    last.rotation = glm::normalize(last.rotation * glm::angleAxis(0.02f, glm::vec3(0, 1, 0)));
    QCOMPARE(framesToRepeat(clip), 9);
}

void PoseTest::rotationsGoTheShortWay() {
    Clip clip = *clip_;
    clip.frameCount = 2;
    auto& frames = clip.tracks[0].frames;
    frames.resize(2);
    frames[0].rotation = glm::angleAxis(0.2f, glm::vec3(0, 0, 1));
    frames[1].rotation = -glm::angleAxis(0.4f, glm::vec3(0, 0, 1)); // the long way round on the sphere
    const Pose pose = poseAtFrame(*mesh_->skeleton, clip, 0.5);
    QVERIFY(std::abs(glm::angle(pose[1].rotation) - 0.3f) < 1e-4f ||
            std::abs(glm::angle(-pose[1].rotation) - 0.3f) < 1e-4f);
}

void PoseTest::orderOfTimesDoesNotMatter() {
    std::mt19937 random(15);
    const SkeletonPtr skeleton = makeChain(4);
    Object object =
        animated(skeleton, {makeRandomClip(random, 4, 12, false), makeRandomClip(random, 4, 9, true)});
    auto second = std::make_shared<Clip>(*object.clips[1]);
    second->name = "second";
    object.clips[1] = second;
    changeClip(object, "second", 1.0, 0.7);
    std::vector<double> times;
    for (int i = 0; i < 300; ++i)
        times.push_back(static_cast<double>(random() % 3000) / 1000.0);
    std::vector<Pose> forward;
    for (const double at : times)
        forward.push_back(poseOf(object, at));
    for (std::size_t i = times.size(); i-- > 0;)
        QCOMPARE(poseOf(object, times[i]), forward[i]);
}

void PoseTest::heldPoseHasOneKey() {
    Object object = bendingObject();
    object.playback.loop = LoopMode::Once;
    const double end = playingSeconds(*clip_, object.playback);
    QCOMPARE(poseKeyOf(object, end + 1.0), poseKeyOf(object, end + 77.0));
    QCOMPARE(poseKeyOf(object, -1.0), poseKeyOf(object, -9.0));
    QVERIFY(poseKeyOf(object, 0.3) != poseKeyOf(object, 0.31));
    object.clip.clear();
    QCOMPARE(poseKeyOf(object, 0.3), poseKeyOf(object, 0.7));
    object.clip = "a clip that is not there";
    QCOMPARE(poseKeyOf(object, 0.3), PoseKey{});
    object.clip = "bend";
    object.playback.speed = 0.0;
    QCOMPARE(poseKeyOf(object, 0.3), poseKeyOf(object, 0.7));
}

void PoseTest::fadeLeadsFromOneClipToTheOther() {
    std::mt19937 random(16);
    const SkeletonPtr skeleton = makeChain(4);
    const ClipPtr first = makeRandomClip(random, 4, 12, false);
    auto second = std::make_shared<Clip>(*makeRandomClip(random, 4, 12, false));
    second->name = "second";
    Object object = animated(skeleton, {first, second});
    Object onlyFirst = object;
    Object onlySecond = object;
    onlySecond.clip = "second";
    changeClip(object, "second", 2.0, 0.5);
    for (const double at : {-3.0, 0.0, 1.0, 1.99})
        QCOMPARE(poseKeyOf(object, at), poseKeyOf(onlyFirst, at));
    for (const double at : {2.5, 2.51, 9.0})
        QCOMPARE(poseKeyOf(object, at), poseKeyOf(onlySecond, at));
    // Half way it is half way, bone by bone.
    const Pose a = poseOf(onlyFirst, 2.25);
    const Pose b = poseOf(onlySecond, 2.25);
    const Pose middle = poseOf(object, 2.25);
    for (std::size_t i = 0; i < a.size(); ++i)
        QVERIFY(distance(referenceBlend(widened(a[i]), widened(b[i]), 0.5), middle[i]) < 1e-3);
    for (double at = 1.9; at < 2.6; at += 0.001)
        QVERIFY(distance(poseOf(object, at), poseOf(object, at + 1e-5)) < 5e-3);
}

void PoseTest::fadeFromTheBindPose() {
    Object object = bendingObject();
    object.clip.clear();
    changeClip(object, "bend", 1.0, 1.0);
    QCOMPARE(poseOf(object, 0.5), bindPose(*mesh_->skeleton));
    QCOMPARE(poseKeyOf(object, 0.2), poseKeyOf(object, 0.9)); // the bind pose does not move
    changeClip(object, {}, 3.0, 1.0);
    QCOMPARE(poseOf(object, 5.0), bindPose(*mesh_->skeleton));
}

void PoseTest::changingTheClipDoesNotJump() {
    std::mt19937 random(17);
    const SkeletonPtr skeleton = makeChain(4);
    const ClipPtr first = makeRandomClip(random, 4, 12, false);
    auto second = std::make_shared<Clip>(*makeRandomClip(random, 4, 12, false));
    second->name = "second";
    Object object = animated(skeleton, {first, second});
    const Pose before = poseOf(object, 0.77);
    changeClip(object, "second", 0.77, 0.3);
    QVERIFY(distance(before, poseOf(object, 0.77)) < 1e-6);
    changeClip(object, "random", 5.0, 0.0);
    QCOMPARE(object.playback, Playback{});
}

void PoseTest::timesThatAreNoNumbersAreHarmless() {
    for (const double seconds : {std::nan(""), double(INFINITY), -double(INFINITY), 1e300, -1e300, 1e18})
        for (const LoopMode mode : {LoopMode::Loop, LoopMode::Once, LoopMode::PingPong}) {
            Object object = bendingObject();
            object.playback.loop = mode;
            object.playback.fadeSeconds = 1.0;
            for (const BonePose& bone : poseOf(object, seconds))
                QVERIFY(std::isfinite(glm::length(bone.rotation)) &&
                        std::isfinite(glm::length(bone.translation)));
            object.playback.speed = seconds;
            object.playback.offset = seconds;
            for (const BonePose& bone : poseOf(object, 1.0))
                QVERIFY(std::isfinite(glm::length(bone.rotation)) &&
                        std::isfinite(glm::length(bone.translation)));
        }
}

void PoseTest::oddClipsAreHarmless() {
    std::mt19937 random(18);
    const SkeletonPtr skeleton = makeChain(3);
    const auto check = [&](const Clip& clip) {
        for (double frame = -1.0; frame < 8.0; frame += 0.25)
            QCOMPARE(poseAtFrame(*skeleton, clip, frame).size(), std::size_t(3));
        Playback playback;
        for (double at = -3.0; at < 3.0; at += 0.1) {
            const double frame = clipFrame(clip, playback, at);
            QVERIFY(frame >= 0.0 && frame < std::max(1, keyCount(clip)));
        }
    };
    check(Clip{});
    Clip clip = *makeRandomClip(random, 3, 5, false);
    clip.tracks[0].frames.clear();   // a track without keys
    clip.tracks[1].frames.resize(2); // one that is shorter than the clip
    clip.tracks[2].bone = 99;        // one of a bone that is not there
    check(clip);
    clip.frameCount = 0; // then the tracks say it
    QCOMPARE(keyCount(clip), 5);
    check(clip);
    clip.frameCount = 1;
    check(clip);
}

void PoseTest::boundsFollowThePose() {
    Object object = bendingObject();
    object.transform.translation = {3, 4, 5};
    object.transform.rotation = rotationFromEulerDegrees({10, 20, 30});
    for (const double at : {0.0, 0.3, 0.5, 1.2}) {
        const auto matrices = skinningMatrices(*mesh_->skeleton, poseOf(object, at));
        Bounds truth;
        for (std::size_t i = 0; i < mesh_->positions.size(); ++i) {
            glm::dvec4 sum(0.0);
            for (auto k = mesh_->firstInfluence[i]; k < mesh_->firstInfluence[i + 1]; ++k)
                sum +=
                    static_cast<double>(mesh_->influences[k].weight) *
                    (glm::dmat4(matrices[mesh_->influences[k].bone]) * glm::dvec4(mesh_->positions[i], 1.0));
            truth.add(glm::vec3(sum));
        }
        const Bounds bounds = posedBounds(*object.mesh, poseKeyOf(object, at));
        QVERIFY(glm::length(bounds.low - truth.low) < 1e-5f && glm::length(bounds.high - truth.high) < 1e-5f);
        const DBounds world = worldBounds(object, object.transform.matrix(), at);
        const DBounds expected = transformed(bounds, object.transform.matrix());
        QVERIFY(glm::length(world.low - expected.low) < 1e-9);
    }
    QVERIFY(worldBounds(object, object.transform.matrix(), 0.5) != bindPoseBounds(object));
}

QTEST_GUILESS_MAIN(PoseTest)
#include "tst_pose.moc"
