#include "core/bvh/reinsertion.h"

#include "core/bvh/collapse.h"
#include "tests/support/bvh_check.h"

#include <QtTest>

#include <tbb/global_control.h>

#include <cmath>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Things of many small boxes each, one in the other's way, in a room of a few large ones: where splitting
/// from the top down goes wrong, since no plane between centroids parts them.
Boxes roomOfThings(std::size_t things, std::size_t boxesEach, unsigned seed) {
    Boxes boxes;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    for (std::size_t thing = 0; thing < things; ++thing) {
        const glm::vec3 centre(place(random), place(random), place(random));
        for (std::size_t i = 0; i < boxesEach; ++i) {
            const glm::vec3 at = centre + 0.3f * glm::vec3(place(random), place(random), place(random));
            boxes.push_back({at, at + glm::vec3(0.004f)});
        }
    }
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 at(place(random), place(random), place(random));
        glm::vec3 extent(0.02f);
        extent[i % 3] = 1.5f;
        boxes.push_back({at, at + extent});
    }
    return boxes;
}

ReinsertionOptions thorough() {
    ReinsertionOptions options;
    options.passes = 4;
    options.share = 1.0f;
    return options;
}

Bvh reinserted(Bvh bvh, const ReinsertionOptions& options = {}) {
    Progress progress;
    return reinsertNodes(bvh, options, progress) ? bvh : Bvh{};
}

} // namespace

class TestReinsertion : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void keepsTheTreeSoundAndNeverCostsMore_data();
    void keepsTheTreeSoundAndNeverCostsMore();
    void findsTheObviousPlace();
    void lowersTheCostOfABinnedTree();
    void keepsToTheDepth();
    void isTheSameOnAnyNumberOfThreads();
    void survivesBoxesOfAnySize();
    void leavesTheTreeAloneWhenCancelled();
};

void TestReinsertion::keepsTheTreeSoundAndNeverCostsMore_data() {
    QTest::addColumn<int>("count");
    for (const int count : {0, 1, 2, 9, 17, 25, 33, 100, 1000, 30000})
        QTest::addRow("%d boxes", count) << count;
}

void TestReinsertion::keepsTheTreeSoundAndNeverCostsMore() {
    QFETCH(int, count);
    for (const unsigned seed : {1u, 2u, 3u, 4u})
        for (const std::uint32_t leafSize : {1u, 8u}) {
            const Boxes boxes = randomBoxes(static_cast<std::size_t>(count), seed, seed == 3 ? 0.7f : 0.02f);
            BvhBuildOptions options;
            options.maxLeafSize = leafSize;
            options.leafWidth = leafSize;
            const Bvh before = build(boxes, options);
            for (const ReinsertionOptions& effort : {ReinsertionOptions{}, thorough()}) {
                const Bvh after = reinserted(before, effort);
                QCOMPARE(faultOf(after, boxes, boxes.size(), options), QString());
                QCOMPARE(after.nodes.size(), before.nodes.size());
                QVERIFY(sahCost(after, options) <= sahCost(before, options) * (1.0 + 1e-6));
            }
        }
}

/// Two pairs of neighbours, each box with one of the other pair.
void TestReinsertion::findsTheObviousPlace() {
    const auto at = [](float x) { return Bounds{{x, 0, 0}, {x + 1, 1, 1}}; };
    const Boxes boxes{at(0), at(100), at(1), at(101)};
    Bvh bvh;
    bvh.depth = 2;
    bvh.primitives = {0, 1, 2, 3};
    bvh.nodes.resize(7);
    for (std::uint32_t i = 0; i < 4; ++i)
        bvh.nodes[3 + i] = {boxes[i], i, 1};
    for (const std::uint32_t i : {2u, 1u, 0u}) {
        bvh.nodes[i] = {bvh.nodes[2 * i + 1].bounds, 2 * i + 1, 0};
        bvh.nodes[i].bounds.add(bvh.nodes[2 * i + 2].bounds);
    }
    BvhBuildOptions options;
    options.maxLeafSize = 1;
    QCOMPARE(faultOf(bvh, boxes, 4, options), QString());
    const double before = sahCost(bvh, options);
    const Bvh after = reinserted(bvh, thorough());
    QCOMPARE(faultOf(after, boxes, 4, options), QString());
    // Three nodes as long as two boxes at most, beside the root.
    QVERIFY2(sahCost(after, options) < 0.6 * before, qPrintable(QString::number(sahCost(after, options))));
}

void TestReinsertion::lowersTheCostOfABinnedTree() {
    const Boxes boxes = roomOfThings(9, 4000, 5);
    const Bvh binned = build(boxes);
    const double before = sahCost(binned, {});
    const double quick = sahCost(reinserted(binned), {});
    const double all = sahCost(reinserted(binned, thorough()), {});
    QVERIFY2(quick < 0.97 * before, qPrintable(QString("%1 of %2").arg(quick).arg(before)));
    QVERIFY2(all < quick, qPrintable(QString("%1 of %2").arg(all).arg(quick)));
}

void TestReinsertion::keepsToTheDepth() {
    const Boxes boxes = roomOfThings(5, 1000, 6);
    for (const int depth : {11, 12, 14, 18}) { // 5060 boxes in leaves of 8 need 10 levels
        BvhBuildOptions options;
        options.maxDepth = depth;
        ReinsertionOptions effort = thorough();
        effort.maxDepth = depth;
        const Bvh before = build(boxes, options);
        const Bvh after = reinserted(before, effort);
        QCOMPARE(faultOf(after, boxes, boxes.size(), options), QString());
        QVERIFY(sahCost(after, options) < sahCost(before, options));
        // One that is deeper than asked for gets no deeper.
        effort.maxDepth = 3;
        QVERIFY(reinserted(before, effort).depth <= before.depth);
    }
}

void TestReinsertion::isTheSameOnAnyNumberOfThreads() {
    const Bvh bvh = build(roomOfThings(9, 3000, 7));
    Bvh single;
    {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
        single = reinserted(bvh, thorough());
    }
    for (int i = 0; i < 3; ++i)
        QVERIFY(areEqual(reinserted(bvh, thorough()), single));
}

void TestReinsertion::survivesBoxesOfAnySize() {
    for (const float scale : {3e38f, 1e30f, 1e-30f, 1e-42f, 0.0f}) {
        Boxes boxes = randomBoxes(3000, 8);
        for (Bounds& box : boxes) {
            box.low *= scale;
            box.high = glm::max(box.low, box.high * scale);
        }
        for (Bounds& box : boxes)
            for (int axis = 0; axis < 3; ++axis) {
                box.low[axis] = std::clamp(box.low[axis], -3e38f, 3e38f);
                box.high[axis] = std::clamp(box.high[axis], -3e38f, 3e38f);
            }
        const Bvh before = build(boxes);
        const Bvh after = reinserted(before, thorough());
        QCOMPARE(faultOf(after, boxes, boxes.size(), {}), QString());
        QVERIFY(std::isfinite(sahCost(after, {})));
    }
    const Boxes same(100000, Bounds{{1, 2, 3}, {1.5f, 2.5f, 3.5f}});
    QCOMPARE(faultOf(reinserted(build(same), thorough()), same, same.size(), {}), QString());
}

void TestReinsertion::leavesTheTreeAloneWhenCancelled() {
    const Bvh before = build(roomOfThings(5, 1000, 9));
    Bvh bvh = before;
    Progress progress;
    progress.cancel();
    QVERIFY(!reinsertNodes(bvh, thorough(), progress));
    QVERIFY(areEqual(bvh, before));
}

QTEST_GUILESS_MAIN(TestReinsertion)
#include "tst_reinsertion.moc"
