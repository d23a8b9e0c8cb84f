// Posed meshes as the device traces them against skinning on the host and the reference tracer, in both
// layouts.
#include "core/animation/pose.h"
#include "core/reference/reference_tracer.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// The object's mesh posed in double precision.
MeshPtr posedOnHost(const Object& object, double seconds) {
    auto posed = std::make_shared<Mesh>(*object.mesh);
    const auto matrices = skinningMatrices(*object.mesh->skeleton,
                                           evaluatePose(*object.mesh->skeleton, poseKeyOf(object, seconds)));
    for (std::size_t i = 0; i < posed->positions.size(); ++i) {
        glm::dvec4 sum(0.0);
        for (auto k = posed->firstInfluence[i]; k < posed->firstInfluence[i + 1]; ++k)
            sum += static_cast<double>(posed->influences[k].weight) *
                   (glm::dmat4(matrices[posed->influences[k].bone]) *
                    glm::dvec4(object.mesh->positions[i], 1.0));
        posed->positions[i] = glm::vec3(sum);
    }
    posed->skeleton = nullptr;
    updateBounds(*posed);
    return posed;
}

Scene twoBenders() {
    Scene scene;
    addObject(scene, bendingObject());
    Object second = bendingObject();
    second.transform.translation = {3, 0.5, -1};
    second.transform.rotation = rotationFromEulerDegrees({20, 40, 60});
    second.transform.scale = {1.0, 1.5, 0.7};
    addObject(scene, second);
    addObject(scene, primitiveObject(PrimitiveType::Plane, 20.0, noId, {0, -2, 0}));
    scene.camera = {{1, 2, 9}, {1, 0, 0}, {0, 1, 0}, 45.0};
    return scene;
}

} // namespace

class SkinningTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void posedHitsEqualTheReference_data();
    void posedHitsEqualTheReference();
    void onlyWhatMovesIsPosedAgain();
};

void SkinningTest::posedHitsEqualTheReference_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("Wide8") << static_cast<int>(TreeLayout::Wide8);
    QTest::newRow("Binary2") << static_cast<int>(TreeLayout::Binary2);
}

void SkinningTest::posedHitsEqualTheReference() {
    QFETCH(int, layout);
    const auto renderer = makeRenderer(static_cast<TreeLayout>(layout));
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = twoBenders();
    scene.render.shader = ShaderType::Depth;
    scene.render.samples = 1;
    std::mt19937 random(3);
    int compared = 0;
    // One renderer through many times, back and forth: refitting must not wear the tree out.
    for (int step = 0; step < 12; ++step) {
        scene.timeline.frame = static_cast<double>(random() % 600) / 10.0;
        OfflineOptions options;
        options.width = options.height = 32;
        QVERIFY(renderOffline(*renderer, scene, options));
        Scene posed = scene;
        for (Object& object : posed.objects.edit())
            if (object.dynamic)
                object.mesh = posedOnHost(object, scene.timeline.seconds());
        const reference::Tracer tracer(posed);
        for (int i = 0; i < 150; ++i) {
            const double x = static_cast<double>(random() % 3200) / 100.0;
            const double y = static_cast<double>(random() % 3200) / 100.0;
            const auto pick = renderer->pick(x, y, 32, 32);
            QVERIFY(pick);
            const CameraFrame frame = frameOf(scene.camera);
            const double half = std::tan(glm::radians(scene.camera.fovY) / 2);
            reference::Ray ray;
            ray.origin = scene.camera.position;
            ray.direction = glm::normalize(frame.forward + frame.right * ((x / 32 * 2 - 1) * half) +
                                           frame.up * ((1 - y / 32 * 2) * half));
            const auto truth = tracer.closestHit(ray);
            if (truth && truth->edgeDistance < 1e-3)
                continue; // may fall to a neighbour
            ++compared;
            QCOMPARE(pick->object, truth ? posed.objects[truth->object].id : noId);
            if (truth)
                QVERIFY(glm::length(pick->position - (ray.origin + ray.direction * truth->t)) < 1e-4);
        }
    }
    QVERIFY(compared > 1000);
}

void SkinningTest::onlyWhatMovesIsPosedAgain() {
    const auto renderer = makeRenderer();
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = twoBenders();
    scene.objects.edit()[1].clip.clear();
    scene.render.samples = 1;
    OfflineOptions options;
    options.width = options.height = 16;
    QVERIFY(renderOffline(*renderer, scene, options));
    scene.timeline.frame = 5.0;
    const Scene drawn = renderer->drawable(scene);
    const RenderPlan plan = renderer->plan(drawn, 16, 16);
    QCOMPARE(plan.find(Stage::VertexShader)->objects, std::vector<Id>{scene.objects[0].id});
    QVERIFY(!plan.find(Stage::Geometry));
}

QTEST_GUILESS_MAIN(SkinningTest)
#include "tst_skinning.moc"
