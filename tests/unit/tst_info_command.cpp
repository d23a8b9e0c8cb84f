// `prizma-render info` as scripts use it: the real program, its JSON and its exit code.
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

QString assetFolder() {
    const QString given = qEnvironmentVariable("PRIZMA_ASSETS");
    return given.isEmpty() ? QStringLiteral(PRIZMA_SOURCE_DIR "/../shared/assets") : given;
}

struct Answer {
    int exitCode = -1;
    QJsonObject json;
    QString error;
};

Answer info(QStringList files) {
    QProcess program;
    program.start(QStringLiteral(PRIZMA_RENDER_PROGRAM), QStringList{"info", "--json"} + files);
    program.waitForFinished(60'000);
    Answer answer;
    if (program.exitStatus() == QProcess::NormalExit)
        answer.exitCode = program.exitCode();
    answer.json = QJsonDocument::fromJson(program.readAllStandardOutput()).object();
    answer.error = QString::fromUtf8(program.readAllStandardError());
    return answer;
}

QString data(const QString& name) {
    return QStringLiteral(PRIZMA_TEST_DATA "/smd/") + name;
}

} // namespace

class TestInfoCommand : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void scriptWithSequences() {
        const Answer answer = info({data("arm.qc")});
        QCOMPARE(answer.exitCode, 0);
        QCOMPARE(answer.json["triangles"].toInt(), 3);
        QCOMPARE(answer.json["bones"].toInt(), 3);
        QCOMPARE(answer.json["maxWeights"].toInt(), 2);
        const QJsonArray clips = answer.json["clips"].toArray();
        QCOMPARE(clips.size(), 3);
        QCOMPARE(clips[0].toObject()["name"].toString(), QString("wave"));
        QCOMPARE(clips[0].toObject()["frames"].toInt(), 3);
        QCOMPARE(clips[0].toObject()["fps"].toDouble(), 12.0);
        QCOMPARE(answer.json["textures"].toArray().size(), 2);
        for (const auto& texture : answer.json["textures"].toArray())
            QVERIFY(texture.toObject()["found"].toBool());
        QVERIFY(!answer.json["warnings"].toArray().isEmpty());
    }

    void modelWithAnimations() {
        for (const QStringList& files : {QStringList{data("arm.smd"), data("wave.smd")},
                                         QStringList{data("wave.smd"), data("arm.smd")}}) {
            const Answer answer = info(files);
            QVERIFY2(answer.exitCode == 0, qPrintable(answer.error));
            QCOMPARE(answer.json["objects"].toArray().size(), 1);
            QCOMPARE(answer.json["clips"].toArray().size(), 1);
            QCOMPARE(answer.json["clips"].toArray()[0].toObject()["name"].toString(), QString("wave"));
        }
    }

    void bareModelStandsUpright() {
        const QJsonArray high = info({data("arm.smd")}).json["bounds"].toObject()["high"].toArray();
        QVERIFY(std::abs(high[1].toDouble() - 1.0) < 1e-6); // Z of the file
    }

    void faultsAreOneLine_data() {
        QTest::addColumn<QStringList>("files");
        QTest::addColumn<QString>("word");
        QTest::newRow("animation alone") << QStringList{data("wave.smd")} << "animation";
        QTest::newRow("missing") << QStringList{data("none.smd")} << "no such file";
        QTest::newRow("foreign animation")
            << QStringList{data("arm.smd"), data("none.md5anim")} << "no such file";
    }
    void faultsAreOneLine() {
        QFETCH(QStringList, files);
        QFETCH(QString, word);
        const Answer answer = info(files);
        QCOMPARE(answer.exitCode, 1);
        QCOMPARE(answer.error.count('\n'), 1);
        QVERIFY2(answer.error.contains(word), qPrintable(answer.error));
    }

    void everyDamageEndsWell() {
        QTemporaryDir folder;
        QFile whole(data("arm.smd"));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray text = whole.readAll();
        for (int part = 0; part < 12; ++part) {
            QFile cut(folder.filePath("cut.smd"));
            QVERIFY(cut.open(QIODevice::WriteOnly | QIODevice::Truncate));
            cut.write(text.left(text.size() * part / 12));
            cut.close();
            const Answer answer = info({cut.fileName()});
            QCOMPARE(answer.exitCode, 1);
            QVERIFY(answer.error.contains("cut.smd"));
        }
    }

    void sharedModels() {
        if (!QDir(assetFolder() + "/smd").exists())
            QSKIP("the shared assets are not here");
        const Answer robot = info({assetFolder() + "/smd/robot/robot.qc"});
        QCOMPARE(robot.json["triangles"].toInt(), 3238);
        QCOMPARE(robot.json["clips"].toArray().size(), 14);
        const Answer greenman = info({assetFolder() + "/smd/greenman/greenman_ref.smd",
                                      assetFolder() + "/smd/greenman/anims/1_idle.smd"});
        QCOMPARE(greenman.json["maxWeights"].toInt(), 4);
        QCOMPARE(greenman.json["clips"].toArray()[0].toObject()["frames"].toInt(), 61);
        QVERIFY(greenman.json["textures"].toArray()[0].toObject()["found"].toBool());
    }
};

QTEST_GUILESS_MAIN(TestInfoCommand)
#include "tst_info_command.moc"
