// Pictures against closed forms (facts/accuracy.md).
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr double pi = glm::pi<double>();

/// Looks straight down at the origin from `height`, black outside.
Scene downwardScene(double height) {
    Scene scene;
    scene.camera = {{0, height, 0}, {0, 0, 0}, {0, 0, -1}, 40.0};
    scene.background.color = glm::dvec3(0.0);
    scene.render.samples = 1;
    return scene;
}

/// World point on y = 0 that the centre of a pixel shows.
glm::dvec3 groundPoint(const Scene& scene, const OfflinePicture& picture, int x, int y) {
    const CameraFrame frame = frameOf(scene.camera);
    const double halfHeight = std::tan(glm::radians(scene.camera.fovY) / 2);
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const glm::dvec3 direction = frame.forward +
                                 frame.right * (((x + 0.5) / picture.width * 2 - 1) * halfHeight * aspect) +
                                 frame.up * ((1 - (y + 0.5) / picture.height * 2) * halfHeight);
    return scene.camera.position - direction * (scene.camera.position.y / direction.y);
}

} // namespace

class RadianceTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void pointLightAbovePlane();
    void directionalLight();
    void spotLightEndsAtItsAngle();
    void glassInUniformSurroundingsIsInvisible();
    void facingMirrorShowsEmitterUnfolded();
    void glassSlabTransmitsAsFresnelSays();
    void shadowFallsWhereItMust();
    void manySamplesLoseNothing();
    void textureIsTheRightWayUp();

  private:
    OfflinePicture render(const Scene& scene, int width = 32, int height = 24) {
        return renderPicture(*renderer_, scene, width, height);
    }

    std::unique_ptr<Renderer> renderer_;
};

void RadianceTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
}

void RadianceTest::pointLightAbovePlane() {
    Scene scene = downwardScene(5.0);
    const double albedo = 0.6;
    const Id material = addMaterial(scene, lambert(albedo));
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, material));
    Light light;
    light.position = {0.7, 2.0, -0.4};
    light.intensity = 30.0;
    addLight(scene, light);
    const OfflinePicture picture = render(scene);
    QCOMPARE(picture.nonFinitePixels, 0u);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 toLight = light.position - groundPoint(scene, picture, x, y);
            const double d2 = glm::dot(toLight, toLight);
            const double expected = albedo / pi * light.intensity * (toLight.y / std::sqrt(d2)) / d2;
            QVERIFY(std::abs(pixelOf(picture, x, y).x - expected) < 2e-5 * expected);
        }
}

void RadianceTest::directionalLight() {
    Scene scene = downwardScene(5.0);
    const Id material = addMaterial(scene, lambert(0.5));
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, material));
    Light light;
    light.type = LightType::Directional;
    light.direction = {1.0, -1.0, 0.0};
    light.irradiance = 4.0;
    light.color = {1.0, 0.5, 0.25};
    addLight(scene, light);
    const OfflinePicture picture = render(scene);
    const glm::dvec3 expected = light.color * (0.5 / pi * 4.0 * std::sqrt(0.5));
    for (int y = 0; y < picture.height; y += 5)
        for (int c = 0; c < 3; ++c)
            QVERIFY(std::abs(pixelOf(picture, 3, y)[c] - expected[c]) < 1e-6);
}

void RadianceTest::spotLightEndsAtItsAngle() {
    Scene scene = downwardScene(5.0);
    const Id material = addMaterial(scene, lambert(1.0));
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, material));
    Light light;
    light.type = LightType::Spot;
    light.position = {0, 3, 0};
    light.innerAngle = 15.0;
    light.outerAngle = 20.0;
    addLight(scene, light);
    const OfflinePicture picture = render(scene, 64, 48);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 p = groundPoint(scene, picture, x, y);
            const double angle = glm::degrees(std::atan2(std::hypot(p.x, p.z), 3.0));
            const double cosine = std::cos(glm::radians(angle));
            const double full = light.intensity / pi * std::pow(cosine, 3) / 9.0;
            const double value = pixelOf(picture, x, y).x;
            if (angle > 20.01)
                QCOMPARE(value, 0.0);
            else if (angle < 14.99)
                QVERIFY(std::abs(value - full) < 1e-4 * full);
            else
                QVERIFY(value >= 0.0 && value < full * 1.0001);
        }
}

void RadianceTest::glassInUniformSurroundingsIsInvisible() {
    // Whatever glass does to directions, it neither adds nor takes energy; the branches that are cut off at
    // the depth limit are the only loss.
    Scene scene;
    Material glass;
    glass.name = "glass";
    glass.baseColor = glm::dvec3(1.0);
    glass.transmission = 1.0;
    glass.roughness = 0.0;
    const Id material = addMaterial(scene, glass);
    addObject(scene, primitiveObject(PrimitiveType::Sphere, 2.0, material));
    scene.camera = {{0, 0.3, 4}, {0, 0, 0}, {0, 1, 0}, 20.0};
    scene.background.color = glm::dvec3(0.75);
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene);
    double lowest = 1.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double value = pixelOf(picture, x, y).x;
            QVERIFY(value <= 0.75 * (1 + 1e-5));
            lowest = std::min(lowest, value / 0.75);
        }
    QVERIFY2(lowest > 0.985, qPrintable(QString::number(lowest)));
    QVERIFY(std::abs(pixelOf(picture, 16, 12).x - 0.75) < 0.75 * 0.003);
}

void RadianceTest::facingMirrorShowsEmitterUnfolded() {
    Scene scene;
    scene.background.color = glm::dvec3(0.0);
    Material mirror;
    mirror.name = "mirror";
    mirror.baseColor = {0.9, 0.8, 0.7};
    mirror.metallic = 1.0;
    mirror.roughness = 0.0;
    Material lamp = lambert(0.0);
    lamp.name = "lamp";
    lamp.emission = glm::dvec3(1.0);
    lamp.emissionStrength = 5.0;
    addObject(scene, primitiveObject(PrimitiveType::Plane, 50.0, addMaterial(scene, mirror)));
    addObject(scene, primitiveObject(PrimitiveType::Cube, 100.0, addMaterial(scene, lamp), {0, 60.0, 0}));
    scene.camera = {{0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 30.0};
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene);
    // Straight down the reflectance is the base colour.
    const glm::dvec3 middle = pixelOf(picture, 16, 12);
    for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(middle[c] - 5.0 * mirror.baseColor[c]) < 0.01);
}

void RadianceTest::glassSlabTransmitsAsFresnelSays() {
    // T = (1 - F) / (1 + F) over all internal bounces; six levels leave less than 1e-4 of it out.
    Scene scene;
    Material glass;
    glass.name = "glass";
    glass.baseColor = glm::dvec3(1.0);
    glass.transmission = 1.0;
    glass.roughness = 0.0;
    glass.ior = 1.5;
    Object slab = primitiveObject(PrimitiveType::Cube, 1.0, addMaterial(scene, glass));
    slab.transform.scale = {20, 0.5, 20};
    addObject(scene, slab);
    Material lamp = lambert(0.0);
    lamp.name = "lamp";
    lamp.emission = glm::dvec3(1.0);
    lamp.emissionStrength = 1.0;
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lamp), {0, -2, 0}));
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 1.0};
    scene.render.samples = 1;
    const double value = pixelOf(render(scene, 33, 33), 16, 16).x;
    QVERIFY2(std::abs(value - 0.92308) < 5e-4, qPrintable(QString::number(value)));
}

void RadianceTest::shadowFallsWhereItMust() {
    Scene scene = downwardScene(20.0);
    const Id material = addMaterial(scene, lambert(1.0));
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, material));
    // A square of side 1 at height 1 under a light at height 2 casts a shadow of side 2, seen beside the
    // square.
    Object square = primitiveObject(PrimitiveType::Plane, 1.0, material, {0, 1, 0});
    addObject(scene, square);
    Light light;
    light.position = {0, 2, 0};
    addLight(scene, light);
    const OfflinePicture picture = render(scene, 160, 120);
    int inShadow = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 p = groundPoint(scene, picture, x, y);
            const double reach = std::max(std::abs(p.x), std::abs(p.z));
            if (reach > 0.6 && reach < 0.97) {
                QCOMPARE(pixelOf(picture, x, y).x, 0.0);
                ++inShadow;
            } else if (reach > 1.03) {
                QVERIFY(pixelOf(picture, x, y).x > 0.0);
            }
        }
    QVERIFY(inShadow > 20);
}

void RadianceTest::manySamplesLoseNothing() {
    Scene scene = downwardScene(5.0);
    const Id material = addMaterial(scene, lambert(0.7));
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, material));
    Light light;
    light.type = LightType::Directional;
    light.irradiance = 1.0;
    addLight(scene, light);
    const double once = pixelOf(render(scene, 8, 8), 4, 4).x;
    scene.render.samples = 20000;
    const double many = pixelOf(render(scene, 8, 8), 4, 4).x;
    QVERIFY2(std::abs(many - once) < 3e-7 * once, qPrintable(QString::number(many / once - 1)));
}

void RadianceTest::textureIsTheRightWayUp() {
    auto image = std::make_shared<Image>();
    image->width = image->height = 2;
    image->bytes = {255, 0, 0,   255, 0,   255, 0,   255,
                    0,   0, 255, 255, 255, 255, 255, 255}; // red green / blue white
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh->normals.assign(4, {0, 0, 1});
    mesh->texCoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh->triangleSlots = {0, 0};
    mesh->slots = {"quad"};
    updateBounds(*mesh);
    Scene scene;
    Material material = lambert(1.0);
    material.baseColorTexture = {"quad.png", image};
    Object quad;
    quad.mesh = mesh;
    quad.materials = {addMaterial(scene, material)};
    addObject(scene, quad);
    Light light;
    light.type = LightType::Directional;
    light.direction = {0, 0, -1};
    light.irradiance = pi;
    addLight(scene, light);
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2 * glm::degrees(std::atan(0.2))};
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene, 6, 6); // pixels 1 and 4 lie in the middle of a texel
    const auto shows = [&](int x, int y, const glm::dvec3& color) {
        QVERIFY(glm::length(pixelOf(picture, x, y) - color) < 1e-4);
    };
    shows(1, 1, {1, 0, 0}); // top left
    shows(4, 1, {0, 1, 0});
    shows(1, 4, {0, 0, 1});
    shows(4, 4, {1, 1, 1});
}

QTEST_GUILESS_MAIN(RadianceTest)
#include "tst_radiance.moc"
