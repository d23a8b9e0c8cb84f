#include "core/animation/posed_bounds.h"
#include "core/scene/primitives.h"
#include "core/scene/scene.h"
#include "core/scene/starter_scene.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace prizma;

class TestScene : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void namesStayUnique() {
        Scene scene;
        std::mt19937 random(3);
        const std::vector<std::string> wanted{"bunny", "bunny 2", "bunny 10", "", " ", "2", "a b"};
        std::set<std::string> names;
        for (int i = 0; i < 200; ++i) {
            Light light;
            light.name = wanted[random() % wanted.size()];
            addLight(scene, light);
            QVERIFY(names.insert(scene.lights.back().name).second);
        }
        QCOMPARE(scene.lights.size(), std::size_t(200));
    }

    void aFreeNameIsKept() {
        Scene scene;
        Material material;
        material.name = "glass";
        addMaterial(scene, material);
        addMaterial(scene, material);
        QCOMPARE(scene.materials[0].name, std::string("glass"));
        QCOMPARE(scene.materials[1].name, std::string("glass 2"));
        QVERIFY(scene.findMaterial(std::string("glass 2"))->id == scene.materials[1].id);
    }

    void idsAreNeverUsedAgain() {
        Scene scene;
        std::set<Id> ids;
        for (int i = 0; i < 50; ++i) {
            QVERIFY(ids.insert(addObject(scene, {})).second);
            QVERIFY(ids.insert(addLight(scene, {})).second);
            if (i % 3 == 0)
                scene.objects.edit().pop_back();
        }
    }

    void copiesAreIndependent() {
        CowList<int> first{1, 2, 3};
        CowList<int> second = first;
        QVERIFY(first.shares(second));
        second.edit().push_back(4);
        QVERIFY(!first.shares(second));
        QCOMPARE(first.size(), std::size_t(3));
        QCOMPARE(second.size(), std::size_t(4));
        const CowList<int> third = first;
        first.edit()[0] = 9;
        QCOMPARE(third[0], 1);
        QCOMPARE(first[0], 9);
        QVERIFY(CowList<int>() == CowList<int>{});
    }

    void snapshotsDoNotChange() {
        Scene scene = makeStarterScene();
        const Scene snapshot = scene;
        scene.lights.edit()[0].intensity += 1.0;
        scene.objects.edit()[0].visible = false;
        QVERIFY(snapshot.lights[0].intensity != scene.lights[0].intensity);
        QVERIFY(snapshot.objects[0].visible);
        QVERIFY(snapshot.materials.shares(scene.materials));
    }

    void starterSceneIsComplete() {
        const Scene scene = makeStarterScene();
        QCOMPARE(scene.lights.size(), std::size_t(3));
        QCOMPARE(scene.objects.size(), std::size_t(1));
        QVERIFY(scene.objects[0].mesh);
        QVERIFY(scene.findMaterial(scene.objects[0].materials.at(0)));
    }

    void lightsFitTheModel_data() {
        QTest::addColumn<double>("scale");
        QTest::newRow("tiny") << 1e-4;
        QTest::newRow("metre") << 1.0;
        QTest::newRow("huge") << 1e6;
    }
    void lightsFitTheModel() {
        QFETCH(double, scale);
        const glm::dvec3 centre(3.0 * scale, -2.0 * scale, scale);
        Scene scene;
        addThreeLights(scene, {centre - scale, centre + scale});
        QCOMPARE(scene.lights.size(), std::size_t(3));
        // A white diffuse surface that faces the key light shows I / d² / π.
        const Light& key = scene.lights[0];
        const glm::dvec3 offset = key.position - centre;
        const double radiance = key.intensity / glm::dot(offset, offset) / std::numbers::pi;
        QVERIFY(std::abs(radiance - 0.8) < 1e-6);
        for (const Light& light : scene.lights) {
            QVERIFY(glm::length(light.position - centre) > 2.0 * scale);
            QVERIFY(light.position.y > centre.y);
        }
    }

    void presentedModelFillsThePicture() {
        for (const double scale : {1e-3, 1.0, 1e5}) {
            Scene scene;
            Object object;
            object.mesh = makePrimitive(PrimitiveType::Cube, 1.0);
            object.transform.scale = glm::dvec3(scale);
            object.transform.translation = glm::dvec3(10.0 * scale);
            addObject(scene, object);
            const double aspect = 16.0 / 9.0;
            presentModel(scene, aspect);
            const DBounds bounds = worldBounds(scene);
            const CameraFrame frame = frameOf(scene.camera);
            double widest = 0.0;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p{(corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                                   (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                                   (corner & 4) != 0 ? bounds.high.z : bounds.low.z};
                const glm::dvec3 d = p - scene.camera.position;
                const double depth = glm::dot(d, frame.forward);
                QVERIFY(depth > 0.0);
                const double half = std::tan(glm::radians(scene.camera.fovY) / 2.0);
                const double y = glm::dot(d, frame.up) / depth / half;
                const double x = glm::dot(d, frame.right) / depth / half / aspect;
                QVERIFY(std::abs(x) <= 1.0 && std::abs(y) <= 1.0);
                widest = std::max({widest, std::abs(x), std::abs(y)});
            }
            QVERIFY(widest > 0.4);
            const glm::dvec3 from = scene.camera.position - scene.camera.target;
            QVERIFY(from.x > 0.0 && from.y > 0.0 && from.z > 0.0); // right, above, front
        }
    }

    void presentingNothingIsSafe() {
        Scene scene;
        presentModel(scene, 1.5);
        QCOMPARE(scene.lights.size(), std::size_t(3));
        QVERIFY(std::isfinite(glm::length(scene.camera.position)));
    }
};

QTEST_GUILESS_MAIN(TestScene)
#include "tst_scene.moc"
