#include "core/import/image_loader.h"
#include "core/import/image_saver.h"
#include "core/render/picture_sequence.h"
#include "core/render/video_encoder.h"
#include "tests/support/test_scenes.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <thread>

using namespace prizma;
using namespace prizma::test;

namespace {

Scene makeScene() {
    Scene scene;
    addObject(scene, bendingObject());
    scene.camera = {{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 45.0};
    scene.render.shader = ShaderType::Normals;
    return scene;
}

SequenceOptions optionsFor(const QTemporaryDir& folder, int first, int last) {
    SequenceOptions options;
    options.picture.width = 33; // odd: videos want even sizes
    options.picture.height = 25;
    options.picture.samples = 1;
    options.first = first;
    options.last = last;
    options.output = folder.filePath("frame_####.png").toStdString();
    return options;
}

} // namespace

class PictureSequenceTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void frameFiles();
    void faultsAreFoundFirst();
    void framesShowTheirTime();
    void finishedFramesAreLeftOut();
    void overwriteRendersAgain();
    void cancelledRunGoesOn();
    void cancelInsideAPicture();
    void videoFaults();
    void videoHasAllFrames_data();
    void videoHasAllFrames();
    void brokenPictureMakesNoVideo();
    void cancelledVideoLeavesNothing();

  private:
    std::unique_ptr<Renderer> renderer_;
};

void PictureSequenceTest::initTestCase() {
    renderer_ = makeRenderer();
}

void PictureSequenceTest::frameFiles() {
    QCOMPARE(frameFile("a_####.png", 7), std::string("a_0007.png"));
    QCOMPARE(frameFile("a_##.png", 1234), std::string("a_1234.png"));
    QCOMPARE(frameFile("a_####.png", -7), std::string("a_-007.png"));
    QCOMPARE(frameFile("#1/a_#b##.png", 5), std::string("#1/a_#b05.png")); // the last run counts
    QCOMPARE(frameFile("#/a.png", 5), std::string("#/a.png"));             // folders have no numbers
    QCOMPARE(frameFile("a.png", 5), std::string("a.png"));
}

void PictureSequenceTest::faultsAreFoundFirst() {
    const QTemporaryDir folder;
    const SequenceOptions good = optionsFor(folder, 0, 3);
    QCOMPARE(findFault(good), std::string());
    const auto isFaulty = [&](auto&& change) {
        SequenceOptions options = good;
        change(options);
        return !findFault(options).empty();
    };
    QVERIFY(isFaulty([](auto& o) { o.last = -1; }));
    QVERIFY(isFaulty([](auto& o) { o.output = "frame_####.jpg"; }));
    QVERIFY(isFaulty([&](auto& o) { o.output = folder.filePath("frame.png").toStdString(); }));
    QVERIFY(isFaulty([&](auto& o) { o.output = folder.filePath("no folder/####.png").toStdString(); }));
    QVERIFY(!isFaulty([&](auto& o) {
        o.output = folder.filePath("frame.EXR").toStdString();
        o.last = 0;
    }));
}

void PictureSequenceTest::framesShowTheirTime() {
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    const QTemporaryDir folder;
    SequenceOptions options = optionsFor(folder, 3, 6);
    Progress progress;
    std::vector<int> reported;
    const auto summary = renderSequence(*renderer_, makeScene(), options, progress,
                                        [&](const SequenceFrame& frame) { reported.push_back(frame.frame); });
    QVERIFY(summary);
    QCOMPARE(summary->rendered, 4);
    QCOMPARE(summary->skipped, 0);
    QCOMPARE(reported, (std::vector<int>{3, 4, 5, 6}));
    QCOMPARE(progress.fraction(), 1.0);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), // and nothing else: no temporary files
             QStringList({"frame_0003.png", "frame_0004.png", "frame_0005.png", "frame_0006.png"}));
    // Each is the picture that its frame gives by itself.
    Scene scene = makeScene();
    for (int frame = 3; frame <= 6; ++frame) {
        scene.timeline.frame = frame;
        const auto alone = renderOffline(*renderer_, scene, options.picture);
        const auto image = loadImage(frameFile(options.output, frame));
        QVERIFY(alone && image);
        const std::string again = folder.filePath("alone.png").toStdString();
        QVERIFY(savePicture(*alone, again));
        QFile a(QString::fromStdString(again)), b(QString::fromStdString(frameFile(options.output, frame)));
        QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
        QCOMPARE(a.readAll(), b.readAll());
    }
}

void PictureSequenceTest::finishedFramesAreLeftOut() {
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    const QTemporaryDir folder;
    const SequenceOptions options = optionsFor(folder, 0, 4);
    QFile marker(folder.filePath("frame_0002.png"));
    QVERIFY(marker.open(QIODevice::WriteOnly));
    marker.write("finished earlier");
    marker.close();
    Progress progress;
    std::vector<int> skipped;
    const auto summary =
        renderSequence(*renderer_, makeScene(), options, progress, [&](const SequenceFrame& frame) {
            if (!frame.picture)
                skipped.push_back(frame.frame);
        });
    QVERIFY(summary);
    QCOMPARE(summary->rendered, 4);
    QCOMPARE(skipped, std::vector<int>{2});
    QVERIFY(marker.open(QIODevice::ReadOnly));
    QCOMPARE(marker.readAll(), QByteArray("finished earlier"));
}

void PictureSequenceTest::overwriteRendersAgain() {
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    const QTemporaryDir folder;
    SequenceOptions options = optionsFor(folder, 0, 1);
    options.overwrite = true;
    QFile marker(folder.filePath("frame_0001.png"));
    QVERIFY(marker.open(QIODevice::WriteOnly));
    marker.write("finished earlier");
    marker.close();
    Progress progress;
    const auto summary = renderSequence(*renderer_, makeScene(), options, progress);
    QVERIFY(summary);
    QCOMPARE(summary->rendered, 2);
    QVERIFY(loadImage(frameFile(options.output, 1)));
}

void PictureSequenceTest::cancelledRunGoesOn() {
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    const QTemporaryDir folder;
    const SequenceOptions options = optionsFor(folder, 0, 9);
    Progress cancelled;
    const auto broken =
        renderSequence(*renderer_, makeScene(), options, cancelled, [&](const SequenceFrame& frame) {
            if (frame.frame == 3)
                cancelled.cancel();
        });
    QVERIFY(!broken);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 4);
    Progress progress;
    const auto summary = renderSequence(*renderer_, makeScene(), options, progress);
    QVERIFY(summary);
    QCOMPARE(summary->skipped, 4);
    QCOMPARE(summary->rendered, 6);
}

void PictureSequenceTest::cancelInsideAPicture() {
    if (!renderer_)
        QSKIP("There is no OpenCL device here.");
    const QTemporaryDir folder;
    SequenceOptions options = optionsFor(folder, 0, 3);
    options.picture.width = 640;
    options.picture.height = 480;
    options.picture.samples = 100'000; // minutes
    Progress progress;
    const std::jthread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        progress.cancel();
    });
    QElapsedTimer timer;
    timer.start();
    QVERIFY(!renderSequence(*renderer_, makeScene(), options, progress));
    QVERIFY2(timer.elapsed() < 10'000, QByteArray::number(timer.elapsed()));
    QVERIFY(QDir(folder.path()).isEmpty());
    // The renderer is as good as before.
    options = optionsFor(folder, 0, 0);
    Progress second;
    QVERIFY(renderSequence(*renderer_, makeScene(), options, second));
}

void PictureSequenceTest::videoFaults() {
    const VideoOptions good{{"a.png", "b.png"}, 24.0, "out.mp4"};
    QCOMPARE(findFault(good), std::string());
    const auto isFaulty = [&](auto&& change) {
        VideoOptions options = good;
        change(options);
        return !findFault(options).empty();
    };
    QVERIFY(isFaulty([](auto& o) { o.pictures.clear(); }));
    QVERIFY(isFaulty([](auto& o) { o.pictures[1] = "b.exr"; }));
    QVERIFY(isFaulty([](auto& o) { o.output = "out.avi"; }));
    QVERIFY(isFaulty([](auto& o) { o.fps = 0.0; }));
    // Without ffmpeg there is a clear word, and no file.
    const QTemporaryDir folder;
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder.path().toLocal8Bit());
    Progress progress;
    VideoOptions options = good;
    options.output = folder.filePath("out.mp4").toStdString();
    const auto made = encodeVideo(options, progress);
    const bool installed = isVideoEncoderInstalled();
    qputenv("PATH", path);
    QVERIFY(!installed);
    QVERIFY(!made && QString::fromStdString(made.error().message).contains("ffmpeg"));
    QVERIFY(QDir(folder.path()).isEmpty());
}

void PictureSequenceTest::videoHasAllFrames_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("mp4") << "a film.mp4";
    QTest::newRow("webm") << "a film.WEBM";
}

void PictureSequenceTest::videoHasAllFrames() {
    QFETCH(QString, name);
    if (!isVideoEncoderInstalled())
        QSKIP("ffmpeg is not installed.");
    const QTemporaryDir folder;
    VideoOptions options;
    for (int i = 0; i < 10; ++i) {
        std::vector<std::uint8_t> pixels(33 * 25 * 4, static_cast<std::uint8_t>(20 * i));
        for (std::size_t k = 3; k < pixels.size(); k += 4)
            pixels[k] = 255;
        options.pictures.push_back(folder.filePath(QString("%1 #%.png").arg(i)).toStdString());
        QVERIFY(savePng(options.pictures.back(), 33, 25, pixels));
    }
    options.fps = 12.5;
    options.output = folder.filePath(name).toStdString();
    Progress progress;
    const auto made = encodeVideo(options, progress);
    QVERIFY2(made, made ? "" : made.error().message.c_str());
    QCOMPARE(progress.fraction(), 1.0);
    QProcess probe;
    probe.start("ffprobe", {"-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                            "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0",
                            QString::fromStdString(options.output)});
    QVERIFY(probe.waitForFinished());
    QCOMPARE(probe.readAllStandardOutput().trimmed(), QByteArray("34,26,25/2,10"));
}

void PictureSequenceTest::brokenPictureMakesNoVideo() {
    if (!isVideoEncoderInstalled())
        QSKIP("ffmpeg is not installed.");
    const QTemporaryDir folder;
    QFile file(folder.filePath("a.png"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("no picture at all");
    file.close();
    Progress progress;
    VideoOptions options{{file.fileName().toStdString()}, 30.0, folder.filePath("out.mp4").toStdString()};
    const auto made = encodeVideo(options, progress);
    QVERIFY(!made && !made.error().message.empty());
    QVERIFY(!QFile::exists(folder.filePath("out.mp4")));
    options.pictures = {folder.filePath("missing.png").toStdString()};
    QVERIFY(!encodeVideo(options, progress));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"a.png"});
}

void PictureSequenceTest::cancelledVideoLeavesNothing() {
    if (!isVideoEncoderInstalled())
        QSKIP("ffmpeg is not installed.");
    const QTemporaryDir folder;
    const std::string picture = folder.filePath("a.png").toStdString();
    QVERIFY(savePng(picture, 8, 8, std::vector<std::uint8_t>(8 * 8 * 4, 255)));
    Progress progress;
    progress.cancel();
    QVERIFY(!encodeVideo({{picture, picture}, 30.0, folder.filePath("out.mp4").toStdString()}, progress));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"a.png"});
}

QTEST_GUILESS_MAIN(PictureSequenceTest)
#include "tst_picture_sequence.moc"
