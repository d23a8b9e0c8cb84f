#include "core/scene/properties.h"
#include "core/scene/property_tables.h"
#include "core/scene/starter_scene.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <set>

using namespace prizma;

namespace {

/// A value inside of the property's range.
PropertyValue randomValue(const PropertyInfo& info, std::mt19937& random) {
    const double low = std::max(info.minimum, -1000.0);
    const double high = std::min(info.maximum, 1000.0);
    std::uniform_real_distribution<double> number(low, high);
    switch (info.kind) {
    case PropertyKind::Boolean:
        return random() % 2 == 0;
    case PropertyKind::Integer:
        return static_cast<int>(std::floor(number(random)));
    case PropertyKind::Number:
        return number(random);
    case PropertyKind::Text:
        return "text " + std::to_string(random() % 1000);
    case PropertyKind::Choice:
        return std::string(info.choices[random() % info.choices.size()].key);
    case PropertyKind::Vector2:
        return glm::dvec2(number(random), number(random));
    case PropertyKind::Vector3:
    case PropertyKind::Color:
        return glm::dvec3(number(random), number(random), number(random));
    case PropertyKind::Rotation:
        return glm::normalize(glm::dquat(1.0, number(random), number(random), number(random)));
    case PropertyKind::Texture:
        return Texture{"/tmp/t" + std::to_string(random() % 1000) + ".png", nullptr};
    }
    return {};
}

std::vector<EntityRef> allEntities(const Scene& scene) {
    return {{EntityKind::Object, scene.objects[0].id},
            {EntityKind::Light, scene.lights[0].id},
            {EntityKind::Material, scene.materials[0].id},
            {EntityKind::Camera},
            {EntityKind::Background},
            {EntityKind::Timeline},
            {EntityKind::Render}};
}

} // namespace

class TestProperties : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void everyPropertyRoundTrips() {
        std::mt19937 random(7);
        Scene scene = makeStarterScene();
        int count = 0;
        for (int round = 0; round < 20; ++round)
            for (const EntityRef entity : allEntities(scene))
                for (const PropertyInfo& info : properties(scene, entity)) {
                    const PropertyValue value = randomValue(info, random);
                    QVERIFY(prizma::setProperty(scene, entity, info.key, value));
                    const auto back = getProperty(scene, entity, info.key);
                    QVERIFY(back);
                    QVERIFY2(*back == value, std::string(info.key).c_str());
                    ++count;
                }
        QVERIFY(count > 20 * 40);
    }

    void settingOnePropertyLeavesTheOthers() {
        std::mt19937 random(8);
        const Scene before = makeStarterScene();
        for (const EntityRef entity : allEntities(before))
            for (const PropertyInfo& changed : properties(before, entity)) {
                Scene after = before;
                QVERIFY(prizma::setProperty(after, entity, changed.key, randomValue(changed, random)));
                for (const PropertyInfo& other : properties(after, entity))
                    if (other.key != changed.key)
                        QVERIFY2(*getProperty(before, entity, other.key) == other.value,
                                 (std::string(changed.key) + " changed " + std::string(other.key)).c_str());
            }
    }

    void keysAreUniqueAndExplained() {
        const Scene scene = makeStarterScene();
        for (const EntityRef entity : allEntities(scene)) {
            std::set<std::string_view> keys;
            for (const PropertyInfo& info : properties(scene, entity)) {
                QVERIFY(keys.insert(info.key).second);
                QVERIFY(!info.label.empty() && !info.help.empty());
                QVERIFY(info.minimum < info.maximum);
            }
        }
    }

    void numbersAreClamped() {
        Scene scene = makeStarterScene();
        const EntityRef camera{EntityKind::Camera};
        QVERIFY(prizma::setProperty(scene, camera, "fovY", 1e6));
        QCOMPARE(scene.camera.fovY, 170.0);
        QVERIFY(prizma::setProperty(scene, camera, "fovY", -5.0));
        QCOMPARE(scene.camera.fovY, 1.0);
        QVERIFY(prizma::setProperty(scene, {EntityKind::Render}, "samples", 0));
        QCOMPARE(scene.render.samples, 1);
        const EntityRef material{EntityKind::Material, scene.materials[0].id};
        QVERIFY(prizma::setProperty(scene, material, "baseColor", glm::dvec3(2.0, 0.5, -1.0)));
        QVERIFY(scene.materials[0].baseColor == glm::dvec3(1.0, 0.5, 0.0));
    }

    void wrongValuesAreRefused() {
        Scene scene = makeStarterScene();
        const Scene before = scene;
        const EntityRef camera{EntityKind::Camera};
        const EntityRef light{EntityKind::Light, scene.lights[0].id};
        QVERIFY(!prizma::setProperty(scene, camera, "fovY", 40)); // an integer is another type
        QVERIFY(!prizma::setProperty(scene, camera, "fovY", std::string("40")));
        QVERIFY(!prizma::setProperty(scene, camera, "fovY", std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!prizma::setProperty(scene, camera, "position",
                                     glm::dvec3(0.0, std::numeric_limits<double>::infinity(), 0.0)));
        QVERIFY(!prizma::setProperty(scene, camera, "nothing", 1.0));
        QVERIFY(!prizma::setProperty(scene, light, "type", std::string("laser")));
        QVERIFY(!prizma::setProperty(scene, {EntityKind::Light, 9999}, "intensity", 1.0));
        QVERIFY(!getProperty(scene, {EntityKind::Object, 9999}, "name"));
        QVERIFY(properties(scene, {EntityKind::Object, 9999}).empty());
        QVERIFY(scene == before);
    }

    void morphWeightsAreProperties() {
        Scene scene = makeStarterScene();
        const Id id = scene.objects[0].id;
        auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
        for (const char* name : {"smile", "eye.left", "smile", ""}) // two of one name go together
            mesh->morphTargets.push_back({name, {0}, {glm::vec3(1.0f)}, {glm::vec3(0.0f)}});
        scene.objects.edit()[0].mesh = mesh;
        const EntityRef object{EntityKind::Object, id};
        int count = 0;
        for (const PropertyInfo& info : properties(scene, object))
            if (info.key.starts_with("morph:")) {
                QCOMPARE(info.defaultValue, PropertyValue(0.0));
                QCOMPARE(info.value, PropertyValue(0.0));
                ++count;
            }
        QCOMPARE(count, 3);
        const Scene before = scene;
        QVERIFY(prizma::setProperty(scene, object, "morph:smile", 0.25));
        QCOMPARE(*getProperty(scene, object, "morph:smile"), PropertyValue(0.25));
        QCOMPARE(*getProperty(scene, object, "morph:eye.left"), PropertyValue(0.0));
        QVERIFY(prizma::setProperty(scene, object, "morph:smile", 99.0));
        QCOMPARE(*getProperty(scene, object, "morph:smile"), PropertyValue(2.0));
        QVERIFY(!prizma::setProperty(scene, object, "morph:frown", 0.25));
        QVERIFY(!prizma::setProperty(scene, object, "morph:smile", true));
        QVERIFY(!prizma::setProperty(scene, object, "morph:smile", std::nan("")));
        QVERIFY(applyAssignment(scene, "objects." + scene.objects[0].name + ".morph:eye.left=-0.5"));
        QCOMPARE(*getProperty(scene, object, "morph:eye.left"), PropertyValue(-0.5));
        QVERIFY(!applyAssignment(scene, "objects." + scene.objects[0].name + ".morph:eye.right=1"));
        // Back at 0 it is as if it had never been touched.
        QVERIFY(prizma::setProperty(scene, object, "morph:smile", 0.0));
        QVERIFY(prizma::setProperty(scene, object, "morph:eye.left", 0.0));
        QVERIFY(scene == before);
    }

    void clipsAreChosenAmongTheObjectsOwn() {
        Scene scene = makeStarterScene();
        const std::string object = "objects." + scene.objects[0].name;
        QVERIFY(!applyAssignment(scene, object + ".clip=walk"));
        auto clip = std::make_shared<Clip>();
        clip->name = "walk";
        scene.objects.edit()[0].clips = {clip};
        QVERIFY(applyAssignment(scene, object + ".clip=walk"));
        QCOMPARE(scene.objects[0].clip, std::string("walk"));
        const auto refused = applyAssignment(scene, object + ".clip=wlak");
        QVERIFY(!refused && QString::fromStdString(refused.error().message).contains("walk"));
        QVERIFY(!applyAssignment(scene, object + ".fadeFrom=run"));
        QVERIFY(applyAssignment(scene, object + ".clip="));
        QVERIFY(applyAssignment(scene, object + ".clipSpeed=-1.5"));
        QVERIFY(applyAssignment(scene, object + ".loop=pingpong"));
        QVERIFY(applyAssignment(scene, object + ".clipFps=24"));
        QVERIFY(applyAssignment(scene, object + ".fadeSeconds=0.5"));
        const Playback& playback = scene.objects[0].playback;
        QCOMPARE(playback.speed, -1.5);
        QVERIFY(playback.loop == LoopMode::PingPong);
        QCOMPARE(playback.fps, 24.0);
        QCOMPARE(playback.fadeSeconds, 0.5);
        QVERIFY(!applyAssignment(scene, object + ".loop=sideways"));
        // A project may name a clip whose file is lost: it keeps the name.
        QVERIFY(prizma::setProperty(scene, {EntityKind::Object, scene.objects[0].id}, "clip",
                                    std::string("lost")));
    }

    void assignments() {
        Scene scene = makeStarterScene();
        QVERIFY(applyAssignment(scene, "lights.key.intensity=80"));
        QCOMPARE(scene.lights[0].intensity, 80.0);
        QVERIFY(applyAssignment(scene, "camera.position=1,2.5,-3e1"));
        QVERIFY(scene.camera.position == glm::dvec3(1, 2.5, -30));
        QVERIFY(applyAssignment(scene, "objects.ground.visible=false"));
        QVERIFY(!scene.objects[0].visible);
        QVERIFY(applyAssignment(scene, "render.shader=normals"));
        QVERIFY(scene.render.shader == ShaderType::Normals);
        Material dotted;
        dotted.name = "v1.2 floor";
        addMaterial(scene, dotted);
        QVERIFY(applyAssignment(scene, "materials.v1.2 floor.roughness=0.25"));
        QCOMPARE(scene.materials.back().roughness, 0.25);
    }

    void badAssignments() {
        Scene scene = makeStarterScene();
        const Scene before = scene;
        for (const char* bad :
             {"", "=", "camera", "camera=1", "camera.fovY", "camera.fovY=", "camera.fovY=abc",
              "camera.fovY=1,2", "camera.position=1,2", "lights.nobody.intensity=1", "lights.key.nothing=1",
              "objects.ground.visible=1", "camera.fovY=nan", "render.samples=1e99", "rivers.key.intensity=2"})
            QVERIFY2(!applyAssignment(scene, bad), bad);
        QVERIFY(scene == before);
    }
};

QTEST_GUILESS_MAIN(TestProperties)
#include "tst_properties.moc"
