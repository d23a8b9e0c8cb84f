// Ten thousand instances of one mesh: memory of one, right hits, and an edit that stays interactive.
#include "core/reference/reference_tracer.h"
#include "tests/support/pixel_ray.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr int columns = 100;
constexpr std::size_t count = 10000;
constexpr int size = 64;

/// A field of things, all of one mesh, turned this way and that.
Scene field(std::size_t instances, PrimitiveType type = PrimitiveType::Sphere) {
    Scene scene;
    const Id material = addMaterial(scene, lambert());
    Object object = primitiveObject(type, 1.0, material);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> degrees(0.0, 360.0);
    std::vector<Object> objects;
    for (std::size_t i = 0; i < instances; ++i) {
        object.id = scene.newId();
        object.name = "thing " + std::to_string(i);
        object.transform.translation = {2.0 * static_cast<double>(i % columns) - columns, 0.0,
                                        -2.0 * static_cast<double>(i / columns)};
        object.transform.rotation =
            rotationFromEulerDegrees({degrees(random), degrees(random), degrees(random)});
        object.transform.scale = glm::dvec3(0.5 + 0.4 * std::sin(static_cast<double>(i)));
        objects.push_back(object);
    }
    for (const Object& item : objects)
        scene.objects.edit().push_back(item);
    scene.camera = {{0, 12, 20}, {0, 0, -30}, {0, 1, 0}, 50.0};
    scene.render.samples = 1;
    scene.render.shader = ShaderType::Depth;
    return scene;
}

struct Times {
    double drawable = 0.0, plan = 0.0, begin = 0.0;
    RenderPlan made;
};

double since(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

Times bringUp(Renderer& renderer, const Scene& scene) {
    Times times;
    QElapsedTimer timer;
    timer.start();
    const Scene drawn = renderer.drawable(scene);
    times.drawable = since(timer);
    timer.restart();
    times.made = renderer.plan(drawn, size, size);
    times.plan = since(timer);
    timer.restart();
    if (!renderer.begin(times.made, drawn, size, size))
        qFatal("The scene cannot be drawn.");
    times.begin = since(timer);
    while (!renderer.step().value())
        ;
    return times;
}

} // namespace

class ManyInstancesTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void takeTheMemoryOfOneMesh();
    void areHitWhereTheyAre_data();
    void areHitWhereTheyAre();
    void moveInteractively();
};

void ManyInstancesTest::takeTheMemoryOfOneMesh() {
    const auto one = makeRenderer();
    if (!one)
        QSKIP("There is no OpenCL device here.");
    const auto many = makeRenderer();
    const auto bytesFor = [](Renderer& renderer, const Scene& scene) {
        renderer.waitForTrees(scene);
        bringUp(renderer, scene);
        return static_cast<double>(renderer.statistics(false).deviceBytes);
    };
    const double bytesOfOne = bytesFor(*one, field(1));
    const double bytesOfMany = bytesFor(*many, field(count));
    const double perInstance = (bytesOfMany - bytesOfOne) / (count - 1);
    qInfo("%.0f bytes for one, %.0f for %d: %.1f an instance", bytesOfOne, bytesOfMany,
          static_cast<int>(count), perInstance);
    // The instance, its material slot, its share of the top level.
    QVERIFY(perInstance <= sizeof(DeviceInstance) + 4 + sizeof(WideNode));
    QCOMPARE(many->statistics(false).triangles, count * one->statistics(false).triangles);
}

void ManyInstancesTest::areHitWhereTheyAre_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("Wide8") << static_cast<int>(TreeLayout::Wide8);
    QTest::newRow("Binary2") << static_cast<int>(TreeLayout::Binary2);
}

void ManyInstancesTest::areHitWhereTheyAre() {
    QFETCH(int, layout);
    const auto renderer = makeRenderer(static_cast<TreeLayout>(layout));
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    const Scene scene = field(count, PrimitiveType::Cube); // the reference tracer has a copy of each
    renderer->waitForTrees(scene);
    bringUp(*renderer, scene);
    const reference::Tracer tracer(scene);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(0.0, size);
    std::set<Id> seen;
    for (int i = 0; i < 2000; ++i) {
        const double x = place(random);
        const double y = place(random);
        const reference::Ray ray = pixelRay(scene.camera, x, y, size);
        const auto truth = tracer.closestHit(ray);
        if (truth && truth->edgeDistance < 1e-3)
            continue; // may fall to a neighbour
        const auto pick = renderer->pick(x, y, size, size);
        QVERIFY(pick);
        QCOMPARE(pick->object, truth ? scene.objects[truth->object].id : noId);
        seen.insert(pick->object);
    }
    QVERIFY(seen.size() > 200);
}

void ManyInstancesTest::moveInteractively() {
    const auto renderer = makeRenderer();
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = field(count);
    renderer->waitForTrees(scene);
    bringUp(*renderer, scene);
    const auto bytes = static_cast<double>(renderer->statistics(false).deviceBytes);
    for (const bool all : {false, true}) {
        std::vector<double> totals;
        Times last;
        for (int step = 0; step < 5; ++step) {
            auto& objects = scene.objects.edit();
            for (std::size_t i = all ? 0 : count - 1; i < count; ++i)
                objects[i].transform.translation.y += 0.1;
            last = bringUp(*renderer, scene);
            QVERIFY(last.made.find(Stage::TopLevel));
            QVERIFY(!last.made.find(Stage::Geometry) && !last.made.find(Stage::RefitTreeShader));
            totals.push_back(last.drawable + last.plan + last.begin);
        }
        // Another top level may have a few nodes more.
        QVERIFY(static_cast<double>(renderer->statistics(false).deviceBytes) < 1.05 * bytes);
        std::sort(totals.begin(), totals.end());
        qInfo("%s moved: %.1f ms (of the last: drawable %.1f, plan %.1f, begin %.1f)", all ? "all" : "one",
              totals[2], last.drawable, last.plan, last.begin);
        QVERIFY(totals[2] < 250.0); // far from it on a quiet machine
    }
    // Nothing changed: the plan is empty.
    QVERIFY(renderer->plan(renderer->drawable(scene), size, size).isEmpty());
}

QTEST_GUILESS_MAIN(ManyInstancesTest)
#include "tst_many_instances.moc"
