// `prizma-render bench`: the keys that scripts rely on, with values that make sense, on small scenes.
#include "core/compute/context.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

using namespace prizma;

namespace {

/// What a bench subcommand prints as JSON; empty if it fails.
QJsonObject bench(QStringList arguments) {
    arguments.prepend("bench");
    arguments.append({"--json", "--repeats", "2"});
    QProcess process;
    process.start(PRIZMA_RENDER_PROGRAM, arguments);
    if (!process.waitForFinished(120000) || process.exitCode() != 0)
        qWarning("%s", process.readAllStandardError().constData());
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object();
}

bool isPositive(const QJsonValue& value) {
    return value.isDouble() && value.toDouble() > 0.0;
}

/// A ratio of ours to Embree's that belongs to the values beside it.
bool ratioIsRight(const QJsonObject& report, const char* embreeKey) {
    if (!report.contains("embree"))
        return !report.contains("ratio"); // built without it
    const double theirs = report["embree"].toObject()[embreeKey].toDouble();
    const double expected = report["milliseconds"].toDouble() / theirs;
    return theirs > 0.0 && std::abs(report["ratio"].toDouble() - expected) < 1e-6 * expected;
}

} // namespace

class BenchCommandTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void trace();
    void frame();
    void build();
    void refit();
    void ruin();
    void growth();
    void wrongArgumentsAreErrors();

  private:
    void checkTrace(const QJsonObject& report);
};

void BenchCommandTest::initTestCase() {
    if (!Context::create({}))
        QSKIP("There is no OpenCL device here.");
}

void BenchCommandTest::checkTrace(const QJsonObject& report) {
    QVERIFY(!report["device"].toString().isEmpty());
    QVERIFY(isPositive(report["triangles"]));
    QVERIFY(isPositive(report["deviceBytes"]));
    const QJsonArray results = report["results"].toArray();
    QCOMPARE(results.size(), 3);
    QStringList rays;
    for (const QJsonValue& value : results) {
        const QJsonObject result = value.toObject();
        rays << result["rays"].toString();
        QVERIFY(isPositive(result["mraysPerSecond"]));
        QVERIFY(result["mismatches"].isDouble());
        QCOMPARE(result["wrong"].toInt(-1), 0);
        QCOMPARE(result.contains("ratioRobust"), result.contains("embree"));
    }
    QCOMPARE(rays, (QStringList{"camera", "diffuse", "shadow"}));
}

void BenchCommandTest::trace() {
    checkTrace(bench({"trace", "--triangles", "3000", "--width", "64", "--height", "64"}));
    checkTrace(bench({"trace", "--instanced", "--triangles", "3000", "--width", "64", "--height", "64"}));
}

void BenchCommandTest::frame() {
    const QJsonObject report = bench({"frame", "--triangles", "3000", "--width", "64", "--height", "48"});
    QVERIFY(std::abs(report["triangles"].toDouble() - 3000) < 500);
    const QJsonArray frames = report["frames"].toArray();
    QCOMPARE(frames.size(), 2);
    for (const QJsonValue& value : frames) {
        const QJsonObject frame = value.toObject();
        for (const char* key : {"milliseconds", "framesPerSecond", "raysMilliseconds", "ratio"})
            QVERIFY2(isPositive(frame[key]), key);
        QCOMPARE(frame["nonFinitePixels"].toInt(-1), 0);
        double sum = 0.0;
        double shadow = 0.0;
        for (const QJsonValue& set : frame["rays"].toArray()) {
            const QString name = set.toObject()["rays"].toString();
            const double count = set.toObject()["count"].toDouble();
            if (name == "camera")
                QCOMPARE(count, 64.0 * 48.0);
            shadow += name.startsWith("shadow") ? count : 0.0;
            sum += set.toObject()["milliseconds"].toDouble();
        }
        QVERIFY(shadow > 64.0 * 48.0 / 2); // a closed room: every pixel asks for the light, if it faces it
        QVERIFY(std::abs(sum - frame["raysMilliseconds"].toDouble()) < 1e-6 * sum);
        QVERIFY(std::abs(frame["ratio"].toDouble() * sum - frame["milliseconds"].toDouble()) < 1e-6 * sum);
    }
    QCOMPARE(frames[0].toObject()["shader"].toString(), "whitted");
    QCOMPARE(frames[1].toObject()["shader"].toString(), "path");
}

void BenchCommandTest::build() {
    for (const char* layout : {"wide8", "binary2"}) {
        const QJsonObject report = bench({"build", "--triangles", "20000", "--layout", layout});
        QVERIFY(std::abs(report["triangles"].toDouble() - 20000) < 1000);
        for (const char* key : {"milliseconds", "bytesPerTriangle", "sahCost", "depth"})
            QVERIFY2(isPositive(report[key]), key);
        QVERIFY(ratioIsRight(report, "medium"));
    }
}

void BenchCommandTest::refit() {
    for (const char* layout : {"wide8", "binary2"})
        for (const QStringList& scene :
             {QStringList{"--triangles", "20000"}, QStringList{"--triangles", "20000", "--instanced"}}) {
            const QJsonObject report = bench(QStringList{"refit", "--layout", layout} + scene);
            QVERIFY(std::abs(report["triangles"].toDouble() - 20000) < 1000);
            for (const char* key : {"milliseconds", "triangleShader", "refitTreeShader", "vertexShader"})
                QVERIFY2(isPositive(report[key]), key);
            QVERIFY(ratioIsRight(report, "refit"));
        }
}

void BenchCommandTest::ruin() {
    const QJsonObject report = bench({"refit", "--ruin", "--triangles", "3000", "--parts", "20"});
    const QJsonArray steps = report["steps"].toArray();
    QVERIFY(steps.size() > 3);
    const auto wear = [&](qsizetype i) { return steps[i].toObject()["wear"].toDouble(); };
    QVERIFY(std::abs(wear(0) - 1.0) < 0.01); // not yet flown
    QVERIFY(wear(steps.size() - 1) > 10.0);
    for (const char* key : {"frame", "start", "swap", "build"})
        QVERIFY2(isPositive(report["renewal"].toObject()[key]), key);
}

void BenchCommandTest::growth() {
    const QJsonArray sizes = bench({"growth", "--most", "10000"})["sizes"].toArray();
    QCOMPARE(sizes.size(), 2);
    double before = 0.0;
    for (const QJsonValue& value : sizes) {
        const QJsonObject size = value.toObject();
        QVERIFY(size["triangles"].toDouble() > 5.0 * before);
        before = size["triangles"].toDouble();
        QVERIFY(isPositive(size["build"].toObject()["milliseconds"]));
        QVERIFY(isPositive(size["refit"].toObject()["milliseconds"]));
        checkTrace(size["trace"].toObject());
    }
}

void BenchCommandTest::wrongArgumentsAreErrors() {
    for (const QStringList& arguments : {QStringList{"bench", "refit", "no such file.obj"},
                                         QStringList{"bench", "refit", "--layout", "octree"},
                                         QStringList{"bench", "growth", "--most", "0"}}) {
        QProcess process;
        process.start(PRIZMA_RENDER_PROGRAM, arguments);
        QVERIFY(process.waitForFinished(30000));
        QVERIFY(process.exitCode() != 0);
        QVERIFY(!process.readAllStandardError().isEmpty());
    }
}

QTEST_GUILESS_MAIN(BenchCommandTest)
#include "tst_bench_command.moc"
