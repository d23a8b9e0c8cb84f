// Whitted's pictures against the laws of optics, pixel by pixel: Snell, Fresnel, Beer and Lambert.
#include "tests/support/whitted_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr double pi = glm::pi<double>();

/// A branch that would add less than this is not followed (shader_whitted.clh).
constexpr double smallestWeight = 1e-3;

Material emitter(const glm::dvec3& radiance) {
    Material material = lambert(0.0);
    material.name = "emitter";
    material.emission = radiance;
    return material;
}

/// Red grows from 0 to 1 from the picture's left to its right edge, blue is 1: red over blue says where a ray
/// ended, whatever it lost on its way. Black outside the columns from `first` to before `end`.
Texture rampPicture(int width, int first, int end) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = 4;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < width; ++x) {
            const float shown = x >= first && x < end ? 1.0f : 0.0f;
            for (const double value : {(x + 0.5) / width, 0.0, 1.0, 1.0})
                image->floats.push_back(static_cast<float>(value) * shown);
        }
    return {"made by the test", image};
}

/// Unpolarised reflectance by the angles (Fresnel's sine and tangent laws).
double fresnelByAngles(double sine, double index) {
    if (sine < 1e-9)
        return std::pow((index - 1.0) / (index + 1.0), 2.0);
    if (sine >= index)
        return 1.0;
    const double in = std::asin(sine);
    const double out = std::asin(sine / index);
    const double s = std::sin(in - out) / std::sin(in + out);
    const double p = std::tan(in - out) / std::tan(in + out);
    return (s * s + p * p) / 2.0;
}

/// Unit direction of the ray through a pixel's centre.
glm::dvec3 directionOf(const Scene& scene, const OfflinePicture& picture, int x, int y) {
    const CameraFrame frame = frameOf(scene.camera);
    const double half = std::tan(glm::radians(scene.camera.fovY) / 2);
    const double aspect = static_cast<double>(picture.width) / picture.height;
    return glm::normalize(frame.forward +
                          frame.right * (((x + 0.5) / picture.width * 2 - 1) * half * aspect) +
                          frame.up * ((1 - (y + 0.5) / picture.height * 2) * half));
}

/// The largest of many errors, as shares of what each may be.
struct Worst {
    double share = 0.0, error = 0.0;
    int count = 0;

    void add(double off, double bound) {
        ++count;
        error = std::max(error, std::abs(off));
        if (!(std::abs(off) / bound <= share))
            share = std::abs(off) / bound;
    }
    QString text() const {
        return QString("%1 places, largest error %2, %3 of its bound").arg(count).arg(error).arg(share);
    }
};

#define VERIFY_WORST(worst)                                                                                  \
    qInfo("%s", qPrintable((worst).text()));                                                                 \
    QVERIFY((worst).share <= 1.0)

} // namespace

class WhittedOpticsTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void slabAbsorbsAsBeerAndLambertSay();
    void fresnelFromInsideUpToTotalReflection();
    void slabShiftsSideways();
    void facingMirrorsShowImagesOfImages();
    void prismDeviatesBySnell();
    void shadowOfASlabThatLightGoesThrough();
    void sheetsOfAlphaAddUp();
    void manySheetsEnd();
    void roughMetalShowsItsSurroundingsMean();

  private:
    OfflinePicture render(const Scene& scene, int width = 33, int height = 33) {
        return renderPicture(*renderer_, scene, width, height);
    }

    std::unique_ptr<Renderer> renderer_;
};

void WhittedOpticsTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
}

/// T = (1 - F)² a / (1 - F² a²), a = exp(-σ d / cosine inside), over all bounces inside.
void WhittedOpticsTest::slabAbsorbsAsBeerAndLambertSay() {
    Scene scene;
    Material glass = glassMaterial(1.5);
    glass.attenuationColor = {0.8, 0.4, 0.1};
    glass.attenuationDistance = 0.7;
    constexpr double thickness = 0.5;
    addPrimitive(scene, PrimitiveType::Cube, 1.0, glass, {0, 0, 0}).transform.scale = {40, thickness, 40};
    addPrimitive(scene, PrimitiveType::Plane, 100.0, emitter(glm::dvec3(1.0)), {0, -2, 0});
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 3, 0}, {1, 0, 0}, {0, 0, -1}, 50.0};
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene);
    Worst worst;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double cosine = -directionOf(scene, picture, x, y).y;
            const double sine = std::sqrt(1.0 - cosine * cosine);
            const double back = fresnelByAngles(sine, 1.5);
            const double length = thickness / std::sqrt(1.0 - sine * sine / 2.25);
            for (int c = 0; c < 3; ++c) {
                const double left = std::pow(glass.attenuationColor[c], length / glass.attenuationDistance);
                const double expected = std::pow(1.0 - back, 2.0) * left / (1.0 - back * back * left * left);
                // Not followed: the first bounce inside that is too weak, with what comes of it. Its channels
                // are followed or left out together.
                const double leftOut = back * back * left * left * expected;
                const bool followed =
                    std::pow(1.0 - back, 1.0) * back * std::pow(0.8, length / 0.7) > smallestWeight;
                worst.add(pixelOf(picture, x, y)[c] - expected,
                          (followed ? std::min(leftOut, smallestWeight) : leftOut) + 3e-6);
            }
        }
    VERIFY_WORST(worst);
}

/// Seen from inside glass, the surface reflects what is below it: F, and all of it beyond the critical angle.
void WhittedOpticsTest::fresnelFromInsideUpToTotalReflection() {
    Scene scene;
    addPrimitive(scene, PrimitiveType::Plane, 1e4, glassMaterial(1.5), {0, 1, 0});
    addPrimitive(scene, PrimitiveType::Plane, 1e4, emitter(glm::dvec3(1.0)), {0, -1, 0});
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{0, 0, 0}, {1, 1.1, 0}, {0, 1, 0}, 70.0};
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene, 65, 65);
    Worst worst;
    int total = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double cosine = directionOf(scene, picture, x, y).y;
            if (cosine < 0.05)
                continue; // beside the planes' far ends
            const double sine = std::sqrt(1.0 - cosine * cosine);
            const double beyond = std::sqrt(std::max(1.0 - 2.25 * sine * sine, 0.0));
            total += beyond == 0.0 ? 1 : 0;
            // F falls from 1 as 4 (n + 1/n) cosine beyond / cosine; that is a root of what five roundings
            // (6e-8 each) are left in.
            const double rounding = 5 * 6e-8 * 2.25;
            const double bound =
                1e-6 + 9.0 / cosine * std::min(rounding / std::max(2.0 * beyond, 1e-30), std::sqrt(rounding));
            worst.add(pixelOf(picture, x, y).x - fresnelByAngles(sine, 1.0 / 1.5),
                      std::abs(1.5 * sine - 1.0) > 1e-5 && beyond == 0.0 ? 1e-6 : bound);
        }
    QVERIFY(total > 500);
    VERIFY_WORST(worst);
}

/// By t sinθ (1 - cosθ / √(n² - sin²θ)), measured across the ray.
void WhittedOpticsTest::slabShiftsSideways() {
    Scene scene;
    constexpr double thickness = 0.6;
    constexpr double screenSize = 8.0;
    addPrimitive(scene, PrimitiveType::Cube, 1.0, glassMaterial(1.5), {0, 0, 0}).transform.scale = {
        30, thickness, 30};
    Material screen = emitter(glm::dvec3(1.0));
    screen.emissionTexture = rampPicture(64, 0, 64);
    addPrimitive(scene, PrimitiveType::Plane, screenSize, screen, {0, -1, 0});
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{-1.5, 2, 0}, {0.7, 0, 0}, {0, 1, 0}, 20.0};
    scene.render.samples = 1;
    scene.render.maxDepth = 2; // in and out
    const OfflinePicture picture = render(scene);
    Worst worst;
    double largestShift = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 direction = directionOf(scene, picture, x, y);
            const double cosine = -direction.y;
            const double sine = std::sqrt(1.0 - cosine * cosine);
            const double shift = thickness * sine * (1.0 - cosine / std::sqrt(2.25 - sine * sine));
            const glm::dvec3 unbent = scene.camera.position + direction * (3.0 / cosine);
            // Across the ray, in the plane of incidence, back towards the normal; along the screen it is
            // longer by 1 / cosine.
            const double expected = unbent.x - shift / cosine * direction.x / sine;
            const glm::dvec3 value = pixelOf(picture, x, y);
            const double seen = (value.x / value.z - 0.5) * screenSize;
            largestShift = std::max(largestShift, std::abs(unbent.x - expected));
            worst.add(seen - expected, 16 * 6e-8 * (screenSize / 2 + 3.0 / cosine));
        }
    QVERIFY(largestShift > 0.1);
    VERIFY_WORST(worst);
}

/// Unfolded: image k of the room between mirrors at z = ±1 lies between 2k - 1 and 2k + 1, odd ones mirrored,
/// and is seen by way of |k| mirrors.
void WhittedOpticsTest::facingMirrorsShowImagesOfImages() {
    const glm::dvec3 color{0.9, 0.6, 0.8};
    const glm::dvec3 centre{0.3, 0.1, 0.4};
    constexpr double size = 0.5;
    Scene scene;
    for (const double z : {-1.0, 1.0})
        addPrimitive(scene, PrimitiveType::Plane, 200.0, mirrorMaterial(color), {0, 0, z})
            .transform.rotation = rotationFromEulerDegrees({z < 0 ? 90.0 : -90.0, 0, 0});
    addPrimitive(scene, PrimitiveType::Cube, size, emitter({2.0, 3.0, 4.0}), centre);
    scene.background.color = glm::dvec3(0.0);
    scene.camera = {{-0.4, 0.3, 0.7}, {-0.15, 0.2, -1.0}, {0, 1, 0}, 40.0};
    scene.render.samples = 1;
    const OfflinePicture picture = render(scene, 96, 96);
    Worst worst;
    int seenOf[7] = {};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 direction = directionOf(scene, picture, x, y);
            double nearest = 1e300;
            double nearestEdge = 1e300; // how far from the edge of an image the ray passes
            int mirrors = 0;
            for (int k = -6; k <= 6; ++k) {
                glm::dvec3 place = centre;
                place.z = 2.0 * k + (k % 2 == 0 ? centre.z : -centre.z);
                const glm::dvec3 t1 = (place - size / 2 - scene.camera.position) / direction;
                const glm::dvec3 t2 = (place + size / 2 - scene.camera.position) / direction;
                const glm::dvec3 low = glm::min(t1, t2);
                const glm::dvec3 high = glm::max(t1, t2);
                const double in = std::max({low.x, low.y, low.z});
                const double out = std::min({high.x, high.y, high.z});
                if (out <= 0.0)
                    continue;
                nearestEdge = std::min(nearestEdge, std::abs(out - in));
                if (in <= out && in > 0.0 && in < nearest) {
                    nearest = in;
                    mirrors = std::abs(k);
                }
            }
            if (nearestEdge < 1e-3)
                continue;
            glm::dvec3 expected(0.0);
            if (nearest < 1e300) {
                ++seenOf[mirrors];
                const glm::dvec3 once = color + (1.0 - color) * std::pow(1.0 - std::abs(direction.z), 5.0);
                expected = glm::dvec3(2.0, 3.0, 4.0) * glm::pow(once, glm::dvec3(mirrors));
            }
            for (int c = 0; c < 3; ++c)
                worst.add(pixelOf(picture, x, y)[c] - expected[c],
                          1e-9 + expected[c] * 6e-8 * (8 + 16 * mirrors));
        }
    for (int n = 1; n <= 6; ++n)
        QVERIFY2(seenOf[n] > 0, qPrintable(QString("image %1 is not seen").arg(n)));
    VERIFY_WORST(worst);
}

/// Rays across the edge of a prism: δ = θ - A + asin(sin A √(n² - sin²θ) - sin θ cos A), for each pixel of
/// the middle row.
void WhittedOpticsTest::prismDeviatesBySnell() {
    const double apex = glm::radians(40.0);
    constexpr double index = 1.5;
    // Seen from above, the edge at the origin, and two sides that go to -X, apart by the apex angle about the
    // axis -X: rays that come along -Z meet one and leave by the other.
    const glm::dvec2 front{-4.0 * std::cos(apex / 2), 4.0 * std::sin(apex / 2)}; // x and z
    auto mesh = std::make_shared<Mesh>();
    const glm::vec3 corners[] = {{0, 0, 0}, {front.x, 0, front.y}, {front.x, 0, -front.y}};
    mesh->slots = {"prism"};
    for (int side = 0; side < 3; ++side) {
        const glm::vec3 a = corners[side];
        const glm::vec3 b = corners[(side + 1) % 3];
        const glm::vec3 up{0, 2, 0};
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        const glm::vec3 outward = glm::normalize(glm::cross(b - a, up));
        // Outward is away from the middle; the order of corners follows it.
        const glm::vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
        const bool asIs = glm::dot(outward, a - middle) > 0.0f;
        for (const glm::vec3& p : {a - up, b - up, b + up, a + up}) {
            mesh->positions.push_back(p);
            mesh->normals.push_back(asIs ? outward : -outward);
        }
        for (glm::uvec3 t :
             {glm::uvec3(first, first + 1, first + 2), glm::uvec3(first, first + 2, first + 3)}) {
            if (!asIs)
                std::swap(t.y, t.z);
            mesh->triangles.push_back(t);
            mesh->triangleSlots.push_back(0);
        }
    }
    updateBounds(*mesh);
    Scene scene;
    Object prism;
    prism.mesh = mesh;
    prism.materials = {addMaterial(scene, glassMaterial(index))};
    addObject(scene, prism);
    scene.background.image = rampPicture(64, 16, 48); // what the front reflects is dark
    scene.camera = {{-1.8, 0, 6}, {-1.8, 0, 0}, {0, 1, 0}, 12.0};
    scene.render.samples = 1;
    scene.render.maxDepth = 2;
    const OfflinePicture picture = render(scene, 65, 33);
    Worst worst;
    for (int x = 0; x < picture.width; ++x) {
        const glm::dvec3 direction = directionOf(scene, picture, x, 16);
        const double azimuth = std::atan2(direction.x, -direction.z); // from -Z to +X
        // The front side's outward normal is turned from +Z towards +X by half the apex angle.
        const double incidence = azimuth + apex / 2;
        const double sine = std::sin(incidence);
        const double deviation =
            incidence - apex +
            std::asin(std::sin(apex) * std::sqrt(index * index - sine * sine) - sine * std::cos(apex));
        // Away from the edge, towards the base at -X.
        const double expected = 0.5 + (azimuth - deviation) / (2 * pi);
        const glm::dvec3 value = pixelOf(picture, x, 16);
        // Two refractions and the picture's place: 4 roundings of half a turn each way.
        worst.add(value.x / value.z - expected, 4 * 6e-8);
    }
    VERIFY_WORST(worst);
}

/// Straight through: both sides' (1 - F)², base colour and absorption over the straight way inside.
void WhittedOpticsTest::shadowOfASlabThatLightGoesThrough() {
    Scene scene;
    scene.camera = {{0, 1.0, 0}, {0, 0, 0}, {0, 0, -1}, 40.0};
    scene.background.color = glm::dvec3(0.0);
    scene.render.samples = 1;
    addPrimitive(scene, PrimitiveType::Plane, 50.0, lambert(1.0), {0, 0, 0});
    Light sun;
    sun.type = LightType::Directional;
    sun.direction = {0.8, -1.0, 0.3};
    sun.irradiance = 2.0;
    addLight(scene, sun);
    const glm::dvec3 unshadowed = pixelOf(render(scene), 16, 16);
    Material glass = glassMaterial(1.4);
    glass.baseColor = {0.9, 0.5, 0.7};
    glass.attenuationColor = {0.5, 0.6, 0.7};
    glass.attenuationDistance = 1.0;
    constexpr double thickness = 0.5;
    addPrimitive(scene, PrimitiveType::Cube, 1.0, glass, {0, 3, 0}).transform.scale = {40, thickness, 40};
    QCOMPARE(pixelOf(render(scene), 16, 16), glm::dvec3(0.0));
    scene.render.transparentShadows = true;
    const double cosine = 1.0 / glm::length(sun.direction);
    const double back = fresnelByAngles(std::sqrt(1.0 - cosine * cosine), 1.4);
    const OfflinePicture picture = render(scene);
    Worst worst;
    for (int y = 0; y < picture.height; ++y)
        for (int c = 0; c < 3; ++c) {
            const double expected = unshadowed[c] * std::pow(1.0 - back, 2.0) * glass.baseColor[c] *
                                    std::pow(glass.attenuationColor[c], thickness / cosine);
            worst.add(pixelOf(picture, 16, y)[c] - expected, 2e-6 * expected);
        }
    VERIFY_WORST(worst);
}

/// The sum of what each sheet shows of itself, through those before it.
void WhittedOpticsTest::sheetsOfAlphaAddUp() {
    Scene scene;
    scene.camera = {{0, 10, 0}, {0, 0, 0}, {0, 0, -1}, 20.0};
    scene.background.color = {0.5, 1.5, 0.25};
    scene.render.samples = 1;
    scene.render.maxDepth = 0; // alpha is no bounce
    glm::dvec3 expected(0.0);
    double left = 1.0;
    for (int i = 0; i < 5; ++i) {
        Material sheet = emitter({1.0 + i, 2.0, 3.0 - 0.5 * i});
        sheet.alpha = 0.2 + 0.1 * i;
        addPrimitive(scene, PrimitiveType::Plane, 50.0, sheet, {0, 2.0 - i, 0});
        expected += left * sheet.alpha * sheet.emission;
        left *= 1.0 - sheet.alpha;
    }
    expected += left * scene.background.color;
    const OfflinePicture picture = render(scene);
    Worst worst;
    for (int i = 0; i < 33; ++i)
        for (int c = 0; c < 3; ++c)
            worst.add(pixelOf(picture, i, 32 - i)[c] - expected[c], 12 * 6e-8 * expected[c]);
    VERIFY_WORST(worst);
}

/// A thousand sheets with a mirror behind each: the limits of rays a level end it.
void WhittedOpticsTest::manySheetsEnd() {
    Scene scene;
    scene.camera = {{0, 10, 0}, {0, 0, 0}, {0, 0, -1}, 20.0};
    scene.background.color = glm::dvec3(1.0);
    scene.render.samples = 1;
    Material sheet = mirrorMaterial(glm::dvec3(1.0));
    sheet.alpha = 0.02;
    const Id material = addMaterial(scene, sheet);
    for (int i = 0; i < 1000; ++i)
        addObject(scene, primitiveObject(PrimitiveType::Plane, 50.0, material, {0, 5.0 - 0.01 * i, 0}));
    const OfflinePicture picture = render(scene, 16, 16);
    for (int i = 0; i < 16; ++i) {
        const double value = pixelOf(picture, i, i).x;
        QVERIFY2(value > 0.0 && value <= 1.0, qPrintable(QString::number(value)));
    }
    QVERIFY(picture.rays.secondary > 16u * 16u * 63u);
    QVERIFY(picture.rays.secondary <= 16u * 16u * 64u * 7u);
}

/// Rough metal has no mirror ray; the ambient term is its share of the surroundings' mean radiance.
void WhittedOpticsTest::roughMetalShowsItsSurroundingsMean() {
    for (const double roughness : {0.1, 0.4, 0.8}) {
        Scene scene;
        Material metal = mirrorMaterial({1.0, 0.8, 0.4});
        metal.roughness = roughness;
        addPrimitive(scene, PrimitiveType::Plane, 50.0, metal, {0, 0, 0});
        scene.camera = {{0, 5, 0}, {0, 0, 0}, {0, 0, -1}, 10.0};
        scene.background.color = glm::dvec3(2.0);
        scene.render.samples = 1;
        const glm::dvec3 value = pixelOf(render(scene), 16, 16) / 2.0;
        // White metal gives back all of it, by construction; coloured metal no more than one bounce keeps,
        // and no less than two.
        for (int c = 0; c < 3; ++c) {
            const double base = metal.baseColor[c];
            QVERIFY2(
                base == 1.0 ? std::abs(value[c] - 1.0) < 2e-6 : value[c] < base && value[c] > base * base,
                qPrintable(QString("roughness %1: %2 of base %3").arg(roughness).arg(value[c]).arg(base)));
        }
    }
}

QTEST_GUILESS_MAIN(WhittedOpticsTest)
#include "tst_whitted_optics.moc"
