#include "core/scene/camera_motion.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace prizma;

namespace {

constexpr double pi = std::numbers::pi;

class Dice {
  public:
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
    glm::dvec3 vector(double size) {
        return {between(-size, size), between(-size, size), between(-size, size)};
    }

    /// Any sound camera, near the origin or far from it, its up vector upright or tilted.
    Camera camera() {
        Camera camera;
        const double scale = std::pow(10.0, between(-2.0, 4.0));
        camera.target = vector(scale);
        do
            camera.position = camera.target + vector(scale);
        while (glm::length(camera.position - camera.target) < 0.01 * scale);
        if (between(0.0, 1.0) < 0.3)
            camera.up = glm::normalize(glm::dvec3(0, 1, 0) + vector(0.5)) * between(0.1, 10.0);
        camera.fovY = between(10.0, 120.0);
        return camera;
    }

    glm::dvec2 place() { return {between(-1.7, 1.7), between(-1.0, 1.0)}; }

  private:
    std::mt19937 engine_{20190514};
};

double distanceOf(const Camera& camera) {
    return glm::length(camera.position - camera.target);
}

/// How far two points are apart, against the size of the numbers they are made of.
double apart(const glm::dvec3& a, const glm::dvec3& b, double scale) {
    return glm::length(a - b) / scale;
}

double scaleOf(const Camera& camera) {
    return std::max({glm::length(camera.position), glm::length(camera.target), distanceOf(camera)});
}

double elevationOf(const Camera& camera) {
    return std::asin(glm::dot(glm::normalize(camera.position - camera.target), glm::normalize(camera.up)));
}

bool isFinite(const Camera& camera) {
    for (const glm::dvec3& v : {camera.position, camera.target, camera.up})
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(v[i]))
                return false;
    return std::isfinite(camera.fovY);
}

} // namespace

class TestCameraMotion : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void orbitKeepsTheDistanceAndTheHorizon();
    void orbitTurnsByTheGivenAngles();
    void orbitThereAndBackIsNoMotion();
    void orbitStopsAtThePoles();
    void orbitFromAPoleDoesNotFlipThePicture();
    void panKeepsTheViewDirection();
    void panMovesWhatIsUnderThePointerAlong();
    void zoomKeepsTheAnchorInItsPlace();
    void zoomInAndOutIsNoMotion();
    void zoomNeverReachesTheTarget();
    void viewsLookFromTheirSide();
    void lookAtPutsTheTargetInTheMiddle();
    void placesAndPointsAreInverse();
    void brokenCamerasGiveSoundOnes();
};

void TestCameraMotion::orbitKeepsTheDistanceAndTheHorizon() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const Camera after = orbit(before, dice.between(-7, 7), dice.between(-4, 4));
        QVERIFY(std::abs(distanceOf(after) - distanceOf(before)) < 1e-9 * scaleOf(before));
        QCOMPARE(after.target, before.target);
        QCOMPARE(after.up, before.up);
        // No roll: the picture's horizontal is perpendicular to the up vector.
        QVERIFY(std::abs(glm::dot(frameOf(after).right, glm::normalize(after.up))) < 1e-6);
    }
}

void TestCameraMotion::orbitTurnsByTheGivenAngles() {
    Camera camera;
    camera.position = {0, 0, 5};
    camera.target = {0, 0, 0};
    QVERIFY(apart(orbit(camera, pi / 2, 0).position, {5, 0, 0}, 5) < 1e-12);
    QVERIFY(apart(orbit(camera, -pi / 2, 0).position, {-5, 0, 0}, 5) < 1e-12);
    QVERIFY(apart(orbit(camera, 0, pi / 4).position, glm::dvec3(0, 1, 1) * 5.0 / std::sqrt(2.0), 5) < 1e-12);
}

void TestCameraMotion::orbitThereAndBackIsNoMotion() {
    Dice dice;
    int kept = 0;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const double azimuth = dice.between(-3, 3);
        const double elevation = dice.between(-0.5, 0.5);
        if (std::abs(elevationOf(before) + elevation) > 1.5 || std::abs(elevationOf(before)) > 1.5)
            continue; // Meets the stop at the pole.
        ++kept;
        const Camera back = orbit(orbit(before, azimuth, elevation), -azimuth, -elevation);
        QVERIFY(apart(back.position, before.position, scaleOf(before)) < 1e-9);
    }
    QVERIFY(kept > 1000);
}

void TestCameraMotion::orbitStopsAtThePoles() {
    Dice dice;
    for (int i = 0; i < 500; ++i) {
        Camera camera = dice.camera();
        const double direction = i % 2 ? 1.0 : -1.0;
        camera = orbit(camera, 0.0, direction * dice.between(3.2, 20.0));
        QVERIFY(std::abs(elevationOf(camera) - direction * pi / 2) < 0.001);
        const glm::dvec3 right = frameOf(camera).right;
        const Camera further = orbit(camera, 0.0, direction * 0.3);
        QVERIFY(glm::dot(frameOf(further).right, right) > 0.999);
    }
}

void TestCameraMotion::orbitFromAPoleDoesNotFlipThePicture() {
    for (const double side : {1.0, -1.0}) {
        Camera camera;
        camera.target = {1, 2, 3};
        camera.position = camera.target + glm::dvec3(0, side * 4, 0);
        const Camera after = orbit(camera, 0.0, -side * 0.01);
        QVERIFY(glm::dot(frameOf(after).right, frameOf(camera).right) > 0.999);
        QVERIFY(glm::dot(frameOf(after).up, frameOf(camera).up) > 0.999);
    }
}

void TestCameraMotion::panKeepsTheViewDirection() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const Camera after = pan(before, dice.place(), dice.between(0.01, 3.0) * distanceOf(before));
        QVERIFY(apart(after.target - after.position, before.target - before.position, scaleOf(before)) <
                1e-9);
        QVERIFY(std::abs(glm::dot(after.position - before.position, frameOf(before).forward)) <
                1e-9 * scaleOf(before));
    }
}

void TestCameraMotion::panMovesWhatIsUnderThePointerAlong() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const double depth = dice.between(0.1, 3.0) * distanceOf(before);
        const glm::dvec2 from = dice.place();
        const glm::dvec2 to = dice.place();
        const glm::dvec3 grabbed = pointInPicture(before, from, depth);
        const auto place = placeInPicture(pan(before, to - from, depth), grabbed);
        QVERIFY(place.has_value());
        QVERIFY(glm::length(*place - to) < 1e-6);
    }
}

void TestCameraMotion::zoomKeepsTheAnchorInItsPlace() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const glm::dvec2 cursor = dice.place();
        const glm::dvec3 anchor = pointInPicture(before, cursor, dice.between(0.1, 5.0) * distanceOf(before));
        const double factor = dice.between(0.2, 5.0);
        const Camera after = zoom(before, factor, anchor);
        const auto place = placeInPicture(after, anchor);
        QVERIFY(place.has_value());
        QVERIFY(glm::length(*place - cursor) < 1e-6);
        QVERIFY(std::abs(depthOf(after, anchor) - factor * depthOf(before, anchor)) < 1e-9 * scaleOf(before));
        QVERIFY(glm::dot(frameOf(after).forward, frameOf(before).forward) > 1.0 - 1e-9);
    }
}

void TestCameraMotion::zoomInAndOutIsNoMotion() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera before = dice.camera();
        const glm::dvec3 anchor = pointInPicture(before, dice.place(), distanceOf(before));
        const double factor = dice.between(0.5, 2.0);
        const Camera back = zoom(zoom(before, factor, anchor), 1.0 / factor, anchor);
        QVERIFY(apart(back.position, before.position, scaleOf(before)) < 1e-9);
        QVERIFY(apart(back.target, before.target, scaleOf(before)) < 1e-9);
    }
}

void TestCameraMotion::zoomNeverReachesTheTarget() {
    Dice dice;
    for (int i = 0; i < 50; ++i) {
        Camera camera = dice.camera();
        for (int step = 0; step < 500; ++step) {
            camera = zoom(camera, 0.8, camera.target);
            QVERIFY(isFinite(camera) && camera.position != camera.target);
        }
        for (int step = 0; step < 1000; ++step)
            camera = zoom(camera, 1.25, camera.target);
        QVERIFY(isFinite(camera) && camera.position != camera.target);
    }
}

void TestCameraMotion::viewsLookFromTheirSide() {
    Dice dice;
    for (int i = 0; i < 200; ++i) {
        const Camera before = dice.camera();
        const CameraFrame front = frameOf(viewFrom(before, ViewDirection::Front));
        const CameraFrame right = frameOf(viewFrom(before, ViewDirection::Right));
        const CameraFrame top = frameOf(viewFrom(before, ViewDirection::Top));
        QVERIFY(front.forward.z < -0.999 && front.right.x > 0.999 && front.up.y > 0.999);
        QVERIFY(right.forward.x < -0.999 && right.right.z < -0.999 && right.up.y > 0.999);
        QVERIFY(top.forward.y < -0.999 && top.right.x > 0.999 && top.up.z < -0.999);
        for (const ViewDirection view : {ViewDirection::Front, ViewDirection::Right, ViewDirection::Top}) {
            const Camera after = viewFrom(before, view);
            QCOMPARE(after.target, before.target);
            QVERIFY(std::abs(distanceOf(after) - distanceOf(before)) < 1e-9 * scaleOf(before));
        }
    }
}

void TestCameraMotion::lookAtPutsTheTargetInTheMiddle() {
    Dice dice;
    for (int i = 0; i < 500; ++i) {
        const Camera before = dice.camera();
        const glm::dvec3 target = pointInPicture(before, dice.place(), distanceOf(before));
        const Camera after = lookAt(before, target);
        QCOMPARE(after.position, before.position);
        const auto place = placeInPicture(after, target);
        QVERIFY(place.has_value());
        QVERIFY(glm::length(*place) < 1e-9);
    }
}

void TestCameraMotion::placesAndPointsAreInverse() {
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
        const Camera camera = dice.camera();
        const glm::dvec2 place = dice.place();
        const double depth = dice.between(0.1, 10.0) * distanceOf(camera);
        const glm::dvec3 point = pointInPicture(camera, place, depth);
        const auto back = placeInPicture(camera, point);
        QVERIFY(back.has_value());
        QVERIFY(glm::length(*back - place) < 1e-6);
        QVERIFY(std::abs(depthOf(camera, point) - depth) < 1e-9 * scaleOf(camera) * 10.0);
    }
    const Camera camera;
    QVERIFY(!placeInPicture(camera, camera.position));
    QVERIFY(!placeInPicture(camera, camera.position - frameOf(camera).forward));
}

void TestCameraMotion::brokenCamerasGiveSoundOnes() {
    Dice dice;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double bad[] = {0.0, -0.0, 1.0, 1e-320, 1e300, -1e300, infinity, std::nan("")};
    const auto any = [&] {
        const auto index = static_cast<std::size_t>(dice.between(0.0, 7.999));
        return bad[index];
    };
    const auto vector = [&] { return glm::dvec3(any(), any(), any()); };
    for (int i = 0; i < 20000; ++i) {
        Camera camera;
        camera.position = vector();
        camera.target = dice.between(0, 1) < 0.3 ? camera.position : vector();
        camera.up = vector();
        camera.fovY = any();
        const double depth = dice.between(0, 1) < 0.5 ? any() : 1.0;
        QVERIFY(isFinite(mended(camera)));
        QVERIFY(mended(camera).position != mended(camera).target);
        QVERIFY(isFinite(orbit(camera, any(), any())));
        QVERIFY(isFinite(pan(camera, {any(), any()}, depth)));
        QVERIFY(isFinite(zoom(camera, any(), vector())));
        QVERIFY(isFinite(lookAt(camera, vector())));
        QVERIFY(isFinite(viewFrom(camera, ViewDirection::Top)));
    }
    // What is sound is left alone.
    for (int i = 0; i < 100; ++i) {
        const Camera camera = dice.camera();
        QVERIFY(mended(camera) == camera);
    }
}

QTEST_GUILESS_MAIN(TestCameraMotion)
#include "tst_camera_motion.moc"
