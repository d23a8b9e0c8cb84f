#include "core/render/render_plan.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <functional>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Two still objects, a bending one, a light, materials.
Scene makeScene() {
    Scene scene;
    const Id white = addMaterial(scene, lambert());
    addObject(scene, primitiveObject(PrimitiveType::Cube, 1.0, white));
    addObject(scene, primitiveObject(PrimitiveType::Sphere, 1.0, white, {2, 0, 0}));
    addObject(scene, bendingObject());
    Light light;
    light.name = "key";
    addLight(scene, light);
    return scene;
}

/// What a device holds after it has drawn `scene` to its sample limit.
DeviceState drawn(const Scene& scene) {
    DeviceState state;
    state.scene = scene;
    const Hierarchy hierarchy(scene);
    for (const Object& object : scene.objects) {
        if (!isDrawn(hierarchy, object))
            continue;
        state.resident.insert(object.id);
        if (isPosed(object))
            state.poses[object.id] = poseKeyOf(object, scene.timeline.seconds());
    }
    state.anchor = chooseAnchor(std::nullopt, scene.camera);
    state.width = 640;
    state.height = 480;
    state.samples = scene.render.samples;
    return state;
}

RenderPlan planAfter(const Scene& before, const Scene& after) {
    return makePlan(drawn(before), after, 640, 480);
}

std::vector<Stage> stagesOf(const RenderPlan& plan) {
    std::vector<Stage> stages;
    for (const PlannedStage& stage : plan.stages)
        stages.push_back(stage.stage);
    return stages;
}

const std::vector<Stage> newPicture{Stage::GenerateCameraRays, Stage::RayShader, Stage::Display};

std::vector<Stage> then(std::vector<Stage> stages) {
    stages.insert(stages.end(), newPicture.begin(), newPicture.end());
    return stages;
}

} // namespace

class RenderPlanTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void sameSceneNeedsNothing();
    void firstPictureNeedsEverything();
    void nextSampleKeepsThePicture();
    void cameraTouchesNoBuffer();
    void resizeTouchesNoBuffer();
    void lightTouchesLightsOnly();
    void backgroundTouchesItsTableOnly();
    void emissiveObjectsAreLights();
    void poseOfAnEmissiveObjectLeavesTheLights();
    void exposureTouchesDisplayOnly();
    void materialValueTouchesMaterialsOnly();
    void movedObjectTouchesTopLevelOnly();
    void hiddenObjectTouchesTopLevelOnly();
    void hiddenObjectIsNotPosed();
    void timeMovesPosedObjectsOnly();
    void onlyWhatMovesIsPosed();
    void posesThatStandAreLeftAlone();
    void morphWeightPosesItsObject();
    void newTreeKeepsThePicture();
    void newObjectIsUploadedAlone();
    void nameIsNotInThePicture();
    void farCameraMovesTheAnchor();
    void orbitingKeepsTheAnchor();
    void droppedPassRestarts();
};

void RenderPlanTest::sameSceneNeedsNothing() {
    const Scene scene = makeScene();
    QVERIFY(planAfter(scene, scene).isEmpty());
}

void RenderPlanTest::firstPictureNeedsEverything() {
    const Scene scene = makeScene();
    const RenderPlan plan = makePlan({}, scene, 640, 480);
    QVERIFY(plan.restarts);
    QCOMPARE(stagesOf(plan),
             then({Stage::Geometry, Stage::Textures, Stage::Materials, Stage::Lights, Stage::Poses,
                   Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader, Stage::TopLevel,
                   Stage::LightTree, Stage::Background}));
    QCOMPARE(plan.find(Stage::Geometry)->objects.size(), 3u);
    QCOMPARE(plan.find(Stage::Poses)->objects, std::vector<Id>{scene.objects[2].id});
}

void RenderPlanTest::nextSampleKeepsThePicture() {
    const Scene scene = makeScene();
    DeviceState state = drawn(scene);
    state.samples = 5;
    const RenderPlan plan = makePlan(state, scene, 640, 480);
    QVERIFY(!plan.restarts);
    QCOMPARE(stagesOf(plan), newPicture);
}

void RenderPlanTest::cameraTouchesNoBuffer() {
    const Scene before = makeScene();
    Scene after = before;
    after.camera.position.x += 0.5;
    const RenderPlan plan = planAfter(before, after);
    QVERIFY(plan.restarts);
    QCOMPARE(stagesOf(plan), newPicture);
}

void RenderPlanTest::resizeTouchesNoBuffer() {
    const Scene scene = makeScene();
    const RenderPlan plan = makePlan(drawn(scene), scene, 320, 240);
    QVERIFY(plan.restarts);
    QCOMPARE(stagesOf(plan), newPicture);
}

void RenderPlanTest::lightTouchesLightsOnly() {
    const Scene before = makeScene();
    Scene after = before;
    after.lights.edit()[0].intensity = 7.0;
    QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::Lights, Stage::LightTree}));
}

void RenderPlanTest::backgroundTouchesItsTableOnly() {
    const Scene before = makeScene();
    Scene after = before;
    after.background.color.x += 0.1;
    QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::Background}));
    after = before;
    after.background.rotation = 40.0;
    QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::Background}));
}

/// Whatever changes the triangles that shine brings the light tree up to date, and nothing else does.
void RenderPlanTest::emissiveObjectsAreLights() {
    Scene before = makeScene();
    Material lamp = lambert();
    lamp.emission = glm::dvec3(4.0);
    const Id bright = addMaterial(before, lamp);
    const std::size_t material = before.materials.size() - 1;
    before.objects.edit()[0].materials = {bright};
    const auto stagesAfter = [&](const auto& edit) {
        Scene after = before;
        edit(after);
        return stagesOf(planAfter(before, after));
    };
    QCOMPARE(stagesAfter([](Scene& s) { s.objects.edit()[0].transform.translation.x += 1.0; }),
             then({Stage::TopLevel, Stage::LightTree}));
    QCOMPARE(stagesAfter([](Scene& s) { s.objects.edit()[1].transform.translation.x += 1.0; }),
             then({Stage::TopLevel}));
    QCOMPARE(stagesAfter([](Scene& s) { s.objects.edit()[0].visible = false; }),
             then({Stage::TopLevel, Stage::LightTree}));
    QCOMPARE(stagesAfter([](Scene& s) { s.objects.edit()[1].visible = false; }), then({Stage::TopLevel}));
    QCOMPARE(stagesAfter([&](Scene& s) { s.materials.edit()[material].emissionStrength = 2.0; }),
             then({Stage::Materials, Stage::LightTree}));
    QCOMPARE(stagesAfter([&](Scene& s) { s.materials.edit()[material].doubleSided = false; }),
             then({Stage::Materials, Stage::LightTree}));
    QCOMPARE(stagesAfter([&](Scene& s) { s.materials.edit()[material].roughness = 0.2; }),
             then({Stage::Materials}));
    QCOMPARE(stagesAfter([](Scene& s) { s.materials.edit()[0].emission = glm::dvec3(1.0); }),
             then({Stage::Materials, Stage::LightTree}));
    QCOMPARE(stagesAfter([&](Scene& s) { s.objects.edit()[1].materials = {bright}; }),
             then({Stage::TopLevel, Stage::LightTree}));
    QCOMPARE(stagesAfter([](Scene& s) { s.camera.position.x += 0.1; }), newPicture);
}

/// Triangles are sampled where the device's vertices are: the tree has nothing to learn from a pose.
void RenderPlanTest::poseOfAnEmissiveObjectLeavesTheLights() {
    Scene before = makeScene();
    Material lamp = lambert();
    lamp.emission = glm::dvec3(4.0);
    before.objects.edit()[2].materials = {addMaterial(before, lamp)};
    Scene after = before;
    after.timeline.frame = 12.0;
    QCOMPARE(stagesOf(planAfter(before, after)),
             then({Stage::Poses, Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader,
                   Stage::TopLevel}));
}

void RenderPlanTest::exposureTouchesDisplayOnly() {
    const Scene before = makeScene();
    const std::function<void(RenderSettings&)> edits[] = {
        [](RenderSettings& s) { s.exposure = 1.5; },
        [](RenderSettings& s) { s.viewTransform = ViewTransform::Filmic; },
        [](RenderSettings& s) { s.denoise = true; }};
    for (const auto& edit : edits) {
        Scene after = before;
        edit(after.render);
        const RenderPlan plan = planAfter(before, after);
        QVERIFY(!plan.restarts);
        QCOMPARE(stagesOf(plan), std::vector<Stage>{Stage::Display});
    }
}

void RenderPlanTest::materialValueTouchesMaterialsOnly() {
    const Scene before = makeScene();
    Scene after = before;
    after.materials.edit()[0].roughness = 0.1;
    QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::Materials}));
}

void RenderPlanTest::movedObjectTouchesTopLevelOnly() {
    const Scene before = makeScene();
    for (std::size_t i = 0; i < before.objects.size(); ++i) {
        Scene after = before;
        after.objects.edit()[i].transform.translation.y += 1.0;
        QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::TopLevel}));
    }
}

void RenderPlanTest::hiddenObjectTouchesTopLevelOnly() {
    const Scene before = makeScene();
    Scene after = before;
    after.objects.edit()[1].visible = false;
    QCOMPARE(stagesOf(planAfter(before, after)), then({Stage::TopLevel}));
    QCOMPARE(stagesOf(planAfter(after, before)), then({Stage::Geometry, Stage::TopLevel}));
}

void RenderPlanTest::hiddenObjectIsNotPosed() {
    Scene before = makeScene();
    before.objects.edit()[2].visible = false;
    Scene after = before;
    after.timeline.frame = 12.0;
    QVERIFY(planAfter(before, after).isEmpty());
    // Nor is it uploaded, and moving it changes nothing that is seen.
    after.objects.edit()[2].transform.translation.x = 4.0;
    QVERIFY(planAfter(before, after).isEmpty());
}

void RenderPlanTest::timeMovesPosedObjectsOnly() {
    const Scene before = makeScene();
    Scene after = before;
    after.timeline.frame = 12.0;
    const RenderPlan plan = planAfter(before, after);
    QCOMPARE(stagesOf(plan), then({Stage::Poses, Stage::VertexShader, Stage::TriangleShader,
                                   Stage::RefitTreeShader, Stage::TopLevel}));
    for (const Stage stage :
         {Stage::Poses, Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader})
        QCOMPARE(plan.find(stage)->objects, std::vector<Id>{before.objects[2].id});

    Scene still = before;
    still.objects.edit()[2].clip.clear();
    Scene later = still;
    later.timeline.frame = 12.0;
    QVERIFY(planAfter(still, later).isEmpty());
}

/// A hundred objects with clips: the ones whose pose differs, and no others, are posed, skinned and refitted.
void RenderPlanTest::onlyWhatMovesIsPosed() {
    std::mt19937 random(4);
    Scene before;
    for (int i = 0; i < 100; ++i) {
        Object object = bendingObject();
        object.playback.offset = 0.1 * i;
        object.playback.loop = i % 2 == 0 ? LoopMode::Loop : LoopMode::Once;
        addObject(before, object);
    }
    before.timeline.frame = 17.0;
    for (int round = 0; round < 50; ++round) {
        Scene after = before;
        std::vector<Id> touched;
        for (Object& object : after.objects.edit())
            switch (random() % 12) {
            case 0:
                object.clip.clear();
                touched.push_back(object.id);
                break;
            case 1:
                object.playback.offset += 0.013;
                break;
            case 2:
                object.transform.translation.x += 1.0; // is no pose
                break;
            case 3:
                object.playback.fadeStart = 99.0; // there is no fade
                break;
            case 4:
                object.visible = false;
                break;
            default:
                break;
            }
        std::vector<Id> expected;
        for (std::size_t i = 0; i < after.objects.size(); ++i) {
            const Object& object = after.objects[i];
            if (object.visible && poseKeyOf(object, after.timeline.seconds()) !=
                                      poseKeyOf(before.objects[i], before.timeline.seconds()))
                expected.push_back(object.id);
        }
        for (const Id id : touched)
            QVERIFY(std::ranges::count(expected, id) == 1);
        QVERIFY(!expected.empty());
        const RenderPlan plan = planAfter(before, after);
        for (const Stage stage :
             {Stage::Poses, Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader})
            QCOMPARE(plan.find(stage)->objects, expected);
        QVERIFY(!plan.find(Stage::Geometry));
    }
}

void RenderPlanTest::posesThatStandAreLeftAlone() {
    Scene before = makeScene();
    before.objects.edit()[2].playback.loop = LoopMode::Once;
    before.timeline.frame = 600.0; // long after its end
    Scene after = before;
    after.timeline.frame = 700.0;
    QVERIFY(planAfter(before, after).isEmpty());
    after.objects.edit()[2].playback.loop = LoopMode::Loop;
    QVERIFY(planAfter(before, after).find(Stage::VertexShader));
    // Held by its speed.
    before.objects.edit()[2].playback = {};
    before.objects.edit()[2].playback.speed = 0.0;
    after = before;
    after.timeline.frame = 3.0;
    QVERIFY(planAfter(before, after).isEmpty());
}

void RenderPlanTest::morphWeightPosesItsObject() {
    Scene before = makeScene();
    auto mesh = std::make_shared<Mesh>(*before.objects[1].mesh);
    mesh->morphTargets.push_back({"wide", {0}, {glm::vec3(1.0f)}, {glm::vec3(0.0f)}});
    before.objects.edit()[1].mesh = mesh;
    before.objects.edit()[1].dynamic = true;
    Scene after = before;
    after.objects.edit()[1].morphWeights["wide"] = 0.5;
    const RenderPlan plan = planAfter(before, after);
    QCOMPARE(plan.find(Stage::VertexShader)->objects, std::vector<Id>{before.objects[1].id});
    after.objects.edit()[1].morphWeights = {{"a target it lacks", 0.5}};
    QVERIFY(planAfter(before, after).isEmpty());
    after = before;
    after.timeline.frame = 12.0; // morph targets have no time
    QCOMPARE(planAfter(before, after).find(Stage::VertexShader)->objects,
             std::vector<Id>{before.objects[2].id});
}

void RenderPlanTest::newTreeKeepsThePicture() {
    Scene scene = makeScene();
    const Id bender = scene.objects[2].id;
    DeviceState state = drawn(scene);
    state.newTrees = {bender, scene.objects[0].id, noId}; // the others are not posed, or gone
    const RenderPlan plan = makePlan(state, scene, 640, 480);
    QVERIFY(!plan.restarts);
    QCOMPARE(stagesOf(plan), (std::vector<Stage>{Stage::NewTrees, Stage::TriangleShader,
                                                 Stage::RefitTreeShader, Stage::TopLevel}));
    for (const Stage stage : {Stage::NewTrees, Stage::TriangleShader, Stage::RefitTreeShader})
        QCOMPARE(plan.find(stage)->objects, std::vector<Id>{bender});

    state.samples = 5; // the next sample comes with it
    QVERIFY(makePlan(state, scene, 640, 480).find(Stage::RayShader));
    QVERIFY(!makePlan(state, scene, 640, 480).restarts);

    scene.objects.edit()[2].visible = false;
    QVERIFY(!makePlan(state, scene, 640, 480).find(Stage::NewTrees));
}

void RenderPlanTest::newObjectIsUploadedAlone() {
    const Scene before = makeScene();
    Scene after = before;
    const Id added = addObject(after, primitiveObject(PrimitiveType::Torus, 1.0, noId));
    const RenderPlan plan = planAfter(before, after);
    QCOMPARE(stagesOf(plan), then({Stage::Geometry, Stage::TopLevel}));
    QCOMPARE(plan.find(Stage::Geometry)->objects, std::vector<Id>{added});
}

void RenderPlanTest::nameIsNotInThePicture() {
    const Scene before = makeScene();
    Scene after = before;
    after.objects.edit()[0].name = "renamed";
    after.lights.edit()[0].name = "renamed";
    after.materials.edit()[0].name = "renamed";
    QVERIFY(planAfter(before, after).isEmpty());
}

void RenderPlanTest::farCameraMovesTheAnchor() {
    const Scene before = makeScene();
    Scene after = before;
    after.camera.position += glm::dvec3(1e6);
    after.camera.target += glm::dvec3(1e6);
    const RenderPlan plan = planAfter(before, after);
    QCOMPARE(plan.anchor, after.camera.position);
    QCOMPARE(stagesOf(plan), then({Stage::Lights, Stage::TopLevel, Stage::LightTree}));
}

void RenderPlanTest::orbitingKeepsTheAnchor() {
    const Scene scene = makeScene();
    const glm::dvec3 anchor = chooseAnchor(std::nullopt, scene.camera);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const double distance = glm::length(scene.camera.position - scene.camera.target);
    for (int i = 0; i < 100; ++i) {
        Camera camera = scene.camera;
        camera.position = camera.target + distance * glm::normalize(glm::dvec3(normal(random), normal(random),
                                                                               normal(random)));
        QCOMPARE(chooseAnchor(anchor, camera), anchor);
    }
}

void RenderPlanTest::droppedPassRestarts() {
    const Scene scene = makeScene();
    DeviceState state = drawn(scene);
    state.dropped = true;
    QVERIFY(makePlan(state, scene, 640, 480).restarts);
}

QTEST_GUILESS_MAIN(RenderPlanTest)
#include "tst_render_plan.moc"
