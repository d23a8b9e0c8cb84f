// Trees that refitting has worn out are built anew in the background: the picture stays the same, rays get
// cheaper.
#include "core/bench/deforming_scene.h"
#include "core/bench/procedural_scene.h"
#include "core/reference/reference_tracer.h"
#include "tests/support/pixel_ray.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <limits>
#include <thread>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr int size = 96;

std::unique_ptr<Renderer> rendererFor(TreeLayout layout, bool renewTrees) {
    RendererOptions options;
    options.layout = layout;
    options.renewTrees = renewTrees;
    return makeRenderer(std::move(options));
}

/// Shards of a room and things, at the end of their flight.
Scene ruinedScene() {
    Scene scene =
        bench::makeFlyingApart(bench::makeProceduralScene(bench::ProceduralForm::OneMesh, 20000), 60, 0.3);
    scene.timeline.frame = bench::flightFrames - 1;
    scene.render.samples = 1;
    return scene;
}

OfflinePicture pictureOf(Renderer& renderer, Scene scene, ShaderType shader) {
    scene.render.shader = shader;
    OfflineOptions options;
    options.width = options.height = size;
    auto picture = renderOffline(renderer, scene, options);
    if (!picture)
        qFatal("%s", picture.error().message.c_str());
    return std::move(*picture);
}

/// Brings the device to the scene; true if new trees came into use.
bool bringUp(Renderer& renderer, const Scene& scene) {
    const Scene drawn = renderer.drawable(scene);
    const RenderPlan plan = renderer.plan(drawn, size, size);
    if (!renderer.begin(plan, drawn, size, size))
        qFatal("The scene cannot be drawn.");
    while (!renderer.step().value())
        ;
    return plan.find(Stage::NewTrees) != nullptr;
}

/// Waits for a new tree and puts it into use.
bool waitForNewTree(Renderer& renderer, const Scene& scene) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < 30000) {
        if (bringUp(renderer, scene))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// How many nodes and leaves a ray visited, from the colour that the view of the traversal's cost shows:
/// black, blue, green, yellow, red and white stand for 0, 20, 40, 60, 80 and 100 or more.
double stepsOf(const glm::dvec3& heat) {
    if (heat.x <= 0.0)
        return 20.0 * (heat.y > 0.0 ? 1.0 + heat.y : heat.z);
    if (heat.x < 1.0)
        return 20.0 * (2.0 + heat.x);
    return 20.0 * (heat.z > 0.0 ? 4.0 + heat.z : 4.0 - heat.y);
}

double meanSteps(const OfflinePicture& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += stepsOf(pixelOf(picture, x, y));
    return sum / (picture.width * picture.height);
}

/// Picks from the renderer's last picture that are not what the reference tracer says, and how many there
/// were.
std::pair<int, int> wrongPicks(Renderer& renderer, const Scene& scene, std::mt19937& random) {
    const Scene still = bench::frozen(scene);
    const reference::Tracer tracer(still);
    std::uniform_real_distribution<double> place(0.0, size);
    int wrong = 0;
    int compared = 0;
    for (int i = 0; i < 100; ++i) {
        const double x = place(random);
        const double y = place(random);
        const reference::Ray ray = pixelRay(scene.camera, x, y, size);
        const auto truth = tracer.closestHit(ray);
        if (truth && truth->edgeDistance < 1e-2)
            continue; // may fall to a neighbour
        const auto pick = renderer.pick(x, y, size, size);
        ++compared;
        const bool agrees =
            pick && (truth ? pick->object != noId &&
                                 glm::length(pick->position - (ray.origin + ray.direction * truth->t)) <
                                     1e-3 * (1.0 + truth->t)
                           : pick->object == noId);
        wrong += agrees ? 0 : 1;
    }
    return {wrong, compared};
}

} // namespace

class WornTreesTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void newTreeShowsTheSameForLess_data();
    void newTreeShowsTheSameForLess();
    void pictureIsRightThroughout_data() { newTreeShowsTheSameForLess_data(); }
    void pictureIsRightThroughout();
    void smallMotionBuildsNothing();
    void poseThatIsNoNumberIsNotBuiltFor();
    void objectMayGoWhileItsTreeIsBuilt();
};

void WornTreesTest::newTreeShowsTheSameForLess_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("Wide8") << static_cast<int>(TreeLayout::Wide8);
    QTest::newRow("Binary2") << static_cast<int>(TreeLayout::Binary2);
}

void WornTreesTest::newTreeShowsTheSameForLess() {
    QFETCH(int, layout);
    const auto worn = rendererFor(static_cast<TreeLayout>(layout), false);
    if (!worn)
        QSKIP("There is no OpenCL device here.");
    const Scene scene = ruinedScene();
    const OfflinePicture wornDepth = pictureOf(*worn, scene, ShaderType::Depth);
    const double wornSteps = meanSteps(pictureOf(*worn, scene, ShaderType::TraversalCost));
    QVERIFY(worn->statistics(false).treeWear > 3.0);
    QVERIFY(!worn->isBuildingTrees());

    const auto renewed = rendererFor(static_cast<TreeLayout>(layout), true);
    pictureOf(*renewed, scene, ShaderType::Normals);
    QVERIFY(waitForNewTree(*renewed, scene));
    const double wear = renewed->statistics(false).treeWear;
    QVERIFY2(wear > 0.99 && wear < 1.01, qPrintable(QString::number(wear)));
    const OfflinePicture depth = pictureOf(*renewed, scene, ShaderType::Depth);
    const double steps = meanSteps(pictureOf(*renewed, scene, ShaderType::TraversalCost));
    qInfo("%.1f steps a camera ray in the worn tree, %.1f in the new one", wornSteps, steps);
    QVERIFY(steps < 0.5 * wornSteps);
    int different = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            different += glm::length(pixelOf(depth, x, y) - pixelOf(wornDepth, x, y)) > 1e-5 ? 1 : 0;
    QCOMPARE(different, 0);
    QVERIFY(!bringUp(*renewed, scene)); // once is enough
}

void WornTreesTest::pictureIsRightThroughout() {
    QFETCH(int, layout);
    const auto renderer = rendererFor(static_cast<TreeLayout>(layout), true);
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = ruinedScene();
    std::mt19937 random(11);
    renderer->waitForTrees(scene);
    int newTrees = 0;
    int compared = 0;
    QElapsedTimer timer;
    timer.start();
    for (int step = 0; step < 60 || (newTrees < 2 && timer.elapsed() < 30000); ++step) {
        scene.timeline.frame = static_cast<double>(random() % (10 * bench::flightFrames)) / 10.0;
        newTrees += bringUp(*renderer, scene) ? 1 : 0;
        const auto [wrong, all] = wrongPicks(*renderer, scene, random);
        QCOMPARE(wrong, 0);
        compared += all;
    }
    QVERIFY(compared > 3000);
    QVERIFY(newTrees >= 2); // back together, a tree of a pose in flight is worn out in turn
}

void WornTreesTest::smallMotionBuildsNothing() {
    const auto renderer = rendererFor(TreeLayout::Wide8, true);
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = bench::makeBending(bench::makeProceduralScene(bench::ProceduralForm::OneMesh, 20000));
    scene.render.samples = 1;
    renderer->waitForTrees(scene);
    for (int frame = 0; frame < 64; ++frame) {
        scene.timeline.frame = frame;
        QVERIFY(!bringUp(*renderer, scene));
        QVERIFY(!renderer->isBuildingTrees());
    }
    QVERIFY(renderer->statistics(false).treeWear < WornTrees::limit);
}

void WornTreesTest::poseThatIsNoNumberIsNotBuiltFor() {
    const auto renderer = rendererFor(TreeLayout::Wide8, true);
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene = ruinedScene();
    Object& object = scene.objects.edit()[0];
    auto broken = std::make_shared<Clip>(*object.clips[0]);
    broken->name = "broken";
    for (BonePose& pose : broken->tracks[3].frames)
        pose.translation.x = std::numeric_limits<float>::quiet_NaN();
    object.clips.push_back(broken);
    object.clip = "broken";
    renderer->waitForTrees(scene);
    for (int i = 0; i < 20; ++i) {
        QVERIFY(!bringUp(*renderer, scene));
        QVERIFY(!renderer->isBuildingTrees());
        scene.timeline.frame -= 0.1;
    }
    QVERIFY(renderer->statistics(false).treeWear > WornTrees::limit);
    // Once it is a pose again, nothing is missing.
    scene.objects.edit()[0].clip = "fly apart";
    QVERIFY(waitForNewTree(*renderer, scene));
    std::mt19937 random(12);
    QCOMPARE(wrongPicks(*renderer, scene, random).first, 0);
}

void WornTreesTest::objectMayGoWhileItsTreeIsBuilt() {
    const auto renderer = rendererFor(TreeLayout::Wide8, true);
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    const Scene scene = ruinedScene();
    renderer->waitForTrees(scene);
    for (int i = 0; i < 10; ++i) {
        bringUp(*renderer, scene);
        Scene without = scene;
        if (i % 3 == 0)
            without.objects.edit().clear();
        else if (i % 3 == 1)
            without.objects.edit()[0].dynamic = false;
        else
            without.objects.edit()[0].visible = false;
        QVERIFY(!bringUp(*renderer, without));
    }
    QVERIFY(waitForNewTree(*renderer, scene));
    std::mt19937 random(13);
    QCOMPARE(wrongPicks(*renderer, scene, random).first, 0);
}

QTEST_GUILESS_MAIN(WornTreesTest)
#include "tst_worn_trees.moc"
