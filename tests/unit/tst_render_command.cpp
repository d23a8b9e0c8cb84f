// `prizma-render render --frames`: sequences as scripts and render farms make them.
#include "tests/support/command_line.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace prizma::test;

namespace {

QByteArray contentOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class RenderCommandTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void framesAreNumbered();
    void finishedFramesAreNotRenderedAgain();
    void clipsAreChosenBySet();
    void faultsAreOneLine_data();
    void faultsAreOneLine();
    void depthAndViewReachTheFile();
    void denoisingIsForTheScreen();
    void videoFollowsTheFrames();
    void missingEncoderIsSaidBeforeRendering();

  private:
    /// A tiny picture of the bending strip.
    QStringList arguments(const QStringList& more) const {
        return QStringList{"render", bend_,   "--width", "32",       "--height",
                           "24",     "--spp", "1",       "--shader", "normals"} +
               more;
    }

    const QString bend_ = QStringLiteral(PRIZMA_TEST_DATA "/bend.gltf");
};

void RenderCommandTest::initTestCase() {
    if (runCommand({"devices"}).exitCode != 0)
        QSKIP("There is no OpenCL device here.");
}

void RenderCommandTest::framesAreNumbered() {
    const QTemporaryDir folder;
    const CommandResult result = runCommand(arguments(
        {"--frames", "8-11", "-o", folder.filePath("f_###.png"), "--set", "objects.bend.clip=bend"}));
    QVERIFY2(result.exitCode == 0, result.errors);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
             QStringList({"f_008.png", "f_009.png", "f_010.png", "f_011.png"}));
    QVERIFY(contentOf(folder.filePath("f_008.png")) != contentOf(folder.filePath("f_011.png")));
    // A frame of a sequence is the picture that --frame gives.
    QCOMPARE(runCommand(arguments({"--frame", "10", "-o", folder.filePath("one.png"), "--set",
                                   "objects.bend.clip=bend"}))
                 .exitCode,
             0);
    QCOMPARE(contentOf(folder.filePath("one.png")), contentOf(folder.filePath("f_010.png")));
}

void RenderCommandTest::finishedFramesAreNotRenderedAgain() {
    const QTemporaryDir folder;
    QFile marker(folder.filePath("f_0001.png"));
    QVERIFY(marker.open(QIODevice::WriteOnly));
    marker.write("there");
    marker.close();
    const QStringList frames{"--frames", "0-2", "-o", folder.filePath("f_####.png")};
    QCOMPARE(runCommand(arguments(frames)).exitCode, 0);
    QCOMPARE(contentOf(marker.fileName()), QByteArray("there"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 3);
    QCOMPARE(runCommand(arguments(frames + QStringList{"--overwrite"})).exitCode, 0);
    QVERIFY(contentOf(marker.fileName()).startsWith("\x89PNG"));
}

void RenderCommandTest::clipsAreChosenBySet() {
    const QTemporaryDir folder;
    const auto picture = [&](const QStringList& sets) {
        QStringList more{"--frame", "10", "-o", folder.filePath("a.png")};
        for (const QString& set : sets)
            more += QStringList{"--set", set};
        return runCommand(arguments(more)).exitCode == 0 ? contentOf(folder.filePath("a.png")) : QByteArray();
    };
    const QByteArray bent = picture({"objects.bend.clip=bend"});
    QVERIFY(!bent.isEmpty());
    QVERIFY(bent != picture({"objects.bend.clip="}));
    QVERIFY(bent != picture({"objects.bend.clip=bend", "objects.bend.clipSpeed=2"}));
    // Twice the frame rate from half a second earlier is the same moment: 10/30 s · 60 - 10 = 10.
    QCOMPARE(picture({"objects.bend.clip=bend", "objects.bend.clipFps=60",
                      "objects.bend.clipOffset=-0.16666666666666666"}),
             bent);
    QVERIFY(picture({"objects.bend.clip=walk"}).isEmpty());
}

void RenderCommandTest::faultsAreOneLine_data() {
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QString>("word");
    QTest::newRow("no number") << QStringList{"--frames", "0-2", "-o", "f.png"} << "####";
    QTest::newRow("backwards") << QStringList{"--frames", "5-2", "-o", "f_##.png"} << "FIRST-LAST";
    QTest::newRow("no range") << QStringList{"--frames", "five", "-o", "f_##.png"} << "FIRST-LAST";
    QTest::newRow("no folder") << QStringList{"--frames", "0-2", "-o", "/nowhere/f_##.png"} << "/nowhere";
    QTest::newRow("video of EXRs") << QStringList{"--frames", "0-2", "-o", "f_##.exr", "--video", "a.mp4"}
                                   << ".png";
    QTest::newRow("video of another kind")
        << QStringList{"--frames", "0-2", "-o", "f_##.png", "--video", "a.avi"} << ".mp4";
}

void RenderCommandTest::faultsAreOneLine() {
    QFETCH(QStringList, more);
    QFETCH(QString, word);
    const CommandResult result = runCommand(arguments(more));
    QCOMPARE(result.exitCode, 1);
    QCOMPARE(result.errors.count('\n'), 1);
    QVERIFY2(QString::fromUtf8(result.errors).contains(word), result.errors);
}

void RenderCommandTest::depthAndViewReachTheFile() {
    const QTemporaryDir folder;
    const auto picture = [&](const QStringList& more) {
        const QString file = folder.filePath("p.png");
        return runCommand(arguments(QStringList{"-o", file, "--set", "render.shader=whitted"} + more))
                           .exitCode == 0
                   ? contentOf(file)
                   : QByteArray();
    };
    const QByteArray plain = picture({});
    const QByteArray deep = picture({"--depth", "16"});
    const QByteArray filmic = picture({"--set", "render.viewTransform=filmic"});
    QVERIFY(plain.size() > 33 && deep.size() > 33);
    // A PNG's header says how many bits a channel has; the chunk after it which colours they mean.
    QCOMPARE(static_cast<int>(plain[24]), 8);
    QCOMPARE(static_cast<int>(deep[24]), 16);
    for (const QByteArray& file : {plain, deep, filmic})
        QVERIFY(file.contains("sRGB"));
    QVERIFY(!filmic.isEmpty() && filmic != plain);
    QVERIFY(picture({"--depth", "12"}).isEmpty());
    const CommandResult exr = runCommand(arguments({"-o", folder.filePath("p.exr"), "--depth", "16"}));
    QCOMPARE(exr.exitCode, 1);
    QVERIFY(exr.errors.contains("--depth"));
}

void RenderCommandTest::denoisingIsForTheScreen() {
    const QTemporaryDir folder;
    const auto picture = [&](const QString& denoise) {
        const QString file = folder.filePath("p.png");
        return runCommand(arguments({"-o", file, "--set", "render.shader=whitted", "--set",
                                     "render.denoise=" + denoise}))
                           .exitCode == 0
                   ? contentOf(file)
                   : QByteArray();
    };
    QVERIFY(!picture("false").isEmpty());
    QCOMPARE(picture("true"), picture("false"));
}

void RenderCommandTest::videoFollowsTheFrames() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty())
        QSKIP("ffmpeg is not installed.");
    const QTemporaryDir folder;
    const QString video = folder.filePath("film.mp4");
    const CommandResult result =
        runCommand(arguments({"--frames", "0-5", "-o", folder.filePath("f_##.png"), "--video", video}));
    QVERIFY2(result.exitCode == 0, result.errors);
    QVERIFY(QFile(video).size() > 500);
}

void RenderCommandTest::missingEncoderIsSaidBeforeRendering() {
    const QTemporaryDir folder;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", folder.path());
    const CommandResult result = runCommand(arguments({"--frames", "0-5", "-o", folder.filePath("f_##.png"),
                                                       "--video", folder.filePath("film.mp4")}),
                                            environment);
    QCOMPARE(result.exitCode, 1);
    QVERIFY(result.errors.contains("ffmpeg"));
    QVERIFY(QDir(folder.path()).isEmpty());
}

QTEST_GUILESS_MAIN(RenderCommandTest)
#include "tst_render_command.moc"
