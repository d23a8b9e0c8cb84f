// What materials and their textures make of a surface: pictures against closed forms and against each other.
#include "core/scene/srgb.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <random>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr double pi = glm::pi<double>();

ImagePtr byteImage(int width, int height, std::vector<std::uint8_t> bytes) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->bytes = std::move(bytes);
    for (std::size_t i = 3; i < image->bytes.size(); i += 4)
        image->opaque = image->opaque && image->bytes[i] == 255;
    return image;
}

/// One colour everywhere.
Texture plainTexture(std::array<std::uint8_t, 4> rgba) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 4; ++i)
        bytes.insert(bytes.end(), rgba.begin(), rgba.end());
    return {"plain.png", byteImage(2, 2, std::move(bytes))};
}

/// Squares of `size` texels: `a` where the sum of their numbers is even, else `b`.
Texture checkerboard(int squares, int size, const glm::vec4& a, const glm::vec4& b) {
    auto image = std::make_shared<Image>();
    image->width = image->height = squares * size;
    image->opaque = a.w >= 1.0F && b.w >= 1.0F;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            const glm::vec4& c = (x / size + y / size) % 2 == 0 ? a : b;
            image->floats.insert(image->floats.end(), {c.x, c.y, c.z, c.w});
        }
    return {"checkerboard.exr", image};
}

double linear(int code) {
    return decodeSrgb(code / 255.0);
}

/// A square of side 2 in XY that faces +Z, texture coordinates from corner to corner times `repeats`.
MeshPtr makeQuad(float repeats = 1.0F) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh->normals.assign(4, {0, 0, 1});
    mesh->texCoords = {{0, 0}, {repeats, 0}, {repeats, repeats}, {0, repeats}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh->triangleSlots = {0, 0};
    mesh->slots = {"quad"};
    updateBounds(*mesh);
    return mesh;
}

Object quadObject(Id material, float repeats = 1.0F) {
    Object quad;
    quad.name = "quad";
    quad.mesh = makeQuad(repeats);
    quad.materials = {material};
    return quad;
}

Material emitter(double radiance) {
    Material material = lambert(0.0);
    material.emission = glm::dvec3(radiance);
    return material;
}

/// A quad seen from the front, filling the picture, in slanted light before a grey background.
Scene quadScene(const Material& material) {
    Scene scene;
    addObject(scene, quadObject(addMaterial(scene, material)));
    Light light;
    light.type = LightType::Directional;
    light.direction = {0.5, 0.3, -1};
    light.irradiance = pi;
    addLight(scene, light);
    scene.background.color = {0.2, 0.3, 0.4};
    scene.camera = {{0.4, 0.2, 3}, {0, 0, 0}, {0, 1, 0}, 25.0};
    scene.render.samples = 1;
    return scene;
}

} // namespace

class SurfaceTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void everyTextureMultipliesItsValue_data();
    void everyTextureMultipliesItsValue();
    void normalMapBendsAsItsScaleSays_data();
    void normalMapBendsAsItsScaleSays();
    void missingDataTexturesChangeNothing();
    void closeUpIsBilinear();
    void farTextureConverges_data();
    void farTextureConverges();
    void mirroredTextureIsFiltered();
    void blendedShadow_data();
    void blendedShadow();
    void blendedSurfaceShowsWhatIsBehind_data();
    void blendedSurfaceShowsWhatIsBehind();
    void maskedShadowAndSurface_data();
    void maskedShadowAndSurface();
    void opaqueModeIgnoresAlpha();
    void singleSided_data();
    void singleSided();
    void manyHolesInARow();

  private:
    OfflinePicture render(const Scene& scene, int width = 24, int height = 18) {
        return renderPicture(*renderer_, scene, width, height);
    }

    /// A row for each shader that has to agree; the test fetches "shader".
    static void addShaders() {
        QTest::addColumn<ShaderType>("shader");
        QTest::newRow("Whitted") << ShaderType::Whitted;
        QTest::newRow("Path") << ShaderType::Path;
    }

    std::unique_ptr<Renderer> renderer_;
};

void SurfaceTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
}

/// A material with a texture of one colour looks like one whose value was multiplied by it, and unlike one
/// without.
void SurfaceTest::everyTextureMultipliesItsValue_data() {
    QTest::addColumn<Material>("textured");
    QTest::addColumn<Material>("plain");
    Material start = lambert(0.8);
    start.specular = 0.9;
    start.roughness = 0.4;
    const auto row = [&](const char* name, const Material& from, const auto& texture, const auto& value) {
        Material textured = from;
        Material plain = from;
        texture(textured);
        value(plain);
        QTest::newRow(name) << textured << plain;
    };
    const Texture color = plainTexture({200, 100, 50, 255});
    const glm::dvec3 rgb(linear(200), linear(100), linear(50));
    row(
        "base colour", start, [&](Material& m) { m.baseColorTexture = color; },
        [&](Material& m) { m.baseColor *= rgb; });
    row(
        "alpha", start,
        [&](Material& m) {
            m.baseColorTexture = plainTexture({255, 255, 255, 102});
        },
        [&](Material& m) { m.alpha = 0.4; });
    Material glowing = start;
    glowing.emission = {1, 2, 3};
    row(
        "emission", glowing, [&](Material& m) { m.emissionTexture = color; },
        [&](Material& m) { m.emission *= rgb; });
    row(
        "specular", start,
        [&](Material& m) {
            m.specularTexture = plainTexture({9, 99, 199, 51});
        },
        [&](Material& m) { m.specular *= 0.2; });
    Material metal = start;
    metal.metallic = 0.8;
    row(
        "metallic and roughness", metal,
        [&](Material& m) {
            m.metallicRoughnessTexture = plainTexture({17, 153, 102, 33});
        },
        [&](Material& m) {
            m.roughness *= 0.6;
            m.metallic *= 0.4;
        });
    Material glass = start;
    glass.transmission = 1.0;
    row(
        "transmission", glass,
        [&](Material& m) {
            m.transmissionTexture = plainTexture({51, 200, 200, 200});
        },
        [&](Material& m) { m.transmission *= 0.2; });
}
void SurfaceTest::everyTextureMultipliesItsValue() {
    QFETCH(Material, textured);
    QFETCH(Material, plain);
    Material without = textured;
    for (Texture* texture :
         {&without.baseColorTexture, &without.specularTexture, &without.metallicRoughnessTexture,
          &without.transmissionTexture, &without.emissionTexture, &without.normalTexture})
        *texture = {};
    const OfflinePicture found = render(quadScene(textured));
    const OfflinePicture wanted = render(quadScene(plain));
    const OfflinePicture bare = render(quadScene(without));
    double effect = 0.0;
    for (int y = 0; y < found.height; ++y)
        for (int x = 0; x < found.width; ++x) {
            const glm::dvec3 value = pixelOf(wanted, x, y);
            QVERIFY(glm::length(pixelOf(found, x, y) - value) < 2e-5 * glm::length(value));
            effect = std::max(effect, glm::length(pixelOf(bare, x, y) - value) / glm::length(value));
        }
    QVERIFY2(effect > 1e-3, qPrintable(QString::number(effect)));
}

void SurfaceTest::normalMapBendsAsItsScaleSays_data() {
    QTest::addColumn<double>("scale");
    for (const double scale : {0.0, 0.5, 1.0, 2.0, -1.0})
        QTest::newRow(qPrintable(QString::number(scale))) << scale;
}
void SurfaceTest::normalMapBendsAsItsScaleSays() {
    QFETCH(double, scale);
    Material material = lambert(1.0);
    material.normalTexture = plainTexture({178, 89, 230, 255});
    material.normalScale = scale;
    Scene scene = quadScene(material);
    scene.background.color = glm::dvec3(0.0);
    const glm::dvec3 bend = glm::dvec3(178, 89, 230) / 255.0 * 2.0 - 1.0;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(bend.x * scale, bend.y * scale, bend.z));
    const double expected = glm::dot(normal, -glm::normalize(scene.lights[0].direction));
    QVERIFY(expected > 0.1);
    const OfflinePicture picture = render(scene);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            QVERIFY(std::abs(pixelOf(picture, x, y).x - expected) < 1e-5);
}

void SurfaceTest::missingDataTexturesChangeNothing() {
    Material material = lambert(0.7);
    material.emission = glm::dvec3(0.5);
    const OfflinePicture wanted = render(quadScene(material));
    for (Texture* texture :
         {&material.specularTexture, &material.metallicRoughnessTexture, &material.transmissionTexture,
          &material.emissionTexture, &material.normalTexture})
        *texture = {"/not/there.png", nullptr};
    QVERIFY(render(quadScene(material)).radiance == wanted.radiance);
    material.baseColorTexture = {"/not/there.png", nullptr}; // the checkerboard
    QVERIFY(render(quadScene(material)).radiance != wanted.radiance);
}

void SurfaceTest::closeUpIsBilinear() {
    std::mt19937 random(4);
    auto image = std::make_shared<Image>();
    image->width = image->height = 4;
    for (int i = 0; i < 16; ++i)
        for (int c = 0; c < 4; ++c)
            image->floats.push_back(c == 3 ? 1.0F : static_cast<float>(random() % 1000) / 1000.0F);
    Material material = emitter(1.0);
    material.emissionTexture = {"noise.exr", image};
    Scene scene;
    addObject(scene, quadObject(addMaterial(scene, material)));
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2 * glm::degrees(std::atan(0.2))}; // just the quad
    scene.render.samples = 1;
    constexpr int size = 40;
    const OfflinePicture picture = render(scene, size, size);
    const auto texel = [&](int x, int y) {
        const auto place = static_cast<std::size_t>(((y + 4) % 4) * 4 + (x + 4) % 4) * 4;
        return glm::dvec3(image->floats[place], image->floats[place + 1], image->floats[place + 2]);
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double across = (x + 0.5) / size * 4.0 - 0.5;
            const double down = (y + 0.5) / size * 4.0 - 0.5;
            const int x0 = static_cast<int>(std::floor(across));
            const int y0 = static_cast<int>(std::floor(down));
            const glm::dvec3 expected =
                glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), across - x0),
                         glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), across - x0), down - y0);
            QVERIFY(glm::length(pixelOf(picture, x, y) - expected) < 2e-5);
        }
}

namespace {

/// Of the red channel.
double meanOf(const OfflinePicture& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += pixelOf(picture, x, y).x;
    return sum / (picture.width * picture.height);
}

double deviationOf(const OfflinePicture& picture) {
    const double mean = meanOf(picture);
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += std::pow(pixelOf(picture, x, y).x - mean, 2);
    return std::sqrt(sum / (picture.width * picture.height - 1));
}

/// Root mean square of the pixels' differences, and what it would be if one sample were 0 or 1 with the
/// chance that `truth` says.
std::pair<double, double> errorsOf(const OfflinePicture& once, const OfflinePicture& truth) {
    double sum = 0.0, unfiltered = 0.0;
    for (int y = 0; y < once.height; ++y)
        for (int x = 0; x < once.width; ++x) {
            const double chance = pixelOf(truth, x, y).x;
            sum += std::pow(pixelOf(once, x, y).x - chance, 2);
            unfiltered += chance * (1.0 - chance);
        }
    const double pixels = once.width * once.height;
    return {std::sqrt(sum / pixels), std::sqrt(unfiltered / pixels)};
}

/// A plane with a checkerboard of light and dark, seen from far.
Scene farPlane(double cameraHeight, double squaresAUnit) {
    Scene scene;
    Material material = emitter(1.0);
    material.emissionTexture = checkerboard(8, 4, glm::vec4(1.0F), glm::vec4(0, 0, 0, 1));
    constexpr double half = 400.0;
    Object plane =
        quadObject(addMaterial(scene, material), static_cast<float>(2 * half * squaresAUnit / 8.0));
    plane.transform.rotation = rotationFromEulerDegrees({-90, 0, 0});
    plane.transform.scale = glm::dvec3(half);
    addObject(scene, plane);
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, cameraHeight, 0}, {3, 0, -40}, {0, 1, 0}, 10.0};
    scene.render.samples = 1;
    return scene;
}

} // namespace

void SurfaceTest::farTextureConverges_data() {
    QTest::addColumn<double>("height");
    QTest::newRow("from above") << 80.0;
    QTest::newRow("slanting") << 20.0;
    QTest::newRow("grazing") << 8.0;
}
void SurfaceTest::farTextureConverges() {
    QFETCH(double, height);
    Scene scene = farPlane(height, 8.0);
    const OfflinePicture once = render(scene, 64, 48);
    scene.render.samples = 512;
    const OfflinePicture often = render(scene, 64, 48);
    const auto [error, unfiltered] = errorsOf(once, often);
    qInfo("mean of one sample %.5f, of 512 %.5f; error of one sample %.4f, unfiltered it would be %.4f",
          meanOf(once), meanOf(often), error, unfiltered);
    // Both estimate the plane's mean brightness, 1/2; their pixels' spread says how well. (4.5 deviations:
    // once in 100,000 runs by chance. 1e-4: float texture coordinates far from the origin.)
    for (const OfflinePicture* picture : {&once, &often})
        QVERIFY(std::abs(meanOf(*picture) - 0.5) <
                4.5 * deviationOf(*picture) / std::sqrt(64.0 * 48.0) + 1e-4);
    QVERIFY(error < 0.25 * unfiltered);
}

void SurfaceTest::mirroredTextureIsFiltered() {
    // The same plane seen in a mirror: the cone goes on.
    Scene scene = farPlane(20.0, 8.0);
    Material mirror = lambert(1.0);
    mirror.metallic = 1.0;
    mirror.roughness = 0.0;
    Object glass = quadObject(addMaterial(scene, mirror));
    glass.transform.translation = {0, 20, 3};
    glass.transform.rotation = rotationFromEulerDegrees({0, 180, 0});
    glass.transform.scale = glm::dvec3(6.0);
    addObject(scene, glass);
    scene.camera = {{0, 20, 0}, {0, 18, 3}, {0, 1, 0}, 30.0};
    const OfflinePicture once = render(scene, 64, 48);
    scene.render.samples = 512;
    const auto [error, unfiltered] = errorsOf(once, render(scene, 64, 48));
    QVERIFY(std::abs(meanOf(once) - 0.5) < 4.5 * deviationOf(once) / std::sqrt(64.0 * 48.0) + 1e-4);
    QVERIFY2(error < 0.25 * unfiltered, qPrintable(QString("%1 of %2").arg(error).arg(unfiltered)));
}

namespace {

/// Ground under slanted light, and sheets above it that do not hide it from the camera.
Scene sheetScene(const Material& sheet, int count = 1, ShaderType shader = ShaderType::Whitted) {
    Scene scene;
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lambert(1.0))));
    const Id material = addMaterial(scene, sheet);
    for (int i = 0; i < count; ++i) {
        Object object = quadObject(material);
        object.transform.rotation = rotationFromEulerDegrees({-90, 0, 0}); // faces up, +V runs to -Z
        object.transform.translation = {-10.0, 10.0 + 0.05 * i, 0};
        object.transform.scale = glm::dvec3(3.0);
        addObject(scene, object);
    }
    Light light;
    light.type = LightType::Directional;
    light.direction = {1, -1, 0}; // the shadow lies around the origin
    light.irradiance = pi * std::sqrt(2.0);
    addLight(scene, light);
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 8, 0}, {0, 0, 0}, {0, 0, -1}, 20.0};
    scene.render.samples = 1;
    scene.render.shader = shader;
    return scene;
}

} // namespace

void SurfaceTest::blendedShadow_data() {
    addShaders();
}
void SurfaceTest::blendedShadow() {
    QFETCH(ShaderType, shader);
    for (const double alpha : {0.0, 0.3, 0.9, 1.0})
        for (const int count : {1, 2, 5}) {
            Material sheet = lambert(0.0); // which sends no light to the ground
            sheet.alpha = alpha;
            const OfflinePicture picture = render(sheetScene(sheet, count, shader), 8, 6);
            const double expected = std::pow(1.0 - alpha, count);
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    QVERIFY2(
                        std::abs(pixelOf(picture, x, y).x - expected) < 1e-5,
                        qPrintable(
                            QString("%1 times %2: %3").arg(count).arg(alpha).arg(pixelOf(picture, x, y).x)));
        }
}

void SurfaceTest::blendedSurfaceShowsWhatIsBehind_data() {
    addShaders();
}
void SurfaceTest::blendedSurfaceShowsWhatIsBehind() {
    QFETCH(ShaderType, shader);
    Material sheet = emitter(2.0);
    sheet.baseColorTexture = plainTexture({0, 0, 0, 51});
    Scene scene = quadScene(sheet);
    Object behind = quadObject(addMaterial(scene, emitter(3.0)));
    behind.transform.translation.z = -1.0;
    behind.transform.scale = glm::dvec3(5.0);
    addObject(scene, behind);
    scene.render.shader = shader;
    scene.render.samples = shader == ShaderType::Path ? 4096 : 1;
    const OfflinePicture picture = render(scene, 8, 6);
    // A path sees either 2 or 3: a deviation of 0.4 a sample; 5 of the mean's for the worst of 48 pixels.
    const double slack = shader == ShaderType::Path ? 5.0 * 0.4 / std::sqrt(4096.0) : 1e-4;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            QVERIFY(std::abs(pixelOf(picture, x, y).x - (0.2 * 2.0 + 0.8 * 3.0)) < slack);
}

void SurfaceTest::maskedShadowAndSurface_data() {
    addShaders();
}
void SurfaceTest::maskedShadowAndSurface() {
    QFETCH(ShaderType, shader);
    // Left half (-X) below the cut-off, right half above it; the border lies between two texels.
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 64; ++i) {
        const std::uint8_t alpha = i % 8 < 4 ? 100 : 140;
        bytes.insert(bytes.end(), {255, 255, 255, alpha});
    }
    Material sheet = lambert(0.0);
    sheet.baseColorTexture = {"mask.png", byteImage(8, 8, bytes)};
    sheet.alphaMode = AlphaMode::Mask;
    for (const double cutoff : {0.3, 120.0 / 255.0, 0.7}) {
        sheet.alphaCutoff = cutoff;
        const Scene scene = sheetScene(sheet, 1, shader);
        const OfflinePicture picture = render(scene, 32, 24);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                // The sheet's middle casts its shadow at x = 0.
                const double place = (x + 0.5 - 16.0) / 16.0;
                if (std::abs(place) < 0.2)
                    continue;
                const bool dark = cutoff < 0.35 || (cutoff < 0.6 && place > 0.0);
                QCOMPARE(pixelOf(picture, x, y).x < 1e-6, dark);
                QVERIFY(dark || std::abs(pixelOf(picture, x, y).x - 1.0) < 1e-5);
            }
        Material seen = emitter(1.0);
        seen.baseColorTexture = sheet.baseColorTexture;
        seen.alphaMode = AlphaMode::Mask;
        seen.alphaCutoff = cutoff;
        Scene front = quadScene(seen);
        front.render.shader = shader;
        front.camera = {{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 25.0};
        const OfflinePicture shown = render(front);
        for (const int x : {2, 21}) {
            const bool there = cutoff < 0.35 || (cutoff < 0.6 && x > 12);
            QVERIFY(glm::length(pixelOf(shown, x, 9) - (there ? glm::dvec3(1.0) : front.background.color)) <
                    1e-5);
        }
    }
}

void SurfaceTest::opaqueModeIgnoresAlpha() {
    Material sheet = lambert(1.0);
    sheet.alpha = 0.2;
    sheet.baseColorTexture = plainTexture({255, 255, 255, 0});
    sheet.alphaMode = AlphaMode::Opaque;
    QCOMPARE(pixelOf(render(sheetScene(sheet), 8, 6), 4, 3).x, 0.0);
}

void SurfaceTest::singleSided_data() {
    addShaders();
}
void SurfaceTest::singleSided() {
    QFETCH(ShaderType, shader);
    Material material = emitter(1.0);
    material.doubleSided = false;
    Scene scene = quadScene(material);
    scene.render.shader = shader;
    QVERIFY(glm::length(pixelOf(render(scene), 12, 9) - glm::dvec3(1.0)) < 1e-5);
    scene.camera.position.z = -3.0; // from behind there is nothing
    QVERIFY(glm::length(pixelOf(render(scene), 12, 9) - scene.background.color) < 1e-5);
    // A mirroring transform turns neither inside nor out.
    scene.objects.edit()[0].transform.scale.z = -1.0;
    scene.objects.edit()[0].transform.scale.x = 1.0;
    QVERIFY(glm::length(pixelOf(render(scene), 12, 9) - glm::dvec3(1.0)) < 1e-5);

    Material sheet = lambert(0.0);
    sheet.doubleSided = false;
    // Rays go from the eye on: to one from the ground the sheet above is there if it faces down.
    Scene shadow = sheetScene(sheet, 1, shader);
    QVERIFY(std::abs(pixelOf(render(shadow, 8, 6), 4, 3).x - 1.0) < 1e-5);
    shadow.objects.edit()[1].transform.rotation = rotationFromEulerDegrees({90, 0, 0});
    QCOMPARE(pixelOf(render(shadow, 8, 6), 4, 3).x, 0.0);
    shadow.objects.edit()[1].transform.rotation = rotationFromEulerDegrees({-90, 0, 0});
    shadow.materials.edit()[1].transmission = 1.0; // glass has both its sides
    QCOMPARE(pixelOf(render(shadow, 8, 6), 4, 3).x, 0.0);
}

void SurfaceTest::manyHolesInARow() {
    Material hole = lambert(1.0);
    hole.alphaMode = AlphaMode::Mask;
    hole.alpha = 0.1;
    Scene scene = sheetScene(hole, 200);
    QVERIFY(std::abs(pixelOf(render(scene, 8, 6), 4, 3).x - 1.0) < 1e-5);
    scene = sheetScene(hole, 300); // beyond the limit: dark, and soon
    QElapsedTimer timer;
    timer.start();
    const double value = pixelOf(render(scene, 8, 6), 4, 3).x;
    QVERIFY(value == 0.0 || std::abs(value - 1.0) < 1e-5);
    QVERIFY(timer.elapsed() < 20'000);
}

QTEST_GUILESS_MAIN(SurfaceTest)
#include "tst_surface.moc"
