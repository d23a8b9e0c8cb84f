#include "core/animation/bone_places.h"
#include "core/animation/pose.h"
#include "tests/support/test_scenes.h"

#include <QTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Away from the origin, turned and scaled.
Object placedObject() {
    Object object = bendingObject();
    object.clip = "bend";
    object.transform.translation = {1e6, 2.0, 3.0};
    object.transform.rotation = rotationFromEulerDegrees({0.0, 90.0, 0.0});
    object.transform.scale = glm::dvec3(2.0);
    return object;
}

bool isNear(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) < 1e-5;
}

std::vector<BonePlace> placesOf(const Object& object, double seconds) {
    return bonePlaces(object, object.transform.matrix(), seconds);
}

} // namespace

class TestBonePlaces : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void bindPoseIsWhereTheBonesAre();
    void jointsFollowTheSkin();
    void staticObjectsStandStill();
    void nothingWithoutASkeleton();
};

void TestBonePlaces::bindPoseIsWhereTheBonesAre() {
    Object object = placedObject();
    object.clip.clear();
    const auto places = placesOf(object, 0.7);
    QCOMPARE(places.size(), std::size_t{2});
    QVERIFY(isNear(places[0].joint, object.transform.translation));
    QVERIFY(isNear(places[1].joint, object.transform.translation + glm::dvec3(0.0, 0.5, 0.0)));
    QVERIFY(!places[0].tip);
    QVERIFY(places[1].tip);
    QVERIFY(isNear(*places[1].tip, object.transform.translation + glm::dvec3(0.0, 0.75, 0.0)));
}

void TestBonePlaces::jointsFollowTheSkin() {
    // What hangs on one bone alone goes where the skinning matrices take it: so does the place of its joint.
    const Object object = placedObject();
    const Skeleton& skeleton = *object.mesh->skeleton;
    for (const double seconds : {0.0, 0.31, 0.5, 1.23, 17.7}) {
        const auto places = placesOf(object, seconds);
        const auto skinning = skinningMatrices(skeleton, evaluatePose(skeleton, poseKeyOf(object, seconds)));
        const auto moved = [&](std::size_t bone, const glm::vec3& point) {
            return glm::dvec3(object.transform.matrix() *
                              glm::dvec4(skinning[bone] * glm::vec4(point, 1.0f)));
        };
        QVERIFY(isNear(places[1].joint, moved(1, {0.0f, 0.25f, 0.0f})));
        QVERIFY(isNear(*places[1].tip, moved(1, {0.0f, 0.375f, 0.0f})));
    }
    QVERIFY(!isNear(*placesOf(object, 0.5)[1].tip, *placesOf(object, 0.0)[1].tip));
}

void TestBonePlaces::staticObjectsStandStill() {
    Object object = placedObject();
    object.dynamic = false;
    QVERIFY(isNear(*placesOf(object, 0.5)[1].tip, *placesOf(object, 0.0)[1].tip));
}

void TestBonePlaces::nothingWithoutASkeleton() {
    QVERIFY(placesOf(Object{}, 1.0).empty());
    QVERIFY(placesOf(primitiveObject(PrimitiveType::Cube, 1.0, 1), 1.0).empty());
}

QTEST_APPLESS_MAIN(TestBonePlaces)
#include "tst_bone_places.moc"
