#include "tests/support/tree_walk.h"

#include <QtTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

Mesh randomMesh(std::size_t triangles, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::uniform_real_distribution<float> edge(-0.05f, 0.05f);
    Mesh mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const glm::vec3 a{place(random), place(random), place(random)};
        mesh.positions.push_back(a);
        mesh.positions.push_back(a + glm::vec3(edge(random), edge(random), edge(random)));
        mesh.positions.push_back(a + glm::vec3(edge(random), edge(random), edge(random)));
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

DeviceTree layOut(const Mesh& mesh, TreeLayout layout, const BvhBuildOptions& options = {}) {
    Progress progress;
    return layOutBottomLevel(*buildBvh(mesh, options, progress), mesh, layout);
}

void setBox(DeviceTree& tree, std::size_t index, int child, const Bounds& box) {
    if (tree.layout == TreeLayout::Wide8) {
        for (int axis = 0; axis < 3; ++axis) {
            tree.wideNodes[index].bounds[2 * axis][child] = box.low[axis];
            tree.wideNodes[index].bounds[2 * axis + 1][child] = box.high[axis];
        }
        return;
    }
    BinaryNode& n = tree.binaryNodes[index];
    float* xy = child == 0 ? n.box0xy : n.box1xy;
    xy[0] = box.low.x;
    xy[1] = box.high.x;
    xy[2] = box.low.y;
    xy[3] = box.high.y;
    n.boxesZ[2 * child] = box.low.z;
    n.boxesZ[2 * child + 1] = box.high.z;
}

/// What the refit kernel does, a level after the other.
void refit(DeviceTree& tree, const Mesh& mesh) {
    for (const auto& level : tree.refitLevels)
        for (const std::uint32_t index : level) {
            const std::vector<Child> children = childrenOf(tree, index);
            for (int i = 0; i < static_cast<int>(children.size()); ++i) {
                const Child& child = children[static_cast<std::size_t>(i)];
                if (child.isMissing())
                    continue;
                Bounds box;
                if (child.isLeaf())
                    box = boundsOf(mesh, trianglesOf(tree, child, mesh).value());
                else
                    for (const Child& below : childrenOf(tree, child.reference))
                        box.add(below.box);
                setBox(tree, index, i, box);
            }
        }
}

void moveCorners(DeviceTree& tree, const Mesh& mesh) {
    for (BinaryTriangle& triangle : tree.binaryTriangles) {
        const glm::uvec3 t = mesh.triangles[triangle.primitive];
        for (int axis = 0; axis < 3; ++axis) {
            triangle.a[axis] = mesh.positions[t.x][axis];
            triangle.b[axis] = mesh.positions[t.y][axis];
            triangle.c[axis] = mesh.positions[t.z][axis];
        }
    }
    for (WideLeaf& leaf : tree.wideLeaves)
        for (int lane = 0; lane < 8; ++lane)
            for (int corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    leaf.corner[3 * corner + axis][lane] =
                        mesh.positions[mesh.triangles[leaf.primitive[lane]][corner]][axis];
}

const TreeLayout layouts[] = {TreeLayout::Wide8, TreeLayout::Binary2};

} // namespace

class TestDeviceLayout : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void holdsTheMesh_data();
    void holdsTheMesh();
    void staysShallowForHostileMeshes();
    void holdsAMillionTrianglesAtOnePoint();
    void holdsEachCopyOfATriangle();
    void leavesOutWhatIsNoTriangle();
    void ordersRefitLevels();
    void refitsMovedVertices();
    void fillsWideNodes();
    void hasARootWithoutTriangles();
    void laysOutInstances();
};

void TestDeviceLayout::holdsTheMesh_data() {
    QTest::addColumn<int>("triangles");
    for (const int count : {1, 2, 8, 9, 17, 64, 65, 300, 5000, 40000})
        QTest::addRow("%d triangles", count) << count;
}

void TestDeviceLayout::holdsTheMesh() {
    QFETCH(int, triangles);
    const Mesh mesh = randomMesh(static_cast<std::size_t>(triangles), 3);
    for (const TreeLayout layout : layouts)
        for (const std::uint32_t leafSize : {1u, 3u, 8u}) {
            BvhBuildOptions options;
            options.maxLeafSize = leafSize;
            const DeviceTree tree = layOut(mesh, layout, options);
            QVERIFY(tree.layout == layout);
            QCOMPARE(Walk(tree, mesh).fault(), QString());
        }
}

void TestDeviceLayout::staysShallowForHostileMeshes() {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const float x = std::pow(1.004f, static_cast<float>(i));
        for (const float y : {0.0f, 0.0f, i % 2 == 0 ? 0.0f : 1.0f})
            mesh.positions.emplace_back(x, y, 0.0f);
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    mesh.triangles.insert(mesh.triangles.end(), 20000, glm::uvec3(5, 5, 5)); // points, all at one place
    for (const TreeLayout layout : layouts) {
        const DeviceTree tree = layOut(mesh, layout);
        QVERIFY(tree.depth <= PRIZMA_MAX_TREE_DEPTH);
        QCOMPARE(Walk(tree, mesh).fault(), QString());
    }
}

void TestDeviceLayout::holdsAMillionTrianglesAtOnePoint() {
    Mesh mesh;
    mesh.positions = {{1.5f, -2.0f, 0.25f}, {1.5f, -2.0f, 0.25f}};
    mesh.triangles.assign(1000000, glm::uvec3(0, 1, 0));
    for (const TreeLayout layout : layouts) {
        QElapsedTimer timer;
        timer.start();
        const DeviceTree tree = layOut(mesh, layout);
        QVERIFY2(timer.elapsed() < 10000, "took more than ten seconds");
        QVERIFY(tree.depth <= 24);
        QVERIFY(leafCount(tree) <= (layout == TreeLayout::Wide8 ? 125000u : 1000000u)); // no leaf half empty
        QCOMPARE(Walk(tree, mesh).fault(), QString());
    }
}

void TestDeviceLayout::holdsEachCopyOfATriangle() {
    Mesh mesh = randomMesh(3000, 15);
    const auto once = mesh.triangles;
    for (int copy = 0; copy < 20; ++copy)
        mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    for (const TreeLayout layout : layouts)
        QCOMPARE(Walk(layOut(mesh, layout), mesh).fault(), QString());
}

void TestDeviceLayout::leavesOutWhatIsNoTriangle() {
    std::mt19937 random(17);
    for (int round = 0; round < 10; ++round) {
        Mesh mesh; // of any bits at all
        for (std::uint32_t i = 0; i < 3000; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                std::uint32_t bits[3];
                std::generate(std::begin(bits), std::end(bits), std::ref(random));
                mesh.positions.emplace_back(std::bit_cast<float>(bits[0]), std::bit_cast<float>(bits[1]),
                                            std::bit_cast<float>(bits[2]));
            }
            mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        }
        for (const TreeLayout layout : layouts) {
            const DeviceTree tree = layOut(mesh, layout);
            QVERIFY(tree.depth <= PRIZMA_MAX_TREE_DEPTH);
            std::vector<int> seen(mesh.triangles.size(), 0);
            for (std::size_t i = 0; i < nodeCount(tree); ++i)
                for (const Child& child : childrenOf(tree, i)) {
                    if (!child.isLeaf())
                        continue;
                    const auto triangles = trianglesOf(tree, child, mesh);
                    QVERIFY(triangles);
                    for (const std::uint32_t triangle : *triangles)
                        ++seen.at(triangle);
                }
            for (std::uint32_t i = 0; i < seen.size(); ++i) {
                const Bounds box = triangleBounds(mesh, i);
                bool finite = true;
                for (int axis = 0; axis < 3; ++axis)
                    finite = finite && std::isfinite(box.low[axis]) && std::isfinite(box.high[axis]);
                QCOMPARE(seen[i], finite ? 1 : 0);
            }
        }
    }
}

void TestDeviceLayout::ordersRefitLevels() {
    const Mesh mesh = randomMesh(20000, 5);
    for (const TreeLayout layout : layouts) {
        const DeviceTree tree = layOut(mesh, layout);
        std::vector<int> levelOf(nodeCount(tree), -1);
        for (std::size_t level = 0; level < tree.refitLevels.size(); ++level)
            for (const std::uint32_t index : tree.refitLevels[level]) {
                QCOMPARE(levelOf[index], -1);
                levelOf[index] = static_cast<int>(level);
            }
        for (std::size_t index = 0; index < levelOf.size(); ++index) {
            int highest = -1;
            for (const Child& child : childrenOf(tree, index))
                if (!child.isMissing() && !child.isLeaf())
                    highest = std::max(highest, levelOf[child.reference]);
            QCOMPARE(levelOf[index], highest + 1); // as early as it can be
        }
        QCOMPARE(tree.refitLevels.back(), std::vector<std::uint32_t>{0});
        QCOMPARE(static_cast<int>(tree.refitLevels.size()), tree.depth);
    }
}

void TestDeviceLayout::refitsMovedVertices() {
    Mesh mesh = randomMesh(20000, 7);
    for (const TreeLayout layout : layouts) {
        DeviceTree tree = layOut(mesh, layout);
        Mesh moved = mesh;
        for (std::size_t i = 0; i < moved.positions.size(); ++i) {
            glm::vec3& p = moved.positions[i];
            p = glm::vec3(p.y + std::sin(5.0f * p.x), p.z * 3.0f, p.x) +
                (i % 3 == 0 ? glm::vec3(0.3f) : glm::vec3());
        }
        moveCorners(tree, moved);
        QVERIFY(!Walk(tree, moved).fault().isEmpty()); // the old boxes cannot be right
        refit(tree, moved);
        QCOMPARE(Walk(tree, moved).fault(), QString());
    }
}

void TestDeviceLayout::fillsWideNodes() {
    const Mesh mesh = randomMesh(40000, 9);
    const DeviceTree tree = layOut(mesh, TreeLayout::Wide8);
    std::size_t children = 0;
    for (std::size_t i = 0; i < tree.wideNodes.size(); ++i)
        for (const Child& child : childrenOf(tree, i))
            children += child.isMissing() ? 0 : 1;
    const double average = static_cast<double>(children) / static_cast<double>(tree.wideNodes.size());
    QVERIFY2(average > 5.0, qPrintable(QString("%1 children a node").arg(average)));
    QVERIFY(tree.wideLeaves.size() < mesh.triangles.size() / 4);
}

void TestDeviceLayout::hasARootWithoutTriangles() {
    for (const TreeLayout layout : layouts) {
        const DeviceTree bottom = layOut(Mesh{}, layout);
        QCOMPARE(nodeCount(bottom), std::size_t{1});
        for (const Child& child : childrenOf(bottom, 0))
            QVERIFY(child.isMissing() && child.box.isEmpty());
        QCOMPARE(nodeCount(layOutTopLevel({}, layout)), std::size_t{1});
    }
}

void TestDeviceLayout::laysOutInstances() {
    std::mt19937 random(13);
    std::uniform_real_distribution<float> place(-10.0f, 10.0f);
    for (const std::size_t count : {1, 2, 9, 1000}) {
        std::vector<Bounds> boxes(count);
        for (Bounds& box : boxes) {
            box.low = {place(random), place(random), place(random)};
            box.high = box.low + glm::vec3(1.0f);
        }
        BvhBuildOptions options;
        options.maxLeafSize = 1;
        Progress progress;
        const Bvh bvh = *buildBvh(boxes, options, progress);
        for (const TreeLayout layout : layouts) {
            const DeviceTree tree = layOutTopLevel(bvh, layout);
            QVERIFY(tree.wideLeaves.empty() && tree.binaryTriangles.empty());
            std::vector<int> seen(count, 0);
            for (std::size_t i = 0; i < nodeCount(tree); ++i)
                for (const Child& child : childrenOf(tree, i))
                    if (child.isLeaf()) {
                        const std::uint32_t instance = child.reference & ~PRIZMA_LEAF_BIT;
                        ++seen.at(instance);
                        QVERIFY(child.box == boxes[instance]);
                    }
            QVERIFY(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
        }
    }
}

QTEST_GUILESS_MAIN(TestDeviceLayout)
#include "tst_device_layout.moc"
