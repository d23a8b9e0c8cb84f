// Whitted's shader against the double-precision one of core/reference, pixel by pixel.
#include "core/import/model_importer.h"
#include "core/render/posed_mesh.h"
#include "tests/support/reference_picture.h"
#include "tests/support/whitted_scenes.h"

#include <QtTest>

#include <filesystem>
#include <map>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr int pictureSize = 64;

/// What single precision leaves of a pixel. Positions of hits are good to 32 roundings (6e-8) of the scene's
/// size (tst_kernel_hits), 2e-6; a light a third of that size away changes three times as much in direction
/// and twice as much again in its square law, and a highlight of roughness 0.3 is ten times as steep.
constexpr double seenDirectly = 2e-5;
/// Through balls of glass and in round mirrors: each of them, whose focal length is about its radius,
/// enlarges small differences about tenfold; where more than that comes together, the pixel counts as on an
/// edge.
constexpr double throughGlass = 1e-4;

/// How far around a pixel's centre (in pixels) something else has to be seen to take it as on an edge: the
/// same 2e-6 of the scene's size, seen through several balls of glass.
constexpr double edgeReach = 0.05;
constexpr double mostOnEdges = 0.01;  ///< Share of the pixels.
constexpr double mostMinified = 0.05; ///< Whose textures the renderer shows from a mip level.

std::filesystem::path assets() {
    const char* folder = std::getenv("PRIZMA_ASSETS");
    return folder != nullptr ? std::filesystem::path(folder)
                             : std::filesystem::path(PRIZMA_SOURCE_DIR) / ".." / "shared" / "assets";
}

/// A model on the floor, about 1.6 high; without further objects if the file is absent.
Scene modelScene(const QString& name) {
    Scene scene = stage();
    const auto file = assets() / "obj" / name.toStdString();
    if (!std::filesystem::exists(file))
        return {};
    Progress progress;
    const auto model = importModel(file.string(), {}, progress);
    if (!model)
        return {};
    const std::size_t before = scene.objects.size();
    addModel(scene, *model, {});
    for (std::size_t i = before; i < scene.objects.size(); ++i) {
        Object& object = scene.objects.edit()[i];
        const DBounds box = bindPoseBounds(object);
        const double scale = 1.6 / box.extent().y;
        object.transform.scale *= scale;
        object.transform.translation =
            -box.centre() * scale + glm::dvec3(0.0, 0.05 + 0.5 * box.extent().y * scale, 0.0);
    }
    addPrimitive(scene, PrimitiveType::Sphere, 0.8, mirrorMaterial(), {1.5, 0.45, 0.8});
    addLight(scene, pointLight({2.0, 4.0, 3.0}, 60.0));
    return scene;
}

Scene skinnedScene() {
    Scene scene = stage();
    Object bender = bendingObject();
    bender.transform.translation = {0.0, 1.0, 0.0};
    bender.materials = std::vector<Id>(bender.mesh->slots.size(), addMaterial(scene, lambert(0.8)));
    addObject(scene, bender);
    addPrimitive(scene, PrimitiveType::Sphere, 0.9, mirrorMaterial(), {1.3, 0.5, 0.5});
    addLight(scene, pointLight({2.0, 4.0, 3.0}, 60.0));
    scene.timeline.frame = 15.0;
    return scene;
}

Scene sceneOf(const QString& name) {
    static const std::map<QString, Scene (*)()> scenes{{"materials", materialScene},
                                                       {"lights", lightScene},
                                                       {"instances", instanceScene},
                                                       {"textures", textureScene},
                                                       {"alpha", alphaScene},
                                                       {"glass in glass", nestedGlassScene},
                                                       {"clear shadows", clearShadowScene},
                                                       {"hall of mirrors", hallScene},
                                                       {"skinned", skinnedScene}};
    if (const auto found = scenes.find(name); found != scenes.end())
        return found->second();
    if (name.startsWith("random "))
        return randomScene(name.mid(7).toUInt());
    return modelScene(name);
}

} // namespace

class WhittedAgreementTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void agreesWithTheReference_data();
    void agreesWithTheReference();

  private:
    OfflinePicture render(Renderer& renderer, const Scene& scene) {
        OfflineOptions options;
        options.width = options.height = pictureSize;
        auto picture = renderOffline(renderer, scene, options);
        if (!picture)
            qFatal("%s", picture.error().message.c_str());
        return std::move(*picture);
    }

    /// Posed objects as static ones with the vertices that the device computed.
    Scene standingStill(Scene scene) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            if (!scene.objects[i].mesh->canBePosed())
                continue;
            const auto posed = computePosedMesh(*ways_.front().renderer, scene, scene.objects[i].id);
            if (!posed)
                qFatal("%s", posed.error().message.c_str());
            auto mesh = std::make_shared<Mesh>(*scene.objects[i].mesh);
            mesh->positions = posed->positions;
            mesh->normals = posed->normals;
            scene.objects.edit()[i].mesh = mesh;
        }
        return scene;
    }

    struct Way {
        const char* name;
        std::unique_ptr<Renderer> renderer;
    };
    std::vector<Way> ways_;
};

void WhittedAgreementTest::initTestCase() {
    const auto add = [this](const char* name, TreeLayout layout, bool packets) {
        RendererOptions options;
        options.layout = layout;
        options.packets = packets;
        if (auto renderer = makeRenderer(options))
            ways_.push_back({name, std::move(renderer)});
    };
    add("8-wide, packets", TreeLayout::Wide8, true);
    add("8-wide, single rays", TreeLayout::Wide8, false);
    add("binary", TreeLayout::Binary2, false);
    if (ways_.empty())
        QSKIP("There is no OpenCL device here.");
}

void WhittedAgreementTest::agreesWithTheReference_data() {
    QTest::addColumn<double>("bound");
    for (const char* name : {"lights", "textures", "alpha", "hall of mirrors", "skinned", "common/spot.obj",
                             "common/teapot.obj"})
        QTest::newRow(name) << seenDirectly;
    for (const char* name : {"materials", "instances", "glass in glass", "clear shadows"})
        QTest::newRow(name) << throughGlass;
    for (int seed = 1; seed <= 12; ++seed)
        QTest::addRow("random %d", seed) << throughGlass;
}

void WhittedAgreementTest::agreesWithTheReference() {
    QFETCH(double, bound);
    const QString name = QTest::currentDataTag();
    const Scene scene = sceneOf(name);
    if (scene.objects.empty())
        QSKIP("the model is absent; PRIZMA_ASSETS names the folder of test models");
    const ReferencePicture reference(standingStill(scene), pictureSize, bound, edgeReach);
    std::vector<OfflinePicture> pictures;
    for (const auto& [way, renderer] : ways_) {
        pictures.push_back(render(*renderer, scene));
        QCOMPARE(pictures.back().nonFinitePixels, 0u);
        const auto outcome = reference.compare(pictures.back());
        qInfo("%s: largest error %.1e; on edges %d, minified %d of %d pixels; up to %d rays a pixel", way,
              outcome.largestError, outcome.onEdge, outcome.minified, pictureSize * pictureSize,
              reference.mostRays());
        QVERIFY2(outcome.faults == 0,
                 qPrintable(QString("%1 faults, first: %2").arg(outcome.faults).arg(outcome.first)));
        QVERIFY(outcome.onEdge < mostOnEdges * pictureSize * pictureSize);
        QVERIFY(outcome.minified < mostMinified * pictureSize * pictureSize);
    }
    // Equal in every way of tracing, up to hits at equal distance and roundings in them.
    const auto differing = [&](const OfflinePicture& other) {
        int count = 0;
        for (int y = 0; y < pictureSize; ++y)
            for (int x = 0; x < pictureSize; ++x) {
                const glm::dvec3 a = pixelOf(pictures[0], x, y);
                const glm::dvec3 b = pixelOf(other, x, y);
                count += glm::length(a - b) > bound * (glm::length(a) + glm::length(b)) ? 1 : 0;
            }
        return count;
    };
    for (const OfflinePicture& other : pictures)
        QVERIFY(differing(other) < mostOnEdges * pictureSize * pictureSize);
}

QTEST_GUILESS_MAIN(WhittedAgreementTest)
#include "tst_whitted_agreement.moc"
