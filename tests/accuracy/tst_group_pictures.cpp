#include "tests/support/random_groups.h"
#include "tests/support/reference_picture.h"

#include <QtTest>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Random groups in front of a camera that sees most of them.
Scene viewedGroups(std::mt19937& random) {
    Scene scene = randomGroups(random, 5, 12, 5);
    for (Group& group : scene.groups.edit())
        group.transform.translation *= 0.2;
    for (Object& object : scene.objects.edit())
        object.transform.translation *= 0.4;
    scene.camera.position = {0.0, 1.0, 14.0};
    scene.camera.target = {0.0, 0.0, 0.0};
    scene.render.samples = 1;
    scene.render.shader = ShaderType::Whitted;
    return scene;
}

} // namespace

/// What groups make of a scene, as a picture: the same as the scene in which everything stands there itself.
class TestGroupPictures : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> renderer_;

  private Q_SLOTS:
    void initTestCase() {
        renderer_ = makeRenderer();
        if (!renderer_)
            QSKIP("There is no OpenCL device.");
    }
    void groupsLookLikeWhatTheyHold();
    void theReferenceAgrees();
    void soloLightsShineAlone();
};

void TestGroupPictures::groupsLookLikeWhatTheyHold() {
    constexpr int size = 64;
    std::mt19937 random(7);
    for (int run = 0; run < 6; ++run) {
        Scene scene = viewedGroups(random);
        if (run % 2 == 1)
            scene.groups.edit()[1].visible = false;
        const OfflinePicture grouped = renderPicture(*renderer_, scene, size, size);
        const OfflinePicture flat = renderPicture(*renderer_, flattened(scene), size, size);
        int different = 0;
        int covered = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 a = pixelOf(grouped, x, y);
                const glm::dvec3 b = pixelOf(flat, x, y);
                different += glm::distance(a, b) > 1e-3 * (1.0 + glm::length(b)) ? 1 : 0;
                covered += glm::distance(b, scene.background.color) > 1e-3 ? 1 : 0;
            }
        QVERIFY2(covered > size, qPrintable(QString::number(covered)));
        // Matrices that differ in their last digits may decide an edge's pixel the other way.
        QVERIFY2(different <= size * size / 200, qPrintable(QString::number(different)));
    }
}

void TestGroupPictures::theReferenceAgrees() {
    constexpr int size = 48;
    std::mt19937 random(8);
    for (int run = 0; run < 3; ++run) {
        Scene scene = viewedGroups(random);
        std::erase_if(scene.lights.edit(), [](const Light& light) {
            return light.type == LightType::Rectangle || light.type == LightType::Sphere;
        });
        const auto outcome =
            ReferencePicture(scene, size, 2e-3, 0.02).compare(renderPicture(*renderer_, scene, size, size));
        QVERIFY2(outcome.faults <= 2, qPrintable(outcome.first));
        QVERIFY(outcome.agree > size * size * 9 / 10);
    }
}

void TestGroupPictures::soloLightsShineAlone() {
    constexpr int size = 32;
    std::mt19937 random(9);
    Scene scene = viewedGroups(random);
    for (std::size_t solo = 0; solo < scene.lights.size(); ++solo) {
        Scene alone = scene;
        alone.lights.edit()[solo].solo = true;
        Scene only = scene;
        for (std::size_t i = 0; i < only.lights.size(); ++i)
            only.lights.edit()[i].enabled = i == solo;
        QVERIFY(renderPicture(*renderer_, alone, size, size).radiance ==
                renderPicture(*renderer_, only, size, size).radiance);
    }
}

QTEST_GUILESS_MAIN(TestGroupPictures)
#include "tst_group_pictures.moc"
