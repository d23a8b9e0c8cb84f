#include "tests/support/bvh_check.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <thread>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A tree of halves about the median along the widest axis, to compare costs with.
Bvh medianTree(const Boxes& boxes, std::uint32_t leafSize) {
    Bvh bvh;
    bvh.primitives.resize(boxes.size());
    std::iota(bvh.primitives.begin(), bvh.primitives.end(), 0u);
    bvh.nodes.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        BvhNode node = bvh.nodes[i];
        const auto begin = bvh.primitives.begin() + node.first;
        std::for_each(begin, begin + node.count, [&](std::uint32_t p) { node.bounds.add(boxes[p]); });
        if (node.count > leafSize) {
            const glm::vec3 extent = node.bounds.extent();
            const int axis =
                extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
            const std::uint32_t half = node.count / 2;
            std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t a, std::uint32_t b) {
                return boxes[a].centre()[axis] < boxes[b].centre()[axis];
            });
            const auto child = static_cast<std::uint32_t>(bvh.nodes.size());
            bvh.nodes.push_back({{}, node.first, half});
            bvh.nodes.push_back({{}, node.first + half, node.count - half});
            node.first = child;
            node.count = 0;
        }
        bvh.nodes[i] = node;
    }
    return bvh;
}

} // namespace

class TestBvh : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void holdsEveryPrimitiveOnce_data();
    void holdsEveryPrimitiveOnce();
    void survivesHostileInput_data();
    void survivesHostileInput();
    void leavesOutWhatIsNotABox();
    void survivesRandomBits();
    void keepsToSmallDepths();
    void honoursLeafOptions();
    void isCheaperThanMedianSplits();
    void isTheSameEachTime();
    void agreesWithTheMeshesBoxes();
    void reportsProgress();
    void canBeCancelled();
};

void TestBvh::holdsEveryPrimitiveOnce_data() {
    QTest::addColumn<int>("count");
    // Around the sizes where leaves, tasks and blocks of the builder begin.
    for (const int count : {0, 1, 2, 7, 8, 9, 16, 17, 100, 1000, 4096, 4097, 8192, 8193, 16385, 100000})
        QTest::addRow("%d boxes", count) << count;
}

void TestBvh::holdsEveryPrimitiveOnce() {
    QFETCH(int, count);
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Boxes boxes = randomBoxes(static_cast<std::size_t>(count), seed, seed == 3 ? 0.5f : 0.01f);
        QCOMPARE(faultOf(build(boxes), boxes, boxes.size(), {}), QString());
    }
}

void TestBvh::survivesHostileInput_data() {
    QTest::addColumn<Boxes>("boxes");
    const auto point = [](float x, float y, float z) { return Bounds{{x, y, z}, {x, y, z}}; };
    Boxes boxes(1000000, Bounds{{1, 2, 3}, {1.5f, 2.5f, 3.5f}});
    QTest::newRow("a million at one place") << boxes;

    boxes.assign(30000, {});
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = Bounds{glm::vec3(-static_cast<float>(i + 1)), glm::vec3(static_cast<float>(i + 1))};
    QTest::newRow("shells around one centre") << boxes;

    boxes.clear();
    for (int copies = 0; copies < 100; ++copies)
        for (int i = -120; i <= 120; ++i)
            boxes.push_back(point(std::ldexp(1.0f, i), 0, 0));
    QTest::newRow("collinear, growing exponentially") << boxes;

    boxes.clear();
    for (int i = 0; i < 50000; ++i) {
        const float x = std::pow(1.0015f, static_cast<float>(i));
        boxes.push_back(point(x, std::min(x * x, 1e30f), 1 / x));
    }
    QTest::newRow("a curve with ever larger gaps") << boxes;

    boxes = randomBoxes(20000, 5);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const int axis = static_cast<int>(i % 3);
        boxes[i].low[axis] = -1000.0f;
        boxes[i].high[axis] = 1000.0f;
    }
    QTest::newRow("needles across the whole scene") << boxes;

    for (Bounds& box : boxes)
        box.low.y = box.high.y = 7.0f;
    QTest::newRow("all in a plane") << boxes;

    boxes.assign(5000, {});
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = i % 2 == 0 ? Bounds{glm::vec3(-3e38f), glm::vec3(3e38f)} : point(3e38f, -3e38f, 0.0f);
    QTest::newRow("as large as floats get") << boxes;

    boxes = randomBoxes(5000, 6);
    for (Bounds& box : boxes) {
        box.low *= 1e-42f;
        box.high = box.low;
    }
    QTest::newRow("denormal numbers") << boxes;

    boxes = randomBoxes(50000, 7);
    boxes[12345] = point(1e30f, 1e30f, 1e30f);
    QTest::newRow("one far away") << boxes;
}

void TestBvh::survivesHostileInput() {
    QFETCH(Boxes, boxes);
    QElapsedTimer timer;
    timer.start();
    const Bvh bvh = build(boxes);
    QVERIFY2(timer.elapsed() < 10000, "took more than ten seconds");
    QCOMPARE(faultOf(bvh, boxes, boxes.size(), {}), QString());
    const double cost = sahCost(bvh, {});
    QVERIFY(cost >= 1.0 && std::isfinite(cost));
}

void TestBvh::leavesOutWhatIsNotABox() {
    for (const std::size_t count : {std::size_t{10}, std::size_t{30000}}) {
        Boxes boxes = randomBoxes(count, 11);
        const Bounds faults[] = {Bounds{},
                                 {{notANumber, 0, 0}, {1, 1, 1}},
                                 {{0, 0, 0}, {1, notANumber, 1}},
                                 {{0, -infinity, 0}, {1, 1, 1}},
                                 {{0, 0, 0}, {1, 1, infinity}},
                                 {{0, 0, 1}, {1, 1, 0}}};
        std::size_t left = count;
        for (std::size_t i = 1; i < count; i += 3, --left)
            boxes[i] = faults[i % std::size(faults)];
        const Bvh bvh = build(boxes);
        QCOMPARE(faultOf(bvh, boxes, left, {}), QString());
        QVERIFY(
            std::none_of(bvh.primitives.begin(), bvh.primitives.end(), [](auto i) { return i % 3 == 1; }));
    }
    QCOMPARE(faultOf(build(Boxes(100)), {}, 0, {}), QString());
}

void TestBvh::survivesRandomBits() {
    std::mt19937 random(17);
    for (int round = 0; round < 20; ++round) {
        Boxes boxes(3000);
        std::size_t usable = 0;
        for (Bounds& box : boxes) {
            std::uint32_t bits[6];
            std::generate(std::begin(bits), std::end(bits), std::ref(random));
            std::memcpy(&box.low, bits, sizeof box.low);
            std::memcpy(&box.high, bits + 3, sizeof box.high);
            if (round % 2 == 0) // else hardly one is not inside out
                for (int axis = 0; axis < 3; ++axis)
                    if (box.low[axis] > box.high[axis])
                        std::swap(box.low[axis], box.high[axis]);
            bool finite = !box.isEmpty();
            for (int axis = 0; axis < 3; ++axis)
                finite = finite && std::isfinite(box.low[axis]) && std::isfinite(box.high[axis]);
            usable += finite ? 1 : 0;
        }
        QCOMPARE(faultOf(build(boxes), boxes, usable, {}), QString());
    }
}

void TestBvh::keepsToSmallDepths() {
    Boxes boxes;
    for (int i = 0; i < 4000; ++i) {
        const float x = std::pow(1.04f, static_cast<float>(i % 2000));
        boxes.push_back({{x, 0, 0}, {x, 1, 1}});
    }
    for (const int depth : {9, 10, 12, 16, 30}) { // 4000 / 8 leaves need 9 levels
        BvhBuildOptions options;
        options.maxDepth = depth;
        QCOMPARE(faultOf(build(boxes, options), boxes, boxes.size(), options), QString());
    }
}

void TestBvh::honoursLeafOptions() {
    const Boxes boxes = randomBoxes(5000, 21);
    for (const std::uint32_t size : {1u, 2u, 4u, 8u})
        for (const std::uint32_t width : {1u, 4u, 8u}) {
            BvhBuildOptions options;
            options.maxLeafSize = size;
            options.leafWidth = width;
            QCOMPARE(faultOf(build(boxes, options), boxes, boxes.size(), options), QString());
        }
    // Boxes that all cover one another are not worth a node if a leaf holds them.
    const Boxes same(8, Bounds{{0, 0, 0}, {1, 1, 1}});
    QCOMPARE(build(same).nodes.size(), std::size_t{1});
    // Free nodes split all that can be told apart.
    BvhBuildOptions eager;
    eager.traversalCost = 0.01f;
    const Bvh fine = build(boxes, eager);
    QVERIFY(fine.nodes.size() > build(boxes).nodes.size());
}

void TestBvh::isCheaperThanMedianSplits() {
    // A dense cluster, a sparse cloud and a few large boxes: what SAH is there for.
    Boxes boxes = randomBoxes(20000, 31);
    for (std::size_t i = 0; i < 15000; ++i) {
        boxes[i].low = boxes[i].low * 0.02f;
        boxes[i].high = boxes[i].low + glm::vec3(0.0005f);
    }
    for (std::size_t i = 15000; i < 15100; ++i)
        boxes[i].high = boxes[i].low + glm::vec3(0.5f, 0.01f, 0.5f);
    const double median = sahCost(medianTree(boxes, 8), {});
    const double binned = sahCost(build(boxes), {});
    QVERIFY2(binned < 0.75 * median, qPrintable(QString("%1 against %2").arg(binned).arg(median)));

    // Evenly spread boxes leave little to gain, but nothing may be lost either.
    const Boxes even = randomBoxes(20000, 32);
    QVERIFY(sahCost(build(even), {}) < 1.02 * sahCost(medianTree(even, 8), {}));
}

void TestBvh::isTheSameEachTime() {
    const Boxes boxes = randomBoxes(60000, 41);
    const Bvh first = build(boxes);
    for (int i = 0; i < 3; ++i)
        QVERIFY(areEqual(build(boxes), first));
}

void TestBvh::agreesWithTheMeshesBoxes() {
    Mesh mesh;
    std::mt19937 random(51);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        for (int corner = 0; corner < 3; ++corner)
            mesh.positions.emplace_back(place(random), place(random), place(random));
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    mesh.positions[3].y = notANumber; // triangle 1, whichever corner
    mesh.positions[3 * 7 + 1].x = notANumber;
    mesh.positions[3 * 9 + 2].z = -infinity;
    Boxes boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            boxes[i].add(mesh.positions[3 * i + static_cast<std::size_t>(corner)]);
    Progress progress;
    const auto bvh = buildBvh(mesh, {}, progress);
    QVERIFY(bvh.has_value());
    QCOMPARE(faultOf(*bvh, boxes, boxes.size() - 3, {}), QString());
}

void TestBvh::reportsProgress() {
    Progress progress;
    QVERIFY(buildBvh(randomBoxes(50000, 61), {}, progress).has_value());
    QCOMPARE(progress.fraction(), 1.0);
}

void TestBvh::canBeCancelled() {
    Progress early;
    early.cancel();
    const auto none = buildBvh(randomBoxes(1000, 71), {}, early);
    QVERIFY(!none.has_value());
    QVERIFY(!none.error().message.empty());

    const Boxes boxes = randomBoxes(2000000, 72);
    Progress progress;
    std::jthread canceller([&] {
        while (progress.fraction() < 0.02)
            std::this_thread::yield();
        progress.cancel();
    });
    QVERIFY(!buildBvh(boxes, {}, progress).has_value());
    QVERIFY(progress.fraction() < 0.9);
}

QTEST_GUILESS_MAIN(TestBvh)
#include "tst_bvh.moc"
