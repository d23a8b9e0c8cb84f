// Models of the shared assets, posed by us, against positions that others computed from the originals.
#include "core/animation/pose.h"
#include "core/import/animation_importer.h"
#include "core/import/file_space.h"
#include "core/import/model_importer.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace prizma;

namespace {

QString assetFolder() {
    const QString given = qEnvironmentVariable("PRIZMA_ASSETS");
    return given.isEmpty() ? QStringLiteral(PRIZMA_SOURCE_DIR "/../shared/assets") : given;
}

std::string asset(const QString& name) {
    return (assetFolder() + "/smd/" + name).toStdString();
}

Result<ImportedModel> import(const std::string& file, UpAxis axis = UpAxis::Z, double scale = 1.0) {
    Progress progress;
    return importModel(file, {axis, scale}, progress);
}

std::vector<glm::dvec3> readCsv(const QString& name) {
    QFile file(QString::fromStdString(asset(name)));
    std::vector<glm::dvec3> points;
    if (!file.open(QIODevice::ReadOnly))
        return points;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine();
        const auto numbers = line.split(',');
        if (!line.startsWith('#') && numbers.size() == 3)
            points.emplace_back(numbers[0].toDouble(), numbers[1].toDouble(),
                                numbers[2].trimmed().toDouble());
    }
    return points;
}

/// The corners of all triangles, posed in double precision and brought back into the file's space.
std::vector<glm::dvec3> posedCorners(const Mesh& mesh, const Clip& clip, double frame,
                                     const glm::dmat4& toObject) {
    const auto matrices = skinningMatrices(*mesh.skeleton, poseAtFrame(*mesh.skeleton, clip, frame));
    const glm::dmat4 toFile = glm::inverse(toObject);
    std::vector<glm::dvec3> corners;
    for (const glm::uvec3& triangle : mesh.triangles)
        for (glm::length_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = triangle[i];
            glm::dvec4 sum(0.0);
            for (auto k = mesh.firstInfluence[vertex]; k < mesh.firstInfluence[vertex + 1]; ++k)
                sum +=
                    static_cast<double>(mesh.influences[k].weight) *
                    (glm::dmat4(matrices[mesh.influences[k].bone]) * glm::dvec4(mesh.positions[vertex], 1.0));
            corners.emplace_back(toFile * sum);
        }
    return corners;
}

const Clip* findClip(const std::vector<ClipPtr>& clips, const std::string& name) {
    for (const ClipPtr& clip : clips)
        if (clip->name == name)
            return clip.get();
    return nullptr;
}

std::size_t mostWeights(const Mesh& mesh) {
    std::size_t most = 0;
    for (std::size_t i = 0; i + 1 < mesh.firstInfluence.size(); ++i)
        most = std::max<std::size_t>(most, mesh.firstInfluence[i + 1] - mesh.firstInfluence[i]);
    return most;
}

QStringList textsOf(const Diagnostics& warnings) {
    QStringList texts;
    for (const Diagnostic& warning : warnings)
        texts += QString::fromStdString(warning.message);
    return texts;
}

} // namespace

class TestPosedSmd : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() {
        if (!QDir(assetFolder() + "/smd").exists())
            QSKIP("the shared assets are not here");
    }

    void posedVertices_data() {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("animation");
        QTest::addColumn<QString>("clip");
        QTest::addColumn<double>("frame");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* model, const char* reference, const char* clip, int frame) {
            const QString folder = QString::fromLatin1(model) + "/";
            const QString csv = QString("%1expected/%2_frame%3.csv").arg(folder, clip).arg(frame);
            QTest::addRow("%s.qc %s %d", model, clip, frame)
                << folder + model + ".qc" << QString() << QString(clip) << double(frame) << csv;
            QTest::addRow("%s %s %d", reference, clip, frame)
                << folder + reference << folder + "anims/" + clip + ".smd" << QString(clip) << double(frame)
                << csv;
        };
        row("greenman", "greenman_ref.smd", "1_idle", 20);
        row("greenman", "greenman_ref.smd", "1_idle", 40);
        row("robot", "robot_ref.smd", "Death", 8);
        row("robot", "robot_ref.smd", "Death", 16);
    }
    void posedVertices() {
        QFETCH(QString, model);
        QFETCH(QString, animation);
        QFETCH(QString, clip);
        QFETCH(double, frame);
        QFETCH(QString, expected);
        const auto truth = readCsv(expected);
        QVERIFY(!truth.empty());
        // Turned and scaled as well: the way back must lead to the same points.
        for (const auto& [axis, scale] : {std::pair{UpAxis::Y, 1.0}, {UpAxis::Z, 1.0}, {UpAxis::Z, 0.0254}}) {
            auto imported = import(asset(model), axis, scale);
            QVERIFY2(imported, imported ? "" : describe(imported.error()).c_str());
            auto clips = imported->clips;
            if (!animation.isEmpty()) {
                MeshSource source;
                source.file = asset(model);
                source.upAxis = axis;
                source.unitScale = scale;
                Progress progress;
                const auto added =
                    importAnimation(asset(animation), *imported->mesh->skeleton, source, progress);
                QVERIFY2(added, added ? "" : describe(added.error()).c_str());
                QVERIFY(added->warnings.empty());
                clips = added->clips;
            }
            const Clip* chosen = findClip(clips, clip.toStdString());
            QVERIFY(chosen);
            const auto corners = posedCorners(*imported->mesh, *chosen, frame, fileToObject(axis, scale));
            QCOMPARE(corners.size(), truth.size());
            glm::dvec3 low(1e300);
            glm::dvec3 high(-1e300);
            for (const glm::dvec3& point : truth) {
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
            const double size = glm::length(high - low);
            double worst = 0.0;
            for (std::size_t i = 0; i < truth.size(); ++i)
                worst = std::max(worst, glm::length(corners[i] - truth[i]));
            qInfo("worst distance %.2g of the size", worst / size);
            QVERIFY2(worst < 1e-4 * size, qPrintable(QString::number(worst / size)));
        }
    }

    void counts_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("triangles");
        QTest::addColumn<int>("bones");
        QTest::addColumn<int>("weights");
        QTest::addColumn<int>("clips");
        QTest::addColumn<int>("materials");
        QTest::addColumn<QStringList>("warnings");
        const auto row = [](const char* file, int triangles, int bones, int weights, int clips, int materials,
                            const QStringList& warnings) {
            QTest::newRow(file) << QString(file) << triangles << bones << weights << clips << materials
                                << warnings;
        };
        row("greenman/greenman.qc", 356, 12, 4, 4, 1, {});
        row("greenman/greenman_ref.smd", 356, 12, 4, 0, 1, {});
        row("robot/robot.qc", 3238, 43, 4, 14, 3, {"plain colours: Main, Grey, Black"});
        row("bate/bate.smd", 4992, 3, 1, 0, 1,
            {"skeleton lacks bones, which were put where their parents are: vcabone_idle", "wood"});
        row("bate/bate.qc", 4992, 3, 1, 2, 1,
            {"skeleton lacks bones",
             "animation lacks bones of the model, which keep their bind pose: vcabone_idle",
             "animation lacks bones", "wood"});
        row("small/test_cube.smd", 24, 2, 1, 1, 1,
            {"first frame lacks bones, which were put where they first appear: animated",
             "some frames lack stay where they were: root, animated", "test_cube"});
        row("small/test_obj.smd", 12, 3, 1, 0, 2,
            {"skeleton has no frame", "skeleton lacks bones", "mat_red, mat_blue"});
        row("assimp/WusonSMD.smd", 3732, 1, 1, 0, 1, {"texture is missing"});
        row("assimp/holy_grailref.smd", 896, 1, 1, 0, 1, {});
        row("assimp/triangle.smd", 1, 1, 1, 0, 1, {"none.quak"});
    }
    void counts() {
        QFETCH(QString, file);
        QFETCH(int, triangles);
        QFETCH(int, bones);
        QFETCH(int, weights);
        QFETCH(int, clips);
        QFETCH(int, materials);
        QFETCH(QStringList, warnings);
        const auto model = import(asset(file));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY(findFault(*model->mesh).empty());
        QCOMPARE(model->mesh->triangles.size(), std::size_t(triangles));
        QCOMPARE(model->mesh->skeleton->bones.size(), std::size_t(bones));
        QCOMPARE(mostWeights(*model->mesh), std::size_t(weights));
        QCOMPARE(model->clips.size(), std::size_t(clips));
        QCOMPARE(model->materials.size(), std::size_t(materials));
        const QStringList texts = textsOf(model->warnings);
        QVERIFY2(texts.size() == warnings.size(), qPrintable(texts.join('\n')));
        for (qsizetype i = 0; i < texts.size(); ++i)
            QVERIFY2(texts[i].contains(warnings[i]), qPrintable(texts[i]));
    }

    void everyAnimationPairs() {
        for (const char* name : {"robot", "greenman"}) {
            const auto model = import(asset(QString("%1/%1_ref.smd").arg(name)));
            QVERIFY(model);
            MeshSource source;
            source.file = asset(QString("%1/%1_ref.smd").arg(name));
            source.upAxis = UpAxis::Z;
            const QDir folder(QString::fromStdString(asset(QString("%1/anims").arg(name))));
            for (const QFileInfo& file : folder.entryInfoList({"*.smd"})) {
                const std::string path = file.absoluteFilePath().toStdString();
                QVERIFY(isAnimationFile(path));
                Progress progress;
                const auto animation = importAnimation(path, *model->mesh->skeleton, source, progress);
                QVERIFY2(animation, animation ? "" : describe(animation.error()).c_str());
                QVERIFY(animation->warnings.empty());
                QCOMPARE(animation->clips[0]->tracks.size(), model->mesh->skeleton->bones.size());
            }
            QVERIFY(!isAnimationFile(source.file));
        }
    }

    void texturesAreFound() {
        const auto greenman = import(asset("greenman/greenman.qc"));
        QVERIFY(greenman && greenman->materials[0].baseColorTexture.image);
        const auto grail = import(asset("assimp/holy_grailref.smd"));
        QVERIFY(grail && grail->materials[0].baseColorTexture.image);
    }
};

QTEST_GUILESS_MAIN(TestPosedSmd)
#include "tst_posed_smd.moc"
