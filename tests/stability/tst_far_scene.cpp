// The same scene elsewhere and at other sizes: the picture must stay.
#include "core/scene/starter_scene.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Objects that touch, shadow and reflect each other, of overall size `scale`, about `centre`.
Scene makeScene(const glm::dvec3& centre, double scale) {
    Scene scene;
    Material mirror;
    mirror.name = "mirror";
    mirror.metallic = 1.0;
    mirror.roughness = 0.0;
    const Id white = addMaterial(scene, lambert(0.7));
    const Id shiny = addMaterial(scene, mirror);
    const auto add = [&](PrimitiveType type, Id material, const glm::dvec3& place, double size) {
        Object object = primitiveObject(type, 1.0, material);
        object.transform.translation = centre + place * scale;
        object.transform.scale = glm::dvec3(size * scale);
        addObject(scene, object);
    };
    add(PrimitiveType::Plane, white, {0, 0, 0}, 12);
    add(PrimitiveType::Sphere, white, {0, 0.5, 0}, 1);
    add(PrimitiveType::Torus, white, {1.2, 0.4, 0.4}, 1);
    add(PrimitiveType::Cube, shiny, {-1.3, 0.5, -0.4}, 1);
    Light light;
    light.position = centre + glm::dvec3(2, 4, 3) * scale;
    light.intensity = 40.0 * scale * scale;
    addLight(scene, light);
    scene.camera = {
        centre + glm::dvec3(0.4, 1.5, 4.5) * scale, centre + glm::dvec3(0, 0.5, 0) * scale, {0, 1, 0}, 45.0};
    scene.background.color = {0.1, 0.2, 0.3};
    scene.render.samples = 2;
    return scene;
}

} // namespace

class FarSceneTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void farAway_data();
    void farAway();
    void otherSizes_data();
    void otherSizes();
    void noAcneAtAnyScale();

  private:
    OfflinePicture render(const Scene& scene) {
        OfflineOptions options;
        options.width = 200;
        options.height = 150;
        auto picture = renderOffline(*renderer_, scene, options);
        if (!picture)
            qFatal("%s", picture.error().message.c_str());
        return std::move(*picture);
    }

    /// Share of pixels that differ by more than 1 % (silhouettes move by a rounding).
    static double differing(const OfflinePicture& a, const OfflinePicture& b) {
        int count = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                if (glm::length(pixelOf(a, x, y) - pixelOf(b, x, y)) >
                    0.01 * (glm::length(pixelOf(a, x, y)) + 0.01))
                    ++count;
        return static_cast<double>(count) / (a.width * a.height);
    }

    std::unique_ptr<Renderer> renderer_;
    std::optional<OfflinePicture> atOrigin_;
};

void FarSceneTest::initTestCase() {
    renderer_ = makeRenderer();
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    atOrigin_ = render(makeScene({}, 1.0));
    QCOMPARE(atOrigin_->nonFinitePixels, 0u);
}

void FarSceneTest::farAway_data() {
    QTest::addColumn<double>("distance");
    for (const double distance : {1e3, 1e6, 1e9})
        QTest::addRow("%g", distance) << distance;
}

void FarSceneTest::farAway() {
    QFETCH(double, distance);
    const OfflinePicture picture = render(makeScene(glm::dvec3(distance, -distance, distance * 0.7), 1.0));
    QCOMPARE(picture.nonFinitePixels, 0u);
    const double share = differing(*atOrigin_, picture);
    QVERIFY2(share < 2e-3, qPrintable(QString::number(share)));
}

void FarSceneTest::otherSizes_data() {
    QTest::addColumn<double>("scale");
    for (const double scale : {1e-4, 1e-2, 1e2, 1e4, 1e6})
        QTest::addRow("%g", scale) << scale;
}

void FarSceneTest::otherSizes() {
    QFETCH(double, scale);
    const OfflinePicture picture = render(makeScene({}, scale));
    QCOMPARE(picture.nonFinitePixels, 0u);
    const double share = differing(*atOrigin_, picture);
    QVERIFY2(share < 2e-3, qPrintable(QString::number(share)));
}

void FarSceneTest::noAcneAtAnyScale() {
    // A lit sphere alone: where the light is above the horizon, no pixel may be dark.
    for (const double scale : {1e-4, 1.0, 1e6}) {
        Scene scene;
        Object sphere = primitiveObject(PrimitiveType::Sphere, 1.0, addMaterial(scene, lambert()));
        sphere.transform.scale = glm::dvec3(scale);
        addObject(scene, sphere);
        Light light;
        light.position = glm::dvec3(0, 0, 50) * scale;
        light.intensity = 2500.0 * scale * scale;
        addLight(scene, light);
        scene.camera = {glm::dvec3(0, 0, 3) * scale, {}, {0, 1, 0}, 8.0};
        scene.background.color = glm::dvec3(0.0);
        scene.render.samples = 1;
        const OfflinePicture picture = render(scene);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                QVERIFY2(pixelOf(picture, x, y).x > 0.05,
                         qPrintable(QString("%1 at %2, %3").arg(scale).arg(x).arg(y)));
    }
}

QTEST_GUILESS_MAIN(FarSceneTest)
#include "tst_far_scene.moc"
