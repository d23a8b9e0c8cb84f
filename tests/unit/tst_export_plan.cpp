#include "core/render/animation_export.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace prizma;

class TestExportPlan : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void picturesGoWhereTheyAreWanted();
    void picturesOfAVideoLieBesideIt();
    void faultsAreFound();
    void finishedFramesAreCounted();

  private:
    std::string path(const char* name) const {
        return folder_.filePath(QString::fromLatin1(name)).toStdString();
    }
    AnimationExport animation(AnimationFormat format, const char* name) const {
        AnimationExport wanted;
        wanted.format = format;
        wanted.first = -2;
        wanted.last = 3;
        wanted.output = path(name);
        return wanted;
    }

    QTemporaryDir folder_;
};

void TestExportPlan::picturesGoWhereTheyAreWanted() {
    const SequenceOptions sequence = sequenceOf(animation(AnimationFormat::Exr, "a_###.exr"));
    QCOMPARE(sequence.output, path("a_###.exr"));
    QCOMPARE(sequence.first, -2);
    QCOMPARE(sequence.last, 3);
    QVERIFY(!sequence.overwrite);
}

void TestExportPlan::picturesOfAVideoLieBesideIt() {
    for (const AnimationFormat format : {AnimationFormat::Mp4, AnimationFormat::WebM}) {
        const std::string name = "walk." + std::string(extensionOf(format));
        const SequenceOptions sequence = sequenceOf(animation(format, name.c_str()));
        QCOMPARE(sequence.output, path(name.c_str()) + ".frames/####.png");
    }
}

void TestExportPlan::faultsAreFound() {
    QCOMPARE(findFault(animation(AnimationFormat::Png, "a_####.png")), std::string());
    QVERIFY(!findFault(animation(AnimationFormat::Png, "a_####.exr")).empty());
    QVERIFY(!findFault(animation(AnimationFormat::Png, "a.png")).empty());
    QVERIFY(!findFault(animation(AnimationFormat::Png, "no/such/folder/a_####.png")).empty());
    AnimationExport backwards = animation(AnimationFormat::Png, "a_####.png");
    backwards.last = backwards.first - 1;
    QVERIFY(!findFault(backwards).empty());
    QVERIFY(!findFault(animation(AnimationFormat::Mp4, "a.webm")).empty());
    // The folder of a video's pictures need not be there: it is made.
    QCOMPARE(findFault(animation(AnimationFormat::Mp4, "a.mp4")).empty(), isVideoEncoderInstalled());
    QVERIFY(!findFault(animation(AnimationFormat::Mp4, "no/such/folder/a.mp4")).empty());
}

void TestExportPlan::finishedFramesAreCounted() {
    AnimationExport wanted = animation(AnimationFormat::Png, "b_####.png");
    QCOMPARE(finishedFrames(wanted), 0);
    for (const int frame : {-2, 0, 3, 4}) { // 4 is none of them
        QFile file(QString::fromStdString(frameFile(wanted.output, frame)));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }
    QCOMPARE(finishedFrames(wanted), 3);
    wanted.overwrite = true;
    QCOMPARE(finishedFrames(wanted), 0);
}

QTEST_APPLESS_MAIN(TestExportPlan)
#include "tst_export_plan.moc"
