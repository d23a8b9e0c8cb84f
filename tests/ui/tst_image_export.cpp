// What the view has rendered, as it is shown, marked and saved.
#include "tests/ui/ui_test_support.h"

#include "core/compute/device.h"
#include "core/import/image_loader.h"
#include "core/scene/srgb.h"
#include "ui/export/export_actions.h"
#include "ui/export/image_exporter.h"
#include "ui/viewport/statistics_overlay.h"
#include "ui/viewport/viewport.h"

#include <QColorSpace>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace prizma;
using namespace prizma::test;

namespace {

/// RGBA, row by row.
std::vector<std::uint8_t> bytesOf(const QImage& image) {
    const QImage rgba = image.convertToFormat(QImage::Format_RGBA8888);
    return {rgba.constBits(), rgba.constBits() + rgba.sizeInBytes()};
}

} // namespace

class TestImageExport : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }

    void bytesAreThoseOfTheView();
    void deepPictureHoldsTheSameColours();
    void exrIsLinear();
    void denoisedPreviewIsMarkedAndNeverSaved();
    void overlayCountsWhatIsNoNumber();
    void pausingKeepsTheSamples();
    void dialogOffersTheFormats();
    void faultIsTold();

  private:
    Viewport& viewport() const { return window_->viewport(); }
    ImageExporter& exporter() const { return window_->exportActions().imageExporter(); }
    FramePtr settledFrame(const std::function<bool(const Frame&)>& isMeant = {}) const;
    QString save(const QString& name, PictureFormat format);
    QLabel* mark() const { return window_->findChild<QLabel*>(QStringLiteral("denoisedMark")); }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<MainWindow> window_;
};

void TestImageExport::initTestCase() {
    isolation_ = std::make_unique<Isolation>();
    if (chooseDevice(listDevices(), {}) < 0)
        QSKIP("There is no OpenCL device here.");
}

void TestImageExport::init() {
    QSettings().clear();
    window_ = showWindow();
    window_->resize(760, 520);
    window_->document().edit(QStringLiteral("Prepare"), [](Scene& s) { s.render.samples = 3; });
    QVERIFY(settledFrame());
}

/// The last frame, once it shows the present scene to its sample limit; null if that takes too long.
FramePtr TestImageExport::settledFrame(const std::function<bool(const Frame&)>& isMeant) const {
    FramePtr frame;
    const auto settled = [&] {
        frame = viewport().lastFrame();
        return frame && frame->isFinal && frame->scene == window_->document().scene() &&
               (!isMeant || isMeant(*frame));
    };
    return QTest::qWaitFor(settled, 30000) ? frame : nullptr;
}

/// Exports and gives the file's name once it is there.
QString TestImageExport::save(const QString& name, PictureFormat format) {
    QSignalSpy messages(&exporter(), &ImageExporter::message);
    const QString file = isolation_->path(name);
    exporter().exportTo(file, format);
    if (messages.isEmpty() && !messages.wait(20000))
        return {};
    const auto told = messages.first().first().value<Diagnostic>();
    return told.severity == Severity::Information ? file : QString();
}

void TestImageExport::bytesAreThoseOfTheView() {
    const FramePtr frame = viewport().lastFrame();
    const QImage saved(save(QStringLiteral("view.png"), PictureFormat::Png8));
    QCOMPARE(saved.size(), QSize(frame->width, frame->height));
    QVERIFY(bytesOf(saved) == frame->pixels);
    QCOMPARE(saved.colorSpace(), QColorSpace(QColorSpace::SRgb));
}

void TestImageExport::deepPictureHoldsTheSameColours() {
    window_->document().setProperty({{EntityKind::Render}}, "viewTransform", std::string("filmic"));
    const FramePtr frame = settledFrame();
    QVERIFY(frame);
    const QImage deep(save(QStringLiteral("deep.png"), PictureFormat::Png16));
    QCOMPARE(deep.format(), QImage::Format_RGBA64);
    QCOMPARE(deep.size(), QSize(frame->width, frame->height));
    std::size_t between = 0;
    for (int y = 0; y < deep.height(); ++y)
        for (int x = 0; x < deep.width(); ++x) {
            const QRgba64 pixel = reinterpret_cast<const QRgba64*>(deep.constScanLine(y))[x];
            const auto i = 4 * static_cast<std::size_t>(y * frame->width + x);
            for (const auto& [word, byte] :
                 {std::pair(pixel.red(), frame->pixels[i]), std::pair(pixel.green(), frame->pixels[i + 1]),
                  std::pair(pixel.blue(), frame->pixels[i + 2])}) {
                QVERIFY(std::abs(word / 257.0 - byte) < 0.51);
                between += word % 257 != 0 ? 1 : 0;
            }
        }
    QVERIFY(between > frame->pixels.size() / 10);
}

void TestImageExport::exrIsLinear() {
    window_->document().setProperty({{EntityKind::Render}}, "exposure", 1.0);
    const FramePtr frame = settledFrame();
    QVERIFY(frame);
    const auto image = loadImage(toStdString(save(QStringLiteral("view.exr"), PictureFormat::Exr)));
    QVERIFY(image);
    QCOMPARE((*image)->width, frame->width);
    QCOMPARE((*image)->floats.size(), frame->pixels.size());
    for (std::size_t i = 0; i < frame->pixels.size(); ++i)
        if (i % 4 != 3) // exposure is the screen's affair: the file has half of what is shown
            QVERIFY(std::abs(encodeSrgb(std::clamp(2.0 * (*image)->floats[i], 0.0, 1.0)) * 255.0 -
                             frame->pixels[i]) < 0.51);
}

void TestImageExport::denoisedPreviewIsMarkedAndNeverSaved() {
    QVERIFY(!mark()->isVisible());
    viewport().setStatisticsVisible(true);
    const auto* overlay = viewport().findChild<StatisticsOverlay*>();
    const FramePtr plain = viewport().lastFrame();
    trigger(*window_, QStringLiteral("View/Denoise Preview"));
    const FramePtr smooth = settledFrame([](const Frame& f) { return f.isDenoised; });
    QVERIFY(smooth);
    QTRY_VERIFY(mark()->isVisible());
    QTRY_VERIFY(overlay->text().contains(QStringLiteral("denoised")));
    QCOMPARE(smooth->samples, plain->samples); // nothing was traced again
    QVERIFY(smooth->pixels != plain->pixels);
    const QImage saved(save(QStringLiteral("noisy.png"), PictureFormat::Png8));
    QVERIFY(bytesOf(saved) == plain->pixels);
    trigger(*window_, QStringLiteral("Edit/Undo"));
    const FramePtr again = settledFrame([](const Frame& f) { return !f.isDenoised; });
    QVERIFY(again);
    QTRY_VERIFY(!mark()->isVisible());
    QCOMPARE(again->pixels, plain->pixels);
    QVERIFY(again->statistics.deviceBytes <= plain->statistics.deviceBytes + 4096);
    // Views that have no noise are shown as they are.
    trigger(*window_, QStringLiteral("View/Denoise Preview"));
    trigger(*window_, QStringLiteral("Render/Shader/Normals"));
    QVERIFY(settledFrame([](const Frame& f) { return !f.isDenoised; }));
}

void TestImageExport::overlayCountsWhatIsNoNumber() {
    StatisticsOverlay overlay(nullptr);
    Frame frame = *viewport().lastFrame();
    overlay.show(std::make_shared<Frame>(frame), 0.0);
    QVERIFY(!overlay.text().contains(QStringLiteral("without a number")));
    frame.statistics.nonFinitePixels = 17;
    overlay.show(std::make_shared<Frame>(frame), 0.0);
    QVERIFY(overlay.text().contains(QStringLiteral("Pixels without a number\t\t17")));
}

void TestImageExport::pausingKeepsTheSamples() {
    window_->document().edit(QStringLiteral("More"), [](Scene& s) { s.render.samples = 100000; });
    QTRY_VERIFY_WITH_TIMEOUT(
        viewport().lastFrame()->samples > 5 && viewport().lastFrame()->sampleLimit == 100000, 20000);
    trigger(*window_, QStringLiteral("View/Pause Rendering"));
    QTest::qWait(500);
    const int samples = viewport().lastFrame()->samples;
    QVERIFY(samples > 5);
    QVERIFY(QFileInfo::exists(save(QStringLiteral("paused.png"), PictureFormat::Png8)));
    trigger(*window_, QStringLiteral("View/Pause Rendering"));
    QTRY_VERIFY_WITH_TIMEOUT(viewport().lastFrame()->samples != samples, 20000);
    QVERIFY(viewport().lastFrame()->samples > samples);
    QVERIFY(
        window_->findChild<QLabel*>(QStringLiteral("samples"))->text().contains(QStringLiteral("of 100000")));
}

void TestImageExport::dialogOffersTheFormats() {
    trigger(*window_, QStringLiteral("File/Export Image"));
    auto* dialog = window_->findChild<QFileDialog*>(QStringLiteral("exportImage"));
    QVERIFY(dialog);
    QCOMPARE(dialog->nameFilters().size(), 3);
    QCOMPARE(dialog->defaultSuffix(), QStringLiteral("png"));
    const QString exr = dialog->nameFilters().at(2);
    dialog->selectNameFilter(exr);
    Q_EMIT dialog->filterSelected(exr); // as choosing it in the list does
    QCOMPARE(dialog->defaultSuffix(), QStringLiteral("exr"));
    QVERIFY(dialog->selectedFiles().value(0).endsWith(QStringLiteral(".exr")));
    dialog->reject();
}

void TestImageExport::faultIsTold() {
    QVERIFY(save(QStringLiteral("no/such/folder/x.png"), PictureFormat::Png8).isEmpty());
}

QTEST_MAIN(TestImageExport)
#include "tst_image_export.moc"
