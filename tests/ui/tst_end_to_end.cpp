// The main job from one end to the other in the real window: import a model, change a light and a material,
// orbit, and see the ray-traced picture follow.
#include "tests/ui/ui_test_support.h"

#include "core/compute/device.h"
#include "ui/viewport/viewport.h"

#include <cmath>

using namespace prizma;
using namespace prizma::test;

namespace {

/// A wall of 40 x 40 units at z = 0 that faces the camera.
constexpr auto wall = "o wall\nv -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n";

/// Mean linear brightness of a frame, 0 to 1, one value a channel.
glm::dvec3 meanOf(const Frame& frame) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i + 3 < frame.pixels.size(); i += 4)
        for (int c = 0; c < 3; ++c) {
            const double encoded = frame.pixels[i + static_cast<std::size_t>(c)] / 255.0;
            sum[c] += encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        }
    return sum / (static_cast<double>(frame.pixels.size()) / 4.0);
}

} // namespace

class TestEndToEnd : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() {
        isolation_ = std::make_unique<Isolation>();
        if (chooseDevice(listDevices(), {}) < 0)
            QSKIP("There is no OpenCL device here.");
    }
    void init();
    void cleanup() { window_.reset(); }

    void brighterLightBrightensThePicture();
    void materialColoursThePicture();
    void orbitTurnsThePicture();

  private:
    const Scene& scene() const { return window_->document().scene(); }
    Viewport& viewport() const { return *window_->findChild<Viewport*>(); }

    /// The last frame, once it shows the present scene to its sample limit; null if that takes too long.
    FramePtr settledFrame() {
        FramePtr frame;
        const auto settled = [&] {
            frame = viewport().lastFrame();
            return frame && frame->isFinal && frame->camera == scene().camera && frame != used_ &&
                   frame->sampleLimit == scene().render.samples;
        };
        if (!QTest::qWaitFor(settled, 20000))
            return nullptr;
        used_ = frame;
        return frame;
    }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<MainWindow> window_;
    FramePtr used_; ///< Already looked at: what comes next must be another.
};

/// Opens the window, imports the wall, hides the rest, and sets one dim light and few samples.
void TestEndToEnd::init() {
    QSettings().clear();
    used_ = nullptr;
    window_ = showWindow();
    window_->resize(700, 500);
    window_->importFile(isolation_->write(QStringLiteral("wall.obj"), wall));
    QTRY_COMPARE(scene().objects.size(), 2u);
    window_->document().edit(QStringLiteral("Prepare"), [](Scene& s) {
        s.objects.edit()[0].visible = false;
        s.lights.edit().resize(1);
        Light& light = s.lights.edit()[0];
        light.type = LightType::Point;
        light.position = {0, 0, 6};
        light.color = glm::dvec3(1.0);
        light.intensity = 10.0;
        s.background.color = glm::dvec3(0.0);
        s.render.samples = 3;
    });
    window_->document().setCamera({{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 45.0});
}

void TestEndToEnd::brighterLightBrightensThePicture() {
    const FramePtr dim = settledFrame();
    QVERIFY(dim);
    QVERIFY(meanOf(*dim).x > 0.01);
    window_->document().setSelection({{EntityKind::Light, scene().lights[0].id}});
    NumberField* intensity = nullptr;
    QTRY_VERIFY((intensity = visibleField(*window_, QStringLiteral("intensity"))));
    typeInto(*intensity, QStringLiteral("2*15"));
    QCOMPARE(scene().lights[0].intensity, 30.0);
    const FramePtr bright = settledFrame();
    QVERIFY(bright);
    // Light adds up: three times the intensity is three times the radiance (bytes round a little).
    const double ratio = meanOf(*bright).x / meanOf(*dim).x;
    QVERIFY2(std::abs(ratio - 3.0) < 0.1, qPrintable(QString::number(ratio)));
    trigger(*window_, QStringLiteral("Edit/Undo"));
    const FramePtr undone = settledFrame();
    QVERIFY(undone);
    QCOMPARE(undone->pixels, dim->pixels);
}

void TestEndToEnd::materialColoursThePicture() {
    const FramePtr grey = settledFrame();
    QVERIFY(grey);
    const glm::dvec3 before = meanOf(*grey);
    QVERIFY(std::abs(before.x - before.z) < 0.01);
    const Id material = scene().objects[1].materials.at(0);
    QVERIFY(window_->document()
                .setProperty({{EntityKind::Material, material}}, "baseColor", glm::dvec3(0.8, 0.0, 0.0))
                .isEmpty());
    QVERIFY(window_->document().setProperty({{EntityKind::Material, material}}, "specular", 0.0).isEmpty());
    QTRY_VERIFY((used_ = viewport().lastFrame()) && used_->isFinal && meanOf(*used_).y < 1e-3);
    QVERIFY(meanOf(*used_).x > 0.01);
}

void TestEndToEnd::orbitTurnsThePicture() {
    const FramePtr front = settledFrame();
    QVERIFY(front);
    const QPoint start = viewport().rect().center();
    QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, start);
    for (int i = 1; i <= 8; ++i)
        QTest::mouseMove(&viewport(), start + QPoint(12 * i, 0), 15);
    QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, start + QPoint(96, 0));
    QVERIFY(scene().camera.position != glm::dvec3(0, 0, 6));
    QVERIFY(std::abs(glm::length(scene().camera.position - scene().camera.target) - 6.0) < 1e-9);
    const FramePtr turned = settledFrame();
    QVERIFY(turned);
    QCOMPARE(turned->width, front->width);
    QVERIFY(turned->pixels != front->pixels);
}

QTEST_MAIN(TestEndToEnd)
#include "tst_end_to_end.moc"
