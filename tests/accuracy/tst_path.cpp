// Path against closed forms (facts/accuracy.md). Each picture is rendered with several seeds, whose spread
// gives the standard error of their mean; bounds are for one false alarm in a hundred runs of the whole file.
#include "tests/support/statistics.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr double pi = glm::pi<double>();
constexpr int seeds = 24;

/// Student's distribution has wider tails than the normal one: with 23 degrees of freedom this many standard
/// errors are left once in 2e5.
constexpr double limit = 6.0;

Scene darkScene(int maxDepth) {
    Scene scene;
    scene.background.color = glm::dvec3(0.0);
    scene.render.shader = ShaderType::Path;
    scene.render.maxDepth = maxDepth;
    return scene;
}

Material lamp(double radiance) {
    Material material = lambert(0.0);
    material.name = "lamp";
    material.emission = glm::dvec3(1.0);
    material.emissionStrength = radiance;
    return material;
}

Material glass(double roughness = 0.0) {
    Material material;
    material.name = "glass";
    material.baseColor = glm::dvec3(1.0);
    material.transmission = 1.0;
    material.roughness = roughness;
    return material;
}

/// A camera that sees one point only.
Camera lookingAt(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 direction = glm::normalize(to - from);
    return {from, to, std::abs(direction.y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), 0.01};
}

Object objectOf(MeshPtr mesh, Id material) {
    Object object;
    object.name = "object";
    object.materials.assign(mesh->slots.size(), material);
    object.mesh = std::move(mesh);
    return object;
}

std::shared_ptr<Mesh> emptyMesh() {
    auto mesh = std::make_shared<Mesh>();
    mesh->slots = {"all"};
    return mesh;
}

MeshPtr finished(std::shared_ptr<Mesh> mesh) {
    mesh->texCoords.assign(mesh->positions.size(), {0, 0});
    mesh->triangleSlots.assign(mesh->triangles.size(), 0);
    updateBounds(*mesh);
    return mesh;
}

/// A disk of 512 triangles at height y that faces up, 3e-5 of its area short of round.
MeshPtr diskMesh(double radius, double y) {
    auto mesh = emptyMesh();
    mesh->positions.push_back({0, y, 0});
    const std::uint32_t corners = 512;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        mesh->positions.push_back({radius * std::cos(angle), y, -radius * std::sin(angle)});
        mesh->triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
    }
    mesh->normals.assign(mesh->positions.size(), {0, 1, 0});
    return finished(mesh);
}

/// A unit sphere with exact normals, seen from inside; its facets lie less than 4e-5 inside.
MeshPtr fineSphere() {
    auto mesh = emptyMesh();
    const std::uint32_t columns = 512;
    const std::uint32_t rows = 256;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double theta = pi * row / rows;
            const double ring = row == 0 || row == rows ? 0.0 : std::sin(theta);
            const double phi = 2 * pi * column / columns;
            mesh->positions.push_back({ring * std::cos(phi), std::cos(theta), ring * std::sin(phi)});
            mesh->normals.push_back(mesh->positions.back());
        }
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * columns + column;
            const std::uint32_t b = row * columns + (column + 1) % columns;
            if (row > 0)
                mesh->triangles.push_back({a, b, b + columns});
            if (row + 1 < rows)
                mesh->triangles.push_back({a, b + columns, a + columns});
        }
    return finished(mesh);
}

double fresnelOf(double cosine, double eta) {
    const double sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return 1;
    const double beyond = std::sqrt(1 - sine2);
    const double a = (eta * cosine - beyond) / (eta * cosine + beyond);
    const double b = (cosine - eta * beyond) / (cosine + eta * beyond);
    return (a * a + b * b) / 2;
}

glm::dvec3 refractedBy(const glm::dvec3& direction, const glm::dvec3& normal, double eta) {
    const double cosine = -glm::dot(direction, normal);
    return direction / eta + normal * (cosine / eta - std::sqrt(1 - (1 - cosine * cosine) / (eta * eta)));
}

double meanOfPicture(const OfflinePicture& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += pixelOf(picture, x, y).x;
    return sum / picture.width / picture.height;
}

} // namespace

class PathTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void whiteFurnace_data();
    void whiteFurnace();
    void uniformSky();
    void pointLightInSphere();
    void pointLightAbovePlane();
    void sphereLight();
    void rectangleLight();
    void diskOfTriangles();
    void coaxialDisks();
    void glassSlab();
    void absorbingSlab();
    void glassIsInvisibleInUniformSurroundings_data();
    void glassIsInvisibleInUniformSurroundings();
    void facingMirrors();
    void prismObeysSnell();
    void alphaLetsItsShareThrough();
    void lightsAreSeenOrHidden();
    void circleOfConfusion();
    void fireflyClampOnlyDarkens();
    void seedsDifferAndRepeat();

  private:
    OfflinePicture render(const Scene& scene, int samples, int width, int height) {
        OfflineOptions options;
        options.width = width;
        options.height = height;
        options.samples = samples;
        auto picture = renderOffline(*renderer_, scene, options);
        if (!picture)
            qFatal("%s", picture.error().message.c_str());
        if (picture->nonFinitePixels > 0)
            qFatal("%llu pixels are not numbers", static_cast<unsigned long long>(picture->nonFinitePixels));
        return std::move(*picture);
    }

    /// `measure` of pictures of several seeds.
    template <class Measure>
    Mean measured(Scene scene, int samples, int size, Measure measure) {
        std::vector<double> values;
        for (int seed = 0; seed < seeds; ++seed) {
            scene.render.seed = seed;
            values.push_back(measure(render(scene, samples, size, size)));
        }
        return meanOf(values);
    }

    Mean radiance(const Scene& scene, int samples = 16, int size = 8) {
        return measured(scene, samples, size, meanOfPicture);
    }

    /// `slack`: what the scene's model is off the closed form by, relatively.
    static bool agrees(const char* what, const Mean& mean, double expected, double slack = 2e-5) {
        const double bound = limit * mean.standardError + slack * std::abs(expected) + 1e-7;
        qInfo("%s: %.6f, expected %.6f: error %+.1e, bound %.1e", what, mean.value, expected,
              mean.value - expected, bound);
        return std::abs(mean.value - expected) < bound;
    }

    std::unique_ptr<Renderer> renderer_;
};

void PathTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
}

void PathTest::whiteFurnace_data() {
    QTest::addColumn<double>("albedo");
    QTest::addColumn<int>("maxDepth");
    for (const double albedo : {0.2, 0.5, 0.8})
        for (const int depth : {0, 1, 3, 8, 40})
            QTest::addRow("albedo %.1f, depth %d", albedo, depth) << albedo << depth;
}

void PathTest::whiteFurnace() {
    // Light of n bounces, n being one more than the depth, which does not count direct light's.
    QFETCH(double, albedo);
    QFETCH(int, maxDepth);
    Scene scene = darkScene(maxDepth);
    Material wall = lambert(albedo);
    wall.emission = glm::dvec3(1.0);
    addObject(scene, primitiveObject(PrimitiveType::Cube, 2.0, addMaterial(scene, wall)));
    scene.camera = {{0.2, 0.1, 0.3}, {1, 0.4, 0.5}, {0, 1, 0}, 90.0};
    const double expected = (1 - std::pow(albedo, maxDepth + 2)) / (1 - albedo);
    QVERIFY(agrees("furnace", radiance(scene, 64), expected));
}

void PathTest::uniformSky() {
    Scene scene = darkScene(0);
    scene.background.color = glm::dvec3(0.7);
    addObject(scene, primitiveObject(PrimitiveType::Plane, 10.0, addMaterial(scene, lambert(0.6))));
    scene.camera = lookingAt({1, 2, 0}, {0, 0, 0});
    QVERIFY(agrees("Lambert under a uniform sky", radiance(scene), 0.7 * 0.6));
}

void PathTest::pointLightInSphere() {
    Scene scene = darkScene(64);
    addObject(scene, objectOf(fineSphere(), addMaterial(scene, lambert(0.5))));
    Light light;
    light.position = {0, 0, 0};
    light.intensity = pi;
    addLight(scene, light);
    scene.camera = {{0.3, -0.2, 0.1}, {1, 0.2, 0.3}, {0, 1, 0}, 60.0};
    QVERIFY(agrees("point light in a sphere", radiance(scene, 16, 16), 1.0, 2e-4));
}

void PathTest::pointLightAbovePlane() {
    Scene scene = darkScene(0);
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lambert(0.6))));
    Light light;
    light.position = {0.7, 2.0, -0.4};
    light.intensity = 30.0;
    addLight(scene, light);
    for (const glm::dvec3 point : {glm::dvec3(0, 0, 0), glm::dvec3(3, 0, 1), glm::dvec3(-5, 0, 2)}) {
        scene.camera = lookingAt({1, 5, 0.5}, point);
        const glm::dvec3 toLight = light.position - point;
        const double d2 = glm::dot(toLight, toLight);
        const double expected = 0.6 / pi * light.intensity * toLight.y / std::sqrt(d2) / d2;
        QVERIFY(agrees("point light", radiance(scene, 4), expected,
                       1e-4)); // of the 0.01 degrees that the camera sees
    }
}

void PathTest::sphereLight() {
    Scene scene = darkScene(0);
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lambert(0.6))));
    Light light;
    light.type = LightType::Sphere;
    light.position = {1, 2, 0};
    light.radius = 0.8;
    light.radiance = 5;
    addLight(scene, light);
    for (const glm::dvec3 point : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 1), glm::dvec3(4, 0, 0)}) {
        scene.camera = lookingAt({-3, 3, -5}, point);
        const glm::dvec3 toLight = light.position - point;
        const double d2 = glm::dot(toLight, toLight);
        const double expected = 0.6 * 5 * 0.64 / d2 * toLight.y / std::sqrt(d2);
        QVERIFY(agrees("sphere light", radiance(scene), expected, 1e-4));
    }
}

void PathTest::rectangleLight() {
    Scene scene = darkScene(0);
    addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lambert(0.6))));
    Light light;
    light.type = LightType::Rectangle;
    light.position = {0.5, 1.5, 0};
    light.size = {2, 1};
    light.radiance = 4;
    addLight(scene, light);
    for (const glm::dvec3 point : {glm::dvec3(0.5, 0, 0), glm::dvec3(-1, 0, 1), glm::dvec3(3, 0, -2)}) {
        scene.camera = lookingAt({-3, 2, -5}, point);
        // Lambert's polygon, corners in the order that makes it positive.
        const std::array corners{glm::dvec3(-0.5, 1.5, -0.5), glm::dvec3(1.5, 1.5, -0.5),
                                 glm::dvec3(1.5, 1.5, 0.5), glm::dvec3(-0.5, 1.5, 0.5)};
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec3 a = glm::normalize(corners[i] - point);
            const glm::dvec3 b = glm::normalize(corners[(i + 1) % 4] - point);
            const glm::dvec3 across = glm::cross(a, b);
            sum += std::atan2(glm::length(across), glm::dot(a, b)) * across.y / glm::length(across);
        }
        QVERIFY(agrees("rectangle light", radiance(scene), 0.6 / pi * 4 / 2 * std::abs(sum), 1e-4));
    }
}

void PathTest::diskOfTriangles() {
    // E = pi L R^2 / (R^2 + h^2) on the axis.
    for (const double height : {0.25, 1.0, 4.0}) {
        Scene scene = darkScene(0);
        addObject(scene, primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lambert(0.5))));
        addObject(scene, objectOf(diskMesh(1.0, height), addMaterial(scene, lamp(3.0))));
        scene.camera = lookingAt({3, 0.2 * height, 0}, {0, 0, 0});
        QVERIFY(agrees("disk of triangles", radiance(scene), 0.5 * 3 / (1 + height * height), 1e-4));
    }
}

void PathTest::coaxialDisks() {
    // A pinhole that looks straight down sees equal areas in equal pixels: the sum over the picture is the
    // form factor.
    const double r1 = 0.8;
    const double r2 = 0.5;
    const double h = 1.2;
    Scene scene = darkScene(0);
    addObject(scene, objectOf(diskMesh(r1, 0), addMaterial(scene, lambert(0.9))));
    addObject(scene, objectOf(diskMesh(r2, h), addMaterial(scene, lamp(2.0))));
    scene.camera = {{0, 1, 0}, {0, 0, 0}, {0, 0, -1}, 90.0}; // sees 2 x 2
    const double x = 1 + (1 + r2 * r2 / h / h) / (r1 * r1 / h / h);
    const double f12 = (x - std::sqrt(x * x - 4 * (r2 / r1) * (r2 / r1))) / 2;
    const Mean mean = measured(scene, 16, 32, [&](const OfflinePicture& picture) {
        return meanOfPicture(picture) * 4 / (pi * r1 * r1) / (0.9 * 2.0);
    });
    QVERIFY(agrees("form factor of coaxial disks", mean, f12, 1.5e-4));
}

void PathTest::glassSlab() {
    const double f = fresnelOf(1, 1.5);
    for (const bool transmits : {true, false}) {
        Scene scene = darkScene(64);
        Object slab = primitiveObject(PrimitiveType::Cube, 1.0, addMaterial(scene, glass()));
        slab.transform.scale = {20, 0.5, 20};
        addObject(scene, slab);
        const Id material = addMaterial(scene, lamp(1.0));
        addObject(scene,
                  primitiveObject(PrimitiveType::Plane, 100.0, material, {0, transmits ? -2.0 : 8.0, 0}));
        scene.camera = lookingAt({0, 5, 0}, {0, 0, 0});
        QVERIFY(agrees(transmits ? "glass slab, through" : "glass slab, back", radiance(scene, 32),
                       transmits ? (1 - f) / (1 + f) : 2 * f / (1 + f)));
    }
}

void PathTest::absorbingSlab() {
    // T = (1 - F)^2 a / (1 - F^2 a^2) with a = what one crossing leaves.
    Scene scene = darkScene(64);
    Material material = glass();
    material.attenuationColor = glm::dvec3(0.25);
    material.attenuationDistance = 1.0;
    Object slab = primitiveObject(PrimitiveType::Cube, 1.0, addMaterial(scene, material));
    slab.transform.scale = {20, 0.5, 20};
    addObject(scene, slab);
    addObject(scene,
              primitiveObject(PrimitiveType::Plane, 100.0, addMaterial(scene, lamp(1.0)), {0, -2.0, 0}));
    scene.camera = lookingAt({0, 5, 0}, {0, 0, 0});
    const double f = fresnelOf(1, 1.5);
    const double a = 0.5;
    QVERIFY(agrees("absorbing slab", radiance(scene, 32), (1 - f) * (1 - f) * a / (1 - f * f * a * a)));
}

void PathTest::glassIsInvisibleInUniformSurroundings_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("roughness");
    QTest::newRow("sphere") << static_cast<int>(PrimitiveType::Sphere) << 0.0;
    QTest::newRow("cube") << static_cast<int>(PrimitiveType::Cube) << 0.0;
    QTest::newRow("torus") << static_cast<int>(PrimitiveType::Torus) << 0.0;
    QTest::newRow("cylinder") << static_cast<int>(PrimitiveType::Cylinder) << 0.0;
    QTest::newRow("rough cube") << static_cast<int>(PrimitiveType::Cube) << 0.5;
    QTest::newRow("very rough cube") << static_cast<int>(PrimitiveType::Cube) << 1.0;
}

void PathTest::glassIsInvisibleInUniformSurroundings() {
    QFETCH(int, shape);
    QFETCH(double, roughness);
    Scene scene = darkScene(64);
    const Id material = addMaterial(scene, glass(roughness));
    addObject(scene, primitiveObject(static_cast<PrimitiveType>(shape), 2.0, material));
    scene.camera = {{0.4, 1.7, 4}, {0, 0, 0}, {0, 1, 0}, 22.0};
    scene.background.color = glm::dvec3(0.75);
    // Smooth glass: each path gives exactly the background, and what is missing are those beyond the depth
    // limit. Rough glass: several bounces, each off by at most the albedo tables' error.
    QVERIFY(agrees(QTest::currentDataTag(), radiance(scene, 8, 32), 0.75, roughness > 0 ? 0.02 : 1e-3));
}

void PathTest::facingMirrors() {
    // Two mirrors a distance of 2 apart; a ray between them meets n of them before it meets the lamp at the
    // end.
    Scene scene = darkScene(64);
    Material mirror;
    mirror.name = "mirror";
    mirror.baseColor = glm::dvec3(0.9);
    mirror.metallic = 1;
    mirror.roughness = 0;
    const Id material = addMaterial(scene, mirror);
    for (const double x : {-1.001, 1.001}) {
        Object wall = primitiveObject(PrimitiveType::Cube, 1.0, material, {x, 0, 0});
        wall.transform.scale = {0.002, 50, 50};
        addObject(scene, wall);
    }
    Object end = primitiveObject(PrimitiveType::Cube, 1.0, addMaterial(scene, lamp(2.0)), {0, 0, -5.5});
    end.transform.scale = {1.99, 10, 1};
    addObject(scene, end);
    for (const int n : {0, 1, 2, 5, 12}) {
        const double across = 2.0 * n; // sideways in the unfolded room, to the middle of the n-th image
        const glm::dvec3 direction = glm::normalize(glm::dvec3(across, 0, -5.0));
        scene.camera = lookingAt({0, 0, 0}, direction);
        const double cosine = direction.x;
        const double reflectance = 0.9 + 0.1 * std::pow(1 - cosine, 5);
        QVERIFY(agrees("facing mirrors", radiance(scene, 4), 2 * std::pow(reflectance, n), 1e-4));
    }
}

void PathTest::prismObeysSnell() {
    // A prism of 60 degrees, edge along z. A narrow lamp stands where a ray must come out, then a little
    // aside of it.
    auto mesh = emptyMesh();
    const double half = std::sqrt(3.0);
    const std::array corners{glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, half, 0)};
    const auto addQuad = [&](const glm::vec3& a, const glm::vec3& b) {
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        const glm::vec3 deep(0, 0, 10);
        for (const glm::vec3 p : {a + deep, a - deep, b - deep, b + deep}) {
            mesh->positions.push_back(p);
            mesh->normals.push_back(glm::normalize(glm::cross(b - a, glm::vec3(0, 0, 1))));
        }
        mesh->triangles.push_back({first, first + 1, first + 2});
        mesh->triangles.push_back({first, first + 2, first + 3});
    };
    addQuad(corners[0], corners[1]);
    addQuad(corners[1], corners[2]);
    addQuad(corners[2], corners[0]);
    const MeshPtr prism = finished(mesh);
    const glm::dvec3 normalIn = glm::normalize(glm::dvec3(-half, 1, 0));
    const glm::dvec3 normalOut = glm::normalize(glm::dvec3(half, 1, 0));
    for (const double height : {0.7, 0.9, 1.1})
        for (const double slope : {0.2, 0.45}) {
            const glm::dvec3 entry{(height - half) / half, height, 0};
            const glm::dvec3 direction = glm::normalize(glm::dvec3(1, slope, 0));
            const glm::dvec3 inside = refractedBy(direction, normalIn, 1.5);
            const double t = (half - entry.y - half * entry.x) / (inside.y + half * inside.x);
            const glm::dvec3 exit = entry + inside * t;
            if (exit.y > half || exit.y < 0)
                continue;
            const glm::dvec3 outside = refractedBy(inside, -normalOut, 1 / 1.5);
            const glm::dvec3 target = exit + outside * (3 - exit.x) / outside.x;
            const double share = (1 - fresnelOf(-glm::dot(direction, normalIn), 1.5)) *
                                 (1 - fresnelOf(glm::dot(inside, normalOut), 1 / 1.5));
            for (const double aside : {0.0, 0.006, -0.006}) {
                Scene scene = darkScene(1); // nothing beyond the two refractions
                addObject(scene, objectOf(prism, addMaterial(scene, glass())));
                Object strip = primitiveObject(PrimitiveType::Cube, 1.0, addMaterial(scene, lamp(1.0)),
                                               target + glm::dvec3(0.0001, aside, 0));
                strip.transform.scale = {0.0002, 0.01, 1};
                addObject(scene, strip);
                scene.camera = lookingAt(entry - direction * 2.0, entry);
                QVERIFY(agrees(aside == 0 ? "prism" : "beside it", radiance(scene, 16),
                               aside == 0 ? share : 0.0, 1e-4));
            }
        }
}

void PathTest::alphaLetsItsShareThrough() {
    Scene scene = darkScene(0);
    Material veil = lamp(3.0);
    veil.alpha = 0.3;
    const Id material = addMaterial(scene, veil);
    for (const double y : {0.0, 0.5, 1.0})
        addObject(scene, primitiveObject(PrimitiveType::Plane, 10.0, material, {0, y, 0}));
    scene.background.color = glm::dvec3(2.0);
    scene.camera = lookingAt({0.3, 5, 0.2}, {0, 0, 0});
    QVERIFY(agrees("three veils", radiance(scene, 32), 3 * (1 - std::pow(0.7, 3)) + 2 * std::pow(0.7, 3)));
    // And in their shadow: a floor below them in a point light's beam.
    Material dark = lambert(0.0);
    dark.alpha = 0.3;
    Scene shaded = darkScene(0);
    const Id darkId = addMaterial(shaded, dark);
    for (const double y : {1.0, 1.2})
        addObject(shaded, primitiveObject(PrimitiveType::Plane, 4.0, darkId, {0, y, 0}));
    addObject(shaded, primitiveObject(PrimitiveType::Plane, 10.0, addMaterial(shaded, lambert(0.5))));
    Light light;
    light.position = {0, 3, 0};
    light.intensity = 20;
    addLight(shaded, light);
    shaded.camera = lookingAt({4, 0.8, 0}, {0, 0, 0});
    QVERIFY(agrees("shadow of two veils", radiance(shaded, 4), 0.49 * 0.5 / pi * 20 / 9, 1e-4));
}

void PathTest::lightsAreSeenOrHidden() {
    for (const LightType type : {LightType::Rectangle, LightType::Sphere})
        for (const bool visible : {true, false}) {
            Scene scene = darkScene(2);
            scene.background.color = glm::dvec3(0.25);
            Light light;
            light.type = type;
            light.position = {0, 3, 0};
            light.radiance = 6;
            light.visible = visible;
            addLight(scene, light);
            scene.camera = lookingAt({0, 0, 0}, {0, 3, 0});
            QVERIFY(agrees(visible ? "a light" : "hidden", radiance(scene, 2), visible ? 6.0 : 0.25));
            // In a mirror it shows either way.
            Material mirror;
            mirror.metallic = 1;
            mirror.roughness = 0;
            mirror.baseColor = glm::dvec3(1.0);
            addObject(scene,
                      primitiveObject(PrimitiveType::Plane, 2.0, addMaterial(scene, mirror), {0, -1, 0}));
            scene.camera = lookingAt({0, 0, 0}, {0, -1, 0});
            QVERIFY(agrees("in a mirror", radiance(scene, 2), 6.0));
        }
}

void PathTest::circleOfConfusion() {
    // What lies at depth d is spread over a disk of radius R |1 - f/d| in the plane of focus; its mean
    // squared radius is half that of the rim, to which the emitter's own size adds.
    const double side = 0.02;
    for (const double depth : {2.0, 8.0}) {
        Scene scene = darkScene(0);
        const double focus = 4;
        const double radius = 0.3;
        Object spot =
            primitiveObject(PrimitiveType::Plane, side, addMaterial(scene, lamp(1000.0)), {0, -depth, 0});
        addObject(scene, spot);
        scene.camera = {
            {0, 0, 0}, {0, -1, 0}, {0, 0, -1}, 2 * glm::degrees(std::atan(0.5 / focus))}; // 1 x 1 in focus
        scene.camera.lensRadius = radius;
        scene.camera.focusDistance = focus;
        const int size = 128;
        const Mean mean = measured(scene, 16, size, [&](const OfflinePicture& picture) {
            double sum = 0;
            double moment = 0;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double u = (x + 0.5) / size - 0.5;
                    const double v = (y + 0.5) / size - 0.5;
                    sum += pixelOf(picture, x, y).x;
                    moment += pixelOf(picture, x, y).x * (u * u + v * v);
                }
            return moment / sum;
        });
        const double circle = radius * std::abs(1 - focus / depth);
        const double image = side * focus / depth;
        const double expected = circle * circle / 2 + image * image / 6 - 1.0 / (6 * size * size);
        QVERIFY(agrees("mean squared radius of the circle of confusion", mean, expected, 1e-3));
    }
}

void PathTest::fireflyClampOnlyDarkens() {
    Scene scene = darkScene(8);
    Material wall = lambert(0.8);
    addObject(scene, primitiveObject(PrimitiveType::Cube, 4.0, addMaterial(scene, wall)));
    Light light;
    light.position = {1, 1.6, 0};
    light.intensity = 10;
    addLight(scene, light);
    scene.camera = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 60.0};
    const double full = meanOfPicture(render(scene, 64, 16, 16));
    scene.render.fireflyClamp = 0.5;
    const double clamped = meanOfPicture(render(scene, 64, 16, 16));
    scene.render.fireflyClamp = 1e6;
    const double loose = meanOfPicture(render(scene, 64, 16, 16));
    scene.render.maxDepth = 0;
    const double direct = meanOfPicture(render(scene, 64, 16, 16));
    QCOMPARE(loose, full);
    QVERIFY(clamped < full && clamped > direct);
}

void PathTest::seedsDifferAndRepeat() {
    Scene scene = darkScene(2);
    scene.background.color = glm::dvec3(1.0);
    addObject(scene, primitiveObject(PrimitiveType::Sphere, 2.0, addMaterial(scene, lambert(0.5))));
    scene.camera = {{0, 0.5, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
    const OfflinePicture one = render(scene, 4, 32, 32);
    scene.render.seed = 1;
    const OfflinePicture other = render(scene, 4, 32, 32);
    scene.render.seed = 0;
    const OfflinePicture again = render(scene, 4, 32, 32);
    QVERIFY(one.radiance != other.radiance);
    QVERIFY(one.radiance == again.radiance);
}

QTEST_GUILESS_MAIN(PathTest)
#include "tst_path.moc"
