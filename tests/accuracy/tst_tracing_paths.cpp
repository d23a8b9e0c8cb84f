// The same picture whichever way its rays are traced: pixel by pixel or in packets of sixteen, through trees
// of eight or of two children a node.
#include "core/bench/procedural_scene.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <cmath>

using namespace prizma;
using namespace prizma::test;

namespace {

struct Difference {
    double largest = 0.0;   ///< Of a colour, as a share of it (or of 0.01, where it is darker).
    std::size_t pixels = 0; ///< That differ by more than `rounding`.
    std::size_t compared = 0;
    double mean = 0.0; ///< Of the shares, over all colours.
};

/// What may become of formulas that are the same but for the order in which a compiler adds. (Highlights of
/// nearly smooth surfaces lose more: the distribution's denominator is a small difference of numbers near 1.)
constexpr double rounding = 1e-4;

Difference compare(const OfflinePicture& a, const OfflinePicture& b) {
    Difference result;
    for (std::size_t i = 0; i < a.radiance.size(); i += 4) {
        double worst = std::abs(static_cast<double>(a.radiance[i + 3]) - b.radiance[i + 3]); // coverage
        for (std::size_t c = i; c < i + 3; ++c) {
            const double size = std::max({std::abs(a.radiance[c]), std::abs(b.radiance[c]), 0.01f});
            const double share = std::abs(static_cast<double>(a.radiance[c]) - b.radiance[c]) / size;
            worst = std::max(worst, share);
            result.mean += share / 3.0;
        }
        result.largest = std::max(result.largest, worst);
        result.pixels += worst > rounding ? 1 : 0;
        ++result.compared;
    }
    result.mean /= static_cast<double>(result.compared);
    return result;
}

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Noise with holes.
Texture randomTexture(std::mt19937& random) {
    auto image = std::make_shared<Image>();
    image->width = 8;
    image->height = 8;
    image->opaque = false;
    for (int i = 0; i < 4 * image->width * image->height; ++i)
        image->bytes.push_back(static_cast<std::uint8_t>(random() % 256));
    return {{}, image};
}

Material randomMaterial(std::mt19937& random) {
    Material material;
    material.doubleSided = random() % 4 != 0;
    material.baseColor = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
    material.specular = uniform(random, 0, 1);
    material.roughness = uniform(random, 0, 1);
    material.ior = uniform(random, 1.0, 2.0);
    switch (random() % 8) {
    case 0:
        material.metallic = 1.0;
        break;
    case 1:
        material.metallic = uniform(random, 0, 1);
        break;
    case 2:
        material.transmission = uniform(random, 0, 1);
        break;
    case 3:
        material.alpha = uniform(random, 0, 1);
        break;
    case 4:
        material.emission = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
        material.emissionStrength = uniform(random, 0, 2);
        break;
    case 5:
        material.baseColorTexture = randomTexture(random);
        material.alphaMode = AlphaMode::Mask;
        break;
    case 6:
        material.baseColorTexture = randomTexture(random);
        material.alphaMode = AlphaMode::Opaque;
        material.normalTexture = randomTexture(random);
        material.metallicRoughnessTexture = randomTexture(random);
        break;
    default:
        break;
    }
    return material;
}

Light randomLight(std::mt19937& random) {
    Light light;
    constexpr LightType types[] = {LightType::Point, LightType::Spot, LightType::Directional,
                                   LightType::Rectangle, LightType::Sphere};
    light.type = types[random() % std::size(types)];
    light.position = {uniform(random, -4, 4), uniform(random, 3, 6), uniform(random, -4, 4)};
    light.direction = {uniform(random, -1, 1), -1.0, uniform(random, -1, 1)};
    light.color = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
    light.intensity = uniform(random, 1, 60);
    light.radiance = uniform(random, 1, 20);
    light.irradiance = uniform(random, 0, 3);
    light.outerAngle = uniform(random, 20, 60);
    light.innerAngle = light.outerAngle * uniform(random, 0, 1);
    return light;
}

/// Primitives of all kinds, turned and stretched, on a ground, among which rays are reflected and refracted.
Scene randomScene(std::uint32_t seed) {
    std::mt19937 random(seed);
    Scene scene;
    scene.camera = {{0, 3, 9}, {0, 0.5, 0}, {0, 1, 0}, 45.0};
    scene.background.color = {0.2, 0.3, 0.4};
    scene.render.transparentShadows = random() % 3 == 0;
    addObject(scene, primitiveObject(PrimitiveType::Plane, 20.0, addMaterial(scene, randomMaterial(random))));
    constexpr PrimitiveType types[] = {PrimitiveType::Cube, PrimitiveType::Sphere, PrimitiveType::Cylinder,
                                       PrimitiveType::Torus};
    const int objects = static_cast<int>(random() % 12);
    for (int i = 0; i < objects; ++i) {
        Object object =
            primitiveObject(types[random() % std::size(types)], uniform(random, 0.5, 2.0),
                            addMaterial(scene, randomMaterial(random)),
                            {uniform(random, -4, 4), uniform(random, 0, 2), uniform(random, -4, 4)});
        object.transform.rotation = glm::normalize(glm::dquat(
            uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)));
        object.transform.scale = {uniform(random, 0.3, 2), uniform(random, 0.3, 2), uniform(random, 0.3, 2)};
        addObject(scene, std::move(object));
    }
    const int lights = static_cast<int>(random() % 4);
    for (int i = 0; i < lights; ++i)
        addLight(scene, randomLight(random));
    return scene;
}

std::unique_ptr<Renderer> rendererOf(TreeLayout layout, bool packets) {
    RendererOptions options;
    options.layout = layout;
    options.packets = packets;
    auto made = Renderer::create(std::move(options));
    return made ? std::move(*made) : nullptr;
}

} // namespace

class TracingPathsTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void randomScenes();
    void randomPaths();
    void manyTriangles();
    void oddSizes();
    void cleanupTestCase();

  private:
    void checkEqual(const Scene& scene, int width, int height, int samples, double pixelsThatMayDiffer);

    std::unique_ptr<Renderer> packets_, single_, binary_;
    double worst_ = 0.0;
    std::size_t differing_ = 0, compared_ = 0;
};

void TracingPathsTest::initTestCase() {
    packets_ = rendererOf(TreeLayout::Wide8, true);
    if (!packets_)
        QSKIP("There is no OpenCL device here.");
    single_ = rendererOf(TreeLayout::Wide8, false);
    binary_ = rendererOf(TreeLayout::Binary2, false);
    QVERIFY(single_ && binary_);
}

void TracingPathsTest::checkEqual(const Scene& scene, int width, int height, int samples,
                                  double pixelsThatMayDiffer) {
    OfflineOptions options;
    options.width = width;
    options.height = height;
    options.samples = samples;
    const auto packets = renderOffline(*packets_, scene, options);
    const auto single = renderOffline(*single_, scene, options);
    const auto binary = renderOffline(*binary_, scene, options);
    QVERIFY(packets && single && binary);
    for (const auto* other : {&*single, &*binary}) {
        QCOMPARE(packets->nonFinitePixels, 0u);
        QCOMPARE(other->nonFinitePixels, 0u);
        QCOMPARE(packets->rays.camera, other->rays.camera);
        const Difference difference = compare(*packets, *other);
        worst_ = std::max(worst_, difference.largest);
        differing_ += difference.pixels;
        compared_ += difference.compared;
        QVERIFY(difference.mean < 1e-6);
        QVERIFY(static_cast<double>(difference.pixels) <=
                pixelsThatMayDiffer * static_cast<double>(difference.compared));
        const auto close = [](std::uint64_t a, std::uint64_t b) {
            return std::abs(static_cast<double>(a) - static_cast<double>(b)) <=
                   1e-3 * static_cast<double>(a) + 2.0;
        };
        QVERIFY(close(packets->rays.shadow, other->rays.shadow));
        QVERIFY(close(packets->rays.secondary, other->rays.secondary));
    }
}

void TracingPathsTest::randomScenes() {
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        checkEqual(randomScene(seed), 160, 96, 2, 1e-3);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QString("seed %1").arg(seed)));
    }
}

/// Paths are chosen at random, by the same numbers: where rounding turns a choice over, the rest of the path is another.
void TracingPathsTest::randomPaths() {
    for (std::uint32_t seed = 101; seed <= 116; ++seed) {
        Scene scene = randomScene(seed);
        scene.render.shader = ShaderType::Path;
        scene.render.maxDepth = 4;
        if (seed % 4 == 0)
            scene.camera.lensRadius = 0.05;
        checkEqual(scene, 96, 64, 2, 1e-2);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QString("seed %1").arg(seed)));
    }
}

void TracingPathsTest::manyTriangles() {
    for (const auto form : {bench::ProceduralForm::OneMesh, bench::ProceduralForm::Instances}) {
        Scene scene = bench::makeProceduralScene(form, 100000);
        Light light;
        light.position = scene.camera.position + glm::dvec3(0, 1, 0);
        light.intensity = 50.0;
        addLight(scene, light);
        checkEqual(scene, 320, 192, 1, 1e-3);
    }
}

/// Pictures that end inside a tile and inside a packet.
void TracingPathsTest::oddSizes() {
    const Scene scene = randomScene(7);
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {9, 17}, {37, 5}})
        checkEqual(scene, width, height, 3, 0.01);
}

void TracingPathsTest::cleanupTestCase() {
    qInfo("%zu of %zu pixels differ by more than %g, at most by %.2g", differing_, compared_, rounding,
          worst_);
}

QTEST_GUILESS_MAIN(TracingPathsTest)
#include "tst_tracing_paths.moc"
