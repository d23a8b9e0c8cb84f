// `prizma-render pose`: what scripts get, against positions that others computed from the originals of the
// models.
#include "tests/support/command_line.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <cmath>
#include <vector>

using namespace prizma::test;

namespace {

using Point = std::array<double, 3>;

QString assetFolder() {
    const QString given = qEnvironmentVariable("PRIZMA_ASSETS");
    return (given.isEmpty() ? QStringLiteral(PRIZMA_SOURCE_DIR "/../shared/assets") : given) + "/smd/";
}

bool hasAssets() {
    return QDir(assetFolder()).exists();
}

/// Lines x,y,z; one that begins with # is a remark. Empty if any other line is something else.
std::vector<Point> readCsv(const QString& name) {
    QFile file(name);
    std::vector<Point> points;
    if (!file.open(QIODevice::ReadOnly))
        return points;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine().trimmed();
        if (line.startsWith('#'))
            continue;
        const auto fields = line.split(',');
        if (fields.size() != 3)
            return {};
        Point point{};
        for (qsizetype i = 0; i < 3; ++i) {
            bool ok = false;
            point[static_cast<std::size_t>(i)] = fields[i].toDouble(&ok);
            if (!ok)
                return {};
        }
        points.push_back(point);
    }
    return points;
}

double distance(const Point& a, const Point& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double sizeOf(const std::vector<Point>& points) {
    Point low = points.front();
    Point high = low;
    for (const Point& point : points)
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    return distance(low, high);
}

} // namespace

class PoseCommandTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void agreesWithTheOriginals_data();
    void agreesWithTheOriginals();
    void bothWaysOfGivingAnimationsAgree();
    void upAxisDoesNotChangeTheFilesSpace();
    void bendsInTheMiddle();
    void withoutClipItIsTheBindPose();
    void objIsReadAgain();
    void faultsAreOneLine_data();
    void faultsAreOneLine();

  private:
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
    const QString bend_ = QStringLiteral(PRIZMA_TEST_DATA "/bend.gltf");
};

void PoseCommandTest::initTestCase() {
    const CommandResult devices = runCommand({"devices"});
    if (devices.exitCode != 0)
        QSKIP("There is no OpenCL device here.");
}

void PoseCommandTest::agreesWithTheOriginals_data() {
    QTest::addColumn<QStringList>("files");
    QTest::addColumn<QString>("clip");
    QTest::addColumn<QString>("frame");
    QTest::addColumn<QString>("expected");
    const auto row = [](const QString& model, const QString& clip, const QString& frame) {
        const QString folder = assetFolder() + model + "/";
        const QString expected = folder + "expected/" + clip + "_frame" + frame + ".csv";
        const QString name = model + " " + clip + " " + frame;
        QTest::newRow(qPrintable(name + " from SMDs"))
            << QStringList{folder + model + "_ref.smd", folder + "anims/" + clip + ".smd"} << clip << frame
            << expected;
        QTest::newRow(qPrintable(name + " from a QC"))
            << QStringList{folder + model + ".qc"} << clip << frame << expected;
    };
    row("greenman", "1_idle", "20");
    row("greenman", "1_idle", "40");
    row("robot", "Death", "8");
    row("robot", "Death", "16");
}

void PoseCommandTest::agreesWithTheOriginals() {
    if (!hasAssets())
        QSKIP("The shared assets are not here.");
    QFETCH(QStringList, files);
    QFETCH(QString, clip);
    QFETCH(QString, frame);
    QFETCH(QString, expected);
    const QString out = path("posed.csv");
    const CommandResult result =
        runCommand(QStringList{"pose"} + files + QStringList{"--clip", clip, "--frame", frame, "-o", out});
    QVERIFY2(result.exitCode == 0, result.errors);
    const auto posed = readCsv(out);
    const auto truth = readCsv(expected);
    QVERIFY(!truth.empty());
    QCOMPARE(posed.size(), truth.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        worst = std::max(worst, distance(posed[i], truth[i]));
    const double share = worst / sizeOf(truth);
    qInfo("worst corner: %.2g of the size", share);
    QVERIFY2(share < 1e-4, QByteArray::number(share));
}

void PoseCommandTest::bothWaysOfGivingAnimationsAgree() {
    if (!hasAssets())
        QSKIP("The shared assets are not here.");
    const QString robot = assetFolder() + "robot/";
    const QStringList pose{"--clip", "Walking", "--frame", "4.5"};
    const QString model = robot + "robot_ref.smd";
    const QString animation = robot + "anims/Walking.smd";
    QCOMPARE(runCommand(QStringList{"pose", model, animation, "-o", path("a.csv")} + pose).exitCode, 0);
    QCOMPARE(
        runCommand(QStringList{"pose", model, "--animation", animation, "-o", path("b.csv")} + pose).exitCode,
        0);
    QVERIFY(!readCsv(path("a.csv")).empty());
    QCOMPARE(readCsv(path("a.csv")), readCsv(path("b.csv")));
}

void PoseCommandTest::upAxisDoesNotChangeTheFilesSpace() {
    QCOMPARE(runCommand({"pose", bend_, "--clip", "bend", "--frame", "12", "-o", path("y.csv")}).exitCode, 0);
    QCOMPARE(runCommand({"pose", bend_, "--clip", "bend", "--frame", "12", "--up", "z", "-o", path("z.csv")})
                 .exitCode,
             0);
    const auto y = readCsv(path("y.csv"));
    const auto z = readCsv(path("z.csv"));
    QCOMPARE(y.size(), std::size_t(24));
    QCOMPARE(z.size(), y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        QVERIFY(distance(y[i], z[i]) < 1e-5);
}

/// At the last frame the strip's second half has turned by a right angle, whose axis is Z.
void PoseCommandTest::bendsInTheMiddle() {
    const CommandResult result =
        runCommand({"pose", bend_, "--clip", "bend", "--frame", "30", "--json", "-o", path("bent.csv")});
    QCOMPARE(result.exitCode, 0);
    QCOMPARE(result.json()["vertices"].toInt(), 10);
    QCOMPARE(result.json()["triangles"].toInt(), 8);
    QCOMPARE(result.json()["clip"].toString(), QString("bend"));
    QCOMPARE(
        runCommand({"pose", bend_, "--clip", "bend", "--frame", "0", "-o", path("straight.csv")}).exitCode,
        0);
    const auto bent = readCsv(path("bent.csv"));
    const auto straight = readCsv(path("straight.csv"));
    QCOMPARE(bent.size(), straight.size());
    double moved = 0.0;
    for (std::size_t i = 0; i < bent.size(); ++i)
        moved = std::max(moved, distance(bent[i], straight[i]));
    // The tip lies 1 beyond the joint (the model is scaled by 2): a quarter turn takes it 2·√2 away.
    QVERIFY2(moved > 2.0 && moved < 3.2, QByteArray::number(moved));
}

void PoseCommandTest::withoutClipItIsTheBindPose() {
    QCOMPARE(runCommand({"pose", bend_, "-o", path("bind.csv")}).exitCode, 0);
    QCOMPARE(runCommand({"pose", bend_, "--clip", "bend", "--frame", "0", "-o", path("first.csv")}).exitCode,
             0);
    const auto bind = readCsv(path("bind.csv"));
    const auto first = readCsv(path("first.csv"));
    QCOMPARE(bind.size(), first.size());
    for (std::size_t i = 0; i < bind.size(); ++i)
        QVERIFY(distance(bind[i], first[i]) < 1e-5); // the clip begins there
}

void PoseCommandTest::objIsReadAgain() {
    QCOMPARE(runCommand({"pose", bend_, "--clip", "bend", "--frame", "30", "-o", path("bent.obj")}).exitCode,
             0);
    const CommandResult info = runCommand({"info", path("bent.obj"), "--json"});
    QCOMPARE(info.exitCode, 0);
    QCOMPARE(info.json()["triangles"].toInt(), 8);
    const CommandResult pose =
        runCommand({"pose", bend_, "--clip", "bend", "--frame", "30", "--json", "-o", path("again.csv")});
    for (const char* end : {"low", "high"})
        for (int axis = 0; axis < 3; ++axis) {
            const auto of = [&](const CommandResult& result) {
                return result.json()["bounds"].toObject()[end].toArray()[axis].toDouble();
            };
            QVERIFY(std::abs(of(info) - of(pose)) < 1e-5);
        }
}

void PoseCommandTest::faultsAreOneLine_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("word");
    const QString out = path("fault.csv");
    QTest::newRow("no such file") << QStringList{"nothing.smd", "-o", out} << "nothing.smd";
    QTest::newRow("no such clip") << QStringList{bend_, "--clip", "walk", "-o", out} << "bend";
    QTest::newRow("frame beyond the end")
        << QStringList{bend_, "--clip", "bend", "--frame", "31", "-o", out} << "0 to 30";
    QTest::newRow("frame before the start")
        << QStringList{bend_, "--clip", "bend", "--frame", "-1", "-o", out} << "0 to 30";
    QTest::newRow("other extension") << QStringList{bend_, "-o", path("fault.txt")} << ".csv";
    QTest::newRow("no such object") << QStringList{bend_, "--object", "tree", "-o", out} << "tree";
    QTest::newRow("no such folder") << QStringList{bend_, "-o", path("no/folder/a.csv")} << "a.csv";
}

void PoseCommandTest::faultsAreOneLine() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, word);
    const CommandResult result = runCommand(QStringList{"pose"} + arguments);
    QCOMPARE(result.exitCode, 1);
    QCOMPARE(result.output, QByteArray());
    QCOMPARE(result.errors.count('\n'), 1);
    QVERIFY2(QString::fromUtf8(result.errors).contains(word), result.errors);
    QVERIFY(!QFile::exists(path("fault.csv")));
}

QTEST_GUILESS_MAIN(PoseCommandTest)
#include "tst_pose_command.moc"
