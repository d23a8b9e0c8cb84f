// Whitted's shader on values at the ends of their ranges: no pixel is ever anything but a number, and none is
// negative.
#include "tests/support/whitted_scenes.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// One of the values that are worth trying.
class Extremes {
  public:
    explicit Extremes(unsigned seed) : random_(seed) {}

    double of(std::initializer_list<double> values) {
        std::uniform_int_distribution<std::size_t> index(0, values.size() - 1);
        return values.begin()[index(random_)];
    }
    double share() { return of({0.0, 1e-9, 0.079999, 0.08, 0.5, 1.0}); }
    glm::dvec3 color() { return {share(), share(), share()}; }

  private:
    std::mt19937 random_;
};

Material extremeMaterial(Extremes& e) {
    Material m;
    m.name = "extreme";
    m.baseColor = e.color();
    m.alpha = e.of({0.0, 1e-6, 0.3, 1.0, 1.0});
    m.alphaMode = static_cast<AlphaMode>(static_cast<int>(e.of({0, 1, 2})));
    m.doubleSided = e.of({0, 1}) == 1.0;
    m.specular = e.share();
    m.specularColor = e.color();
    m.metallic = e.share();
    m.roughness = e.share();
    m.transmission = e.share();
    m.ior = e.of({1.0, 1.0000001, 1.5, 4.0});
    m.attenuationColor = e.color();
    m.attenuationDistance = e.of({0.0, 1e-9, 0.5, 1e9});
    m.emission = e.color();
    m.emissionStrength = e.of({0.0, 1.0, 1e6});
    m.normalScale = e.of({0.0, 1.0, 100.0});
    if (e.of({0, 1}) == 1.0)
        m.normalTexture = randomPicture(4, 7);
    return m;
}

Light extremeLight(Extremes& e) {
    Light light;
    light.type = static_cast<LightType>(static_cast<int>(e.of({0, 1, 2, 3, 4})));
    light.position = {e.of({0.0, 0.5, -3.0, 1e5}), e.of({0.0, 0.5, 3.0}), e.of({0.0, -0.5, 2.0})};
    light.direction = {e.of({0.0, 1e-20, 1.0}), e.of({0.0, -1.0}), 0.0};
    light.intensity = e.of({1e-12, 10.0, 1e8});
    light.radiance = light.irradiance = e.of({1e-12, 3.0, 1e8});
    light.innerAngle = e.of({0.0, 30.0, 89.9});
    light.outerAngle = e.of({0.0, 30.0, 89.9});
    light.size = {e.of({1e-9, 1.0, 1e4}), e.of({1e-9, 1.0})};
    light.radius = e.of({1e-9, 0.3, 50.0});
    return light;
}

Scene extremeScene(unsigned seed) {
    Extremes e(seed);
    Scene scene = stage();
    scene.background.color *= e.of({0.0, 1.0, 1e6});
    scene.render.transparentShadows = e.of({0, 1}) == 1.0;
    for (int i = 0; i < 6; ++i) {
        const auto type = static_cast<PrimitiveType>(static_cast<int>(e.of({0, 1, 2, 3, 4})));
        Object& object = addPrimitive(scene, type, e.of({1e-4, 1.0, 2.0, 100.0}), extremeMaterial(e),
                                      {e.of({-1.0, 0.0, 1.0}), e.of({0.0, 0.5}), e.of({-1.0, 0.0, 1.0})});
        object.transform.scale = {e.of({1.0, -1.0, 1e-4}), 1.0, e.of({1.0, 50.0})};
    }
    for (int i = 0; i < 4; ++i)
        addLight(scene, extremeLight(e));
    return scene;
}

} // namespace

class WhittedFiniteTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void everyPixelIsANumber();
};

void WhittedFiniteTest::everyPixelIsANumber() {
    for (const bool packets : {true, false}) {
        RendererOptions options;
        options.packets = packets;
        const auto renderer = makeRenderer(options);
        if (!renderer)
            QSKIP("There is no OpenCL device here.");
        for (unsigned seed = 1; seed <= 60; ++seed) {
            OfflineOptions size;
            size.width = size.height = 24;
            const auto picture = renderOffline(*renderer, extremeScene(seed), size);
            QVERIFY2(picture.has_value(), picture ? "" : picture.error().message.c_str());
            QVERIFY2(picture->nonFinitePixels == 0,
                     qPrintable(QString("seed %1: %2 pixels").arg(seed).arg(picture->nonFinitePixels)));
            for (const float value : picture->radiance)
                QVERIFY2(value >= 0.0f, qPrintable(QString("seed %1: %2").arg(seed).arg(double(value))));
        }
    }
}

QTEST_GUILESS_MAIN(WhittedFiniteTest)
#include "tst_whitted_finite.moc"
