// The host's side of light sampling: the tree's structure, the triangles that shine, the background's table.
#include "core/render/emissive_objects.h"
#include "core/render/environment_table.h"
#include "core/render/light_tree.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <cstring>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr float pi = glm::pi<float>();

class RandomEmitters {
  public:
    explicit RandomEmitters(unsigned seed) : random_(seed) {}

    float uniform(float low = 0.0f, float high = 1.0f) {
        return std::uniform_real_distribution<float>(low, high)(random_);
    }

    glm::vec3 direction() {
        std::normal_distribution<float> normal;
        return glm::normalize(glm::vec3(normal(random_), normal(random_), normal(random_)));
    }

    LightBounds make() {
        LightBounds bounds;
        const glm::vec3 centre = direction() * uniform(0.0f, 10.0f);
        const glm::vec3 reach = glm::vec3(uniform(), uniform(), 0.0f) * uniform();
        bounds.box = {centre - reach, centre + reach};
        bounds.power = std::exp(uniform(-5.0f, 5.0f));
        const float angles[] = {0.0f, uniform(0.0f, 1.5f), pi};
        bounds.normals = {direction(), angles[random_() % 3]};
        bounds.twoSided = random_() % 4 == 0;
        bounds.isMet = random_() % 4 == 0;
        return bounds;
    }

    std::vector<LightBounds> make(std::size_t count) {
        std::vector<LightBounds> all;
        for (std::size_t i = 0; i < count; ++i)
            all.push_back(make());
        return all;
    }

  private:
    std::mt19937 random_;
};

glm::vec3 load(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

bool contains(const DeviceLightNode& node, const Bounds& box) {
    const glm::vec3 low = load(node.low);
    const glm::vec3 high = load(node.high);
    return glm::all(glm::lessThanEqual(low, box.low)) && glm::all(glm::greaterThanEqual(high, box.high));
}

/// Whether a node's cone holds an emitter's, within two thousandths of a radian. Where something shines to
/// both sides the kernels take the cone and its opposite for one, so that either may hold it.
bool containsNormals(const DeviceLightNode& node, const LightBounds& emitter) {
    float cosine = glm::dot(load(node.axis), emitter.normals.axis);
    if ((node.flags & PRIZMA_LIGHT_TWO_SIDED) != 0)
        cosine = std::abs(cosine);
    const float between = std::acos(std::clamp(cosine, -1.0f, 1.0f));
    return std::min(between + emitter.normals.angle, pi) <=
           std::acos(std::clamp(node.cosCone, -1.0f, 1.0f)) + 2e-3f;
}

Material shining(double strength = 2.0) {
    Material material;
    material.emission = glm::dvec3(1.0, 0.5, 0.0);
    material.emissionStrength = strength;
    return material;
}

double noTexture(const ImagePtr& image) {
    return image ? 0.5 : 1.0;
}

} // namespace

class LightTreeTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void everyEmitterIsALeaf();
    void nodesHoldWhatIsBelow();
    void treeDoesNotDependOnThreads();
    void emittersInOnePlaceAreNoTrouble();
    void conesHoldBoth();
    void emissiveObjectsAreThoseThatShine();
    void trianglesBecomeEmitters();
    void posedTrianglesMayBeAnywhere();
    void tableIsInProportion();
    void blackCellsGetNothing();
    void oddPicturesMakeNoOddTables();
};

void LightTreeTest::everyEmitterIsALeaf() {
    for (const std::size_t count : {0u, 1u, 2u, 3u, 100u, 5000u}) {
        const auto emitters = RandomEmitters(static_cast<unsigned>(count)).make(count);
        const LightTree tree = buildLightTree(emitters);
        QCOMPARE(tree.nodes.size(), count == 0 ? 0u : 2 * count - 1);
        QCOMPARE(tree.leafOf.size(), count);
        for (std::size_t i = 0; i < count; ++i)
            QCOMPARE(tree.nodes[tree.leafOf[i]].child, PRIZMA_LEAF_BIT | static_cast<std::uint32_t>(i));
        std::vector<int> parents(tree.nodes.size());
        for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
            const DeviceLightNode& node = tree.nodes[i];
            if ((node.child & PRIZMA_LEAF_BIT) != 0)
                continue;
            QVERIFY(node.child % 2 == 1 && node.child > i && node.child + 1 < tree.nodes.size());
            for (const std::uint32_t child : {node.child, node.child + 1}) {
                QCOMPARE(tree.nodes[child].parent, i);
                ++parents[child];
            }
        }
        for (std::size_t i = 1; i < parents.size(); ++i)
            QCOMPARE(parents[i], 1);
    }
}

void LightTreeTest::nodesHoldWhatIsBelow() {
    const auto emitters = RandomEmitters(9).make(3000);
    const LightTree tree = buildLightTree(emitters);
    std::vector<double> powers(tree.nodes.size());
    for (std::size_t i = 0; i < emitters.size(); ++i)
        for (std::uint32_t node = tree.leafOf[i];; node = tree.nodes[node].parent) {
            const DeviceLightNode& n = tree.nodes[node];
            QVERIFY(contains(n, emitters[i].box));
            QVERIFY(containsNormals(n, emitters[i]));
            QVERIFY(n.cosEmission <= std::cos(emitters[i].emission) + 1e-6f);
            QVERIFY(!emitters[i].twoSided || (n.flags & PRIZMA_LIGHT_TWO_SIDED) != 0);
            QVERIFY(!emitters[i].isMet || (n.flags & PRIZMA_LIGHT_IS_MET) != 0);
            powers[node] += static_cast<double>(emitters[i].power);
            if (node == 0)
                break;
        }
    for (std::size_t i = 0; i < powers.size(); ++i)
        QVERIFY(std::abs(static_cast<double>(tree.nodes[i].power) / powers[i] - 1.0) < 1e-4);
}

void LightTreeTest::treeDoesNotDependOnThreads() {
    const auto emitters = RandomEmitters(5).make(20000);
    const LightTree one = buildLightTree(emitters);
    for (int i = 0; i < 3; ++i) {
        const LightTree other = buildLightTree(emitters);
        QCOMPARE(other.leafOf, one.leafOf);
        QVERIFY(std::memcmp(one.nodes.data(), other.nodes.data(),
                            one.nodes.size() * sizeof(DeviceLightNode)) == 0);
    }
}

void LightTreeTest::emittersInOnePlaceAreNoTrouble() {
    std::vector<LightBounds> emitters(10000, RandomEmitters(1).make());
    const LightTree tree = buildLightTree(emitters);
    int deepest = 0;
    for (std::uint32_t leaf : tree.leafOf) {
        int depth = 0;
        for (; leaf != 0; leaf = tree.nodes[leaf].parent)
            ++depth;
        deepest = std::max(deepest, depth);
    }
    QVERIFY(deepest <= 14); // halved
}

void LightTreeTest::conesHoldBoth() {
    RandomEmitters random(3);
    for (int i = 0; i < 10000; ++i) {
        const Cone a{random.direction(), random.uniform(0.0f, 3.3f)};
        const Cone b{i % 5 == 0 ? -a.axis : random.direction(), random.uniform(0.0f, 1.0f)};
        const Cone both = unite(a, b);
        for (const Cone& one : {a, b}) {
            const float between = std::acos(std::clamp(glm::dot(both.axis, one.axis), -1.0f, 1.0f));
            QVERIFY(std::min(between + one.angle, pi) <= both.angle + 2e-3f);
        }
        QVERIFY(std::abs(glm::length(both.axis) - 1.0f) < 1e-4f);
    }
}

void LightTreeTest::emissiveObjectsAreThoseThatShine() {
    Scene scene;
    const Id dark = addMaterial(scene, lambert());
    const Id bright = addMaterial(scene, shining());
    const Id off = addMaterial(scene, shining(0.0));
    addObject(scene, primitiveObject(PrimitiveType::Cube, 1.0, dark));
    addObject(scene, primitiveObject(PrimitiveType::Cube, 1.0, off));
    const Id lamp = addObject(scene, primitiveObject(PrimitiveType::Cube, 1.0, bright));
    Object hidden = primitiveObject(PrimitiveType::Cube, 1.0, bright);
    hidden.visible = false;
    addObject(scene, hidden);
    Object loading = primitiveObject(PrimitiveType::Cube, 1.0, bright);
    loading.mesh = nullptr;
    addObject(scene, loading);
    addObject(scene, primitiveObject(PrimitiveType::Cube, 1.0, noId));
    const auto found = emissiveObjects(scene);
    QCOMPARE(found.size(), 1u);
    QCOMPARE(found[0].id, lamp);
    QVERIFY(found == emissiveObjects(scene));
}

void LightTreeTest::trianglesBecomeEmitters() {
    Scene scene;
    Material material = shining();
    material.doubleSided = false;
    Object lamp = primitiveObject(PrimitiveType::Cube, 2.0, addMaterial(scene, material), {10, 0, 0});
    for (const double mirror : {1.0, -1.0}) {
        lamp.transform.scale = {mirror, 1.0, 1.0};
        Scene one = scene;
        addObject(one, lamp);
        const Emitters emitters = collectEmitters(emissiveObjects(one), {10, 0, 0}, noTexture);
        QCOMPARE(emitters.triangles.size(), lamp.mesh->triangles.size());
        float power = 0.0f;
        for (const LightBounds& bounds : emitters.bounds) {
            power += bounds.power;
            QVERIFY(!bounds.twoSided && !bounds.moves);
            // Outwards from the cube's middle, which is the anchor.
            QVERIFY(glm::dot(bounds.normals.axis, bounds.box.centre()) > 0.0f);
        }
        QVERIFY(std::abs(power - 24.0f * 2.0f * 0.5f) < 1e-3f); // area times the mean of (2, 1, 0)
    }
}

void LightTreeTest::posedTrianglesMayBeAnywhere() {
    Scene scene;
    Object object = bendingObject();
    object.materials.assign(object.mesh->slots.size(), addMaterial(scene, shining()));
    addObject(scene, object);
    const Emitters emitters = collectEmitters(emissiveObjects(scene), glm::dvec3(0.0), noTexture);
    QCOMPARE(emitters.triangles.size(), object.mesh->triangles.size());
    for (const LightBounds& bounds : emitters.bounds) {
        QVERIFY(bounds.moves && bounds.power > 0.0f);
        QCOMPARE(bounds.box, (Bounds{object.mesh->bounds.low, object.mesh->bounds.high}));
    }
}

namespace {

ImagePtr pictureOf(int width, int height, const std::vector<float>& values) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    for (const float value : values)
        image->floats.insert(image->floats.end(), {value, value, value, 1.0f});
    return image;
}

/// A cell's probability.
double chanceOf(const EnvironmentTable& table, std::uint32_t x, std::uint32_t y) {
    const float* columns = table.cumulative.data() + (table.height + 1) + y * (table.width + 1);
    return (static_cast<double>(table.cumulative[y + 1]) - static_cast<double>(table.cumulative[y])) *
           (static_cast<double>(columns[x + 1]) - static_cast<double>(columns[x]));
}

} // namespace

void LightTreeTest::tableIsInProportion() {
    RandomEmitters random(2);
    std::vector<float> values;
    for (int i = 0; i < 20 * 10; ++i)
        values.push_back(random.uniform());
    const EnvironmentTable table = makeEnvironmentTable(*pictureOf(20, 10, values));
    QCOMPARE(table.width, 20u);
    QCOMPARE(table.height, 10u);
    const auto value = [&](int x, int y) {
        return static_cast<double>(
            values[static_cast<std::size_t>(std::clamp(y, 0, 9) * 20 + (x + 20) % 20)]);
    };
    double sum = 0.0;
    double mean = 0.0;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
            double inside = 0.0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    inside += (dx == 0 ? 0.75 : 0.125) * (dy == 0 ? 0.75 : 0.125) * value(x + dx, y + dy);
            const double share =
                (std::cos(glm::pi<double>() * y / 10) - std::cos(glm::pi<double>() * (y + 1) / 10)) / 40;
            mean += inside * share;
            QVERIFY(std::abs(chanceOf(table, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) -
                             inside * share / table.mean) < 1e-6);
            sum += chanceOf(table, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        }
    QVERIFY(std::abs(mean - table.mean) < 1e-9);
    QVERIFY(std::abs(sum - 1.0) < 1e-5);
}

/// One bright texel among black ones, at each place: only cells that the filter spreads it to get something.
void LightTreeTest::blackCellsGetNothing() {
    for (int place = 0; place < 8 * 4; ++place) {
        std::vector<float> values(8 * 4);
        values[static_cast<std::size_t>(place)] = 1e5f;
        const EnvironmentTable table = makeEnvironmentTable(*pictureOf(8, 4, values));
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 8; ++x) {
                const int across = std::abs(x - place % 8);
                const bool lit = std::min(across, 8 - across) <= 1 && std::abs(y - place / 8) <= 1;
                QCOMPARE(chanceOf(table, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) > 0.0,
                         lit);
            }
    }
}

void LightTreeTest::oddPicturesMakeNoOddTables() {
    QCOMPARE(makeEnvironmentTable(*pictureOf(4, 2, std::vector<float>(8))).width, 0u);
    QCOMPARE(makeEnvironmentTable(Image{}).width, 0u);
    std::vector<float> values(3000 * 1100, 1.0f);
    values[17] = NAN;
    values[18] = INFINITY;
    values[19] = -5.0f;
    const EnvironmentTable table = makeEnvironmentTable(*pictureOf(3000, 1100, values));
    QCOMPARE(table.width, EnvironmentTable::mostColumns);
    QCOMPARE(table.height, EnvironmentTable::mostRows);
    QVERIFY(std::abs(table.mean - 1.0) < 1e-4);
    float last = 0.0f;
    for (std::uint32_t y = 0; y <= table.height; ++y) {
        QVERIFY(table.cumulative[y] >= last && table.cumulative[y] <= 1.0f);
        last = table.cumulative[y];
    }
    QCOMPARE(last, 1.0f);
}

QTEST_GUILESS_MAIN(LightTreeTest)
#include "tst_light_tree.moc"
