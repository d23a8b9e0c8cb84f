// TriangleShader and RefitTreeShader by themselves: trees on the device, given new vertices, against the
// boxes and costs that the host works out.
#include "core/bvh/tree_cost.h"
#include "core/render/tree_refitter.h"
#include "tests/support/test_scenes.h"
#include "tests/support/tree_walk.h"

#include <QtTest>

#include <limits>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Triangles all over a cube, every vertex skinned to the one bone.
MeshPtr randomSkinnedMesh(std::size_t triangles, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::uniform_real_distribution<float> edge(-0.05f, 0.05f);
    auto mesh = std::make_shared<Mesh>();
    mesh->slots = {"surface"};
    mesh->firstInfluence = {0};
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const glm::vec3 a{place(random), place(random), place(random)};
        for (int corner = 0; corner < 3; ++corner) {
            mesh->positions.push_back(a + glm::vec3(edge(random), edge(random), edge(random)));
            mesh->normals.emplace_back(0.0f, 1.0f, 0.0f);
            mesh->influences.push_back({0, 1.0f});
            mesh->firstInfluence.push_back(static_cast<std::uint32_t>(mesh->influences.size()));
        }
        mesh->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        mesh->triangleSlots.push_back(0);
    }
    auto skeleton = std::make_shared<Skeleton>();
    skeleton->bones = {{"root", -1, {}, glm::mat4(1.0f)}};
    mesh->skeleton = skeleton;
    updateBounds(*mesh);
    return mesh;
}

/// `mesh` turned, stretched and shaken.
Mesh moved(const Mesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> step(-0.2f, 0.2f);
    Mesh result = mesh;
    for (glm::vec3& p : result.positions)
        p = glm::vec3(p.y + 0.3f * std::sin(5.0f * p.x), p.z * 3.0f, p.x) +
            glm::vec3(step(random), step(random), step(random));
    return result;
}

/// A device with posed objects on it.
struct PosedObjects {
    explicit PosedObjects(TreeLayout treeLayout) : layout(treeLayout), geometry(treeLayout) {}

    bool start() {
        auto made = Context::create({});
        if (!made)
            return false;
        context = std::move(*made);
        auto built = KernelSet::create(*context, layout);
        if (!built)
            qFatal("%s", built.error().message.c_str());
        kernels = std::make_unique<KernelSet>(std::move(*built));
        return true;
    }

    bool add(Id id, const MeshPtr& mesh) {
        Object object;
        object.id = id;
        object.mesh = mesh;
        object.dynamic = true;
        Progress progress;
        return geometry.add(*context, object, buildTree(*mesh, layout, progress)).has_value();
    }

    /// Gives an object's vertices new places.
    bool pose(Id id, const Mesh& posed) {
        const std::size_t first = geometry.placeOf(id).posed->vertexBase;
        return clEnqueueWriteBuffer(context->queue(), geometry.positions().get(), CL_TRUE, 12 * first,
                                    12 * posed.positions.size(), posed.positions.data(), 0, nullptr,
                                    nullptr) == CL_SUCCESS;
    }

    bool refit(const std::vector<Id>& objects) {
        return refitter.shadeTriangles(*context, *kernels, geometry, objects) &&
               refitter.refit(*context, *kernels, geometry, objects);
    }

    /// An object's tree as it is on the device now.
    DeviceTree tree(Id id) const {
        const PosedPlace& posed = *geometry.placeOf(id).posed;
        DeviceTree result = *posed.tree;
        const auto read = [&](cl_mem memory, auto& items, std::size_t first) {
            constexpr std::size_t size = sizeof(items[0]);
            if (!items.empty() &&
                clEnqueueReadBuffer(context->queue(), memory, CL_TRUE, first * size, items.size() * size,
                                    items.data(), 0, nullptr, nullptr) != CL_SUCCESS)
                qFatal("The tree cannot be read.");
        };
        read(geometry.nodes(), result.wideNodes, posed.nodeBase);
        read(geometry.leaves(), result.wideLeaves, posed.leafBase);
        read(geometry.nodes(), result.binaryNodes, posed.nodeBase);
        read(geometry.leaves(), result.binaryTriangles, posed.leafBase);
        return result;
    }

    TreeLayout layout;
    std::unique_ptr<Context> context;
    std::unique_ptr<KernelSet> kernels;
    GeometryStore geometry;
    TreeRefitter refitter;
};

/// What is wrong with an object's tree and what is known about it; empty if nothing.
QString faultOf(const PosedObjects& device, Id id, const Mesh& posed) {
    const DeviceTree tree = device.tree(id);
    if (const QString fault = Walk(tree, posed).fault(); !fault.isEmpty())
        return fault;
    const PosedPlace& place = *device.geometry.placeOf(id).posed;
    Bounds whole;
    for (const glm::vec3& position : posed.positions)
        whole.add(position);
    if (!(place.bounds == whole))
        return "the whole tree's box is another one";
    const double cost = treeCost(tree);
    return std::abs(place.cost - cost) <= 1e-4 * cost
               ? QString()
               : QString("the cost is %1, not %2").arg(cost).arg(place.cost);
}

} // namespace

class RefitTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void treesFollowTheirVertices_data();
    void treesFollowTheirVertices();
    void objectsComeAndGo_data() { treesFollowTheirVertices_data(); }
    void objectsComeAndGo();
    void vertexThatIsNoNumberSpoilsNoOther_data() { treesFollowTheirVertices_data(); }
    void vertexThatIsNoNumberSpoilsNoOther();
    void costIsThatOfTheBuild();
};

void RefitTest::treesFollowTheirVertices_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("Wide8") << static_cast<int>(TreeLayout::Wide8);
    QTest::newRow("Binary2") << static_cast<int>(TreeLayout::Binary2);
}

void RefitTest::treesFollowTheirVertices() {
    QFETCH(int, layout);
    PosedObjects device(static_cast<TreeLayout>(layout));
    if (!device.start())
        QSKIP("There is no OpenCL device here.");
    // From a root without inner children to levels too large for one work group.
    const std::size_t sizes[] = {1, 2, 8, 9, 70, 1000, 60000};
    std::vector<Id> objects;
    std::vector<MeshPtr> meshes;
    for (const std::size_t size : sizes) {
        meshes.push_back(randomSkinnedMesh(size, static_cast<unsigned>(size)));
        objects.push_back(static_cast<Id>(objects.size() + 1));
        QVERIFY(device.add(objects.back(), meshes.back()));
    }
    for (unsigned round = 0; round < 3; ++round) {
        std::vector<Mesh> posed;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            posed.push_back(moved(*meshes[i], 10 * round + static_cast<unsigned>(i)));
            QVERIFY(device.pose(objects[i], posed[i]));
            QVERIFY(!Walk(device.tree(objects[i]), posed[i]).fault().isEmpty());
        }
        QVERIFY(device.refit(objects));
        for (std::size_t i = 0; i < objects.size(); ++i)
            QCOMPARE(faultOf(device, objects[i], posed[i]), QString());
    }
}

void RefitTest::objectsComeAndGo() {
    QFETCH(int, layout);
    PosedObjects device(static_cast<TreeLayout>(layout));
    if (!device.start())
        QSKIP("There is no OpenCL device here.");
    std::mt19937 random(5);
    std::map<Id, MeshPtr> present;
    for (int step = 0; step < 30; ++step) {
        const Id id = 1 + random() % 6;
        if (present.erase(id) > 0) {
            device.geometry.remove(id);
        } else {
            present[id] = randomSkinnedMesh(1 + random() % 9000, static_cast<unsigned>(random()));
            QVERIFY(device.add(id, present[id]));
        }
        std::vector<Id> objects; // a random part of them moves
        std::map<Id, Mesh> posed;
        for (const auto& [object, mesh] : present)
            if (random() % 3 != 0) {
                objects.push_back(object);
                posed[object] = moved(*mesh, static_cast<unsigned>(random()));
                QVERIFY(device.pose(object, posed[object]));
            }
        QVERIFY(device.refit(objects));
        for (const Id object : objects)
            QCOMPARE(faultOf(device, object, posed[object]), QString());
    }
}

void RefitTest::vertexThatIsNoNumberSpoilsNoOther() {
    QFETCH(int, layout);
    PosedObjects device(static_cast<TreeLayout>(layout));
    if (!device.start())
        QSKIP("There is no OpenCL device here.");
    const MeshPtr mesh = randomSkinnedMesh(3000, 3);
    QVERIFY(device.add(1, mesh));
    Mesh posed = moved(*mesh, 1);
    Mesh broken = posed;
    for (std::size_t i = 0; i < broken.positions.size(); i += 301)
        broken.positions[i] = glm::vec3(i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                   : std::numeric_limits<float>::infinity());
    QVERIFY(device.pose(1, broken));
    QVERIFY(device.refit({1}));
    // All boxes still hold the triangles that are triangles ...
    const DeviceTree tree = device.tree(1);
    Bounds whole = device.geometry.placeOf(1).posed->bounds;
    for (const glm::uvec3& t : broken.triangles) {
        Bounds box;
        for (int corner = 0; corner < 3; ++corner)
            box.add(broken.positions[t[corner]]);
        if (!std::isfinite(box.low.x + box.high.x))
            continue;
        Bounds both = whole;
        both.add(box);
        QVERIFY(both == whole);
    }
    // ... and the next pose is as good as ever.
    QVERIFY(device.pose(1, posed));
    QVERIFY(device.refit({1}));
    QCOMPARE(faultOf(device, 1, posed), QString());
}

void RefitTest::costIsThatOfTheBuild() {
    const MeshPtr mesh = randomSkinnedMesh(20000, 9);
    Progress progress;
    const auto bvh = buildBvh(*mesh, {}, progress);
    QVERIFY(bvh);
    // In a binary tree with a box a node, SAH cost without the root's own visit is the sum of all areas below
    // it over that of the root, for leaves of one step.
    const double cost = treeCost(layOutBottomLevel(*bvh, *mesh, TreeLayout::Binary2));
    const Bounds root = bvh->nodes.front().bounds;
    const double relative = cost / DBounds{root.low, root.high}.halfArea();
    QVERIFY(std::abs(relative - (sahCost(*bvh, {}) - 1.0)) < 1e-5 * relative);
    // A wide tree leaves nodes out.
    const double wide = treeCost(layOutBottomLevel(*bvh, *mesh, TreeLayout::Wide8));
    QVERIFY(wide > 0.0 && wide < cost);
    QCOMPARE(treeCost(DeviceTree{}), 0.0);
}

QTEST_GUILESS_MAIN(RefitTest)
#include "tst_refit.moc"
