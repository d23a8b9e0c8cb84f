#include "core/animation/pose.h"
#include "core/import/animation_importer.h"
#include "core/import/model_importer.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace prizma;

namespace {

QString assetFolder() {
    const QString given = qEnvironmentVariable("PRIZMA_ASSETS");
    return given.isEmpty() ? QStringLiteral(PRIZMA_SOURCE_DIR "/../shared/assets") : given;
}

Result<ImportedModel> import(const std::string& file, const ImportOptions& options = {}) {
    Progress progress;
    return importModel(file, options, progress);
}

bool isSound(const ImportedModel& model) {
    bool sound = findFault(*model.mesh).empty() && model.materials.size() == model.mesh->slots.size();
    for (const glm::vec3& normal : model.mesh->normals)
        sound = sound && std::abs(glm::length(normal) - 1.0F) < 1e-3F;
    for (std::size_t i = 0; sound && i < model.materials.size(); ++i)
        sound = model.materials[i].name == model.mesh->slots[i];
    return sound;
}

const Material* findMaterial(const ImportedModel& model, const std::string& name) {
    for (const Material& material : model.materials)
        if (material.name == name)
            return &material;
    return nullptr;
}

} // namespace

class TestImport : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const {
        return folder_.filePath(QString::fromUtf8(name)).toStdString();
    }

    std::string write(const char* name, const QByteArray& content) const {
        QFile stream(folder_.filePath(QString::fromUtf8(name)));
        if (!stream.open(QIODevice::WriteOnly) || stream.write(content) != content.size())
            qFatal("no test file");
        return path(name);
    }

    std::string data(const char* name) const { return std::string(PRIZMA_TEST_DATA) + "/" + name; }

    std::string asset(const char* name) const { return assetFolder().toStdString() + "/obj/" + name; }

  private Q_SLOTS:
    void materialsOfMtl() {
        const auto model = import(data("materials.obj"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY(isSound(*model));
        const auto* matt = findMaterial(*model, "matt paint");
        QVERIFY(matt && matt->specular == 0.0 && std::abs(matt->baseColor.x - 0.25) < 1e-6);
        const auto* shiny = findMaterial(*model, "shiny");
        QVERIFY(shiny && std::abs(shiny->roughness - std::pow(2.0 / 100.0, 0.25)) < 1e-6 &&
                shiny->specular > 0.49);
        const auto* mirror = findMaterial(*model, "mirror");
        QVERIFY(mirror && mirror->metallic == 1.0 && mirror->roughness == 0.0 && mirror->baseColor.x > 0.94);
        const auto* glass = findMaterial(*model, "glass");
        QVERIFY(glass && glass->transmission == 1.0 && std::abs(glass->ior - 1.33) < 1e-6 &&
                glass->alpha == 1.0);
        const auto* leaf = findMaterial(*model, "leaf");
        QVERIFY(leaf && std::abs(leaf->alpha - 0.5) < 1e-6 && leaf->transmission == 0.0);
        const auto* lamp = findMaterial(*model, "lamp");
        QVERIFY(lamp && std::abs(lamp->emission.x - 10.0) < 1e-5);
    }

    void texturesAreFound() {
        // Backslashes, quotes, spaces and wrong case; one is really missing.
        const auto model = import(data("textures.obj"));
        QVERIFY(model);
        for (const char* name : {"backslash", "case", "spaces", "quotes"}) {
            const auto* material = findMaterial(*model, name);
            QVERIFY2(material && material->baseColorTexture.image, name);
        }
        const auto* missing = findMaterial(*model, "missing");
        QVERIFY(missing && !missing->baseColorTexture.image);
        QVERIFY(missing->baseColorTexture.file.ends_with("/nowhere.png"));
        QCOMPARE(model->warnings.size(), std::size_t(1));
        QVERIFY(model->warnings[0].severity == Severity::Warning);
        QVERIFY(model->warnings[0].file.ends_with("/nowhere.png"));
    }

    void missingMtlIsAWarning() {
        const auto model = import(write("nomtl.obj", "mtllib not there.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                                     "usemtl some thing\nf 1 2 3\n"));
        QVERIFY(model);
        QCOMPARE(model->mesh->slots, std::vector<std::string>{"some thing"});
        QCOMPARE(model->warnings.size(), std::size_t(1));
        QVERIFY(model->warnings[0].file.ends_with("/not there.mtl"));
    }

    void axesAndUnits() {
        const auto file = write("axes.obj", "v 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 3\n");
        const auto model = import(file, {UpAxis::Z, 10.0});
        QVERIFY(model);
        QVERIFY(model->mesh->positions[0] == glm::vec3(10, 30, -20));
        QVERIFY(glm::length(model->mesh->normals[0] - glm::vec3(0, 1, 0)) < 1e-6F);
        QVERIFY(!import(file, {UpAxis::Y, 0.0}));
        QVERIFY(!import(file, {UpAxis::Y, NAN}));
    }

    void creasesStaySharpAndCurvesSmooth() {
        // Two squares: at 90° the shared edge is a crease, at 20° it is smooth.
        const auto fold = [](double degrees) {
            const double a = degrees * M_PI / 180.0;
            return QStringLiteral("v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nv %1 %2 0\nv %1 %2 -1\n"
                                  "f 1 2 3 4\nf 1 4 6 5\n")
                .arg(-std::cos(a))
                .arg(-std::sin(a))
                .toUtf8();
        };
        const auto sharp = import(write("sharp.obj", fold(90)));
        const auto smooth = import(write("smooth.obj", fold(20)));
        QVERIFY(sharp && smooth);
        QCOMPARE(sharp->mesh->positions.size(), std::size_t(8));
        QCOMPARE(smooth->mesh->positions.size(), std::size_t(6));
    }

    void hugeFansAreFast() {
        QByteArray text = "v 0 0 0\n";
        const int count = 100'000;
        for (int i = 0; i < count; ++i) {
            const double a = 2.0 * M_PI * i / count;
            text += QString::asprintf("v %.7f %.7f %.7f\n", std::cos(a), std::sin(a), 0.3 * std::sin(9.0 * a))
                        .toUtf8();
        }
        for (int i = 2; i <= count; ++i)
            text += QString::asprintf("f 1 %d %d\n", i, i + 1).toUtf8();
        QElapsedTimer timer;
        timer.start();
        const auto model = import(write("fan.obj", text));
        QVERIFY(model && isSound(*model));
        QVERIFY(timer.elapsed() < 10'000);
    }

    void numbersThatAreNone() {
        const auto model = import(write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e39 0 0\n"
                                                   "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\n"));
        QVERIFY(model);
        QVERIFY(isSound(*model));
        QVERIFY(!model->warnings.empty());
    }

    void faults_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("word");
        QTest::newRow("empty") << "e.obj" << QByteArray() << "empty";
        QTest::newRow("binary") << "b.obj" << QByteArray("\x01\x00\x02v 0 0 0\n", 12) << "not a text file";
        QTest::newRow("prose") << "p.obj" << QByteArray("Once upon a time there was a file.\n") << "";
        QTest::newRow("points") << "q.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 1 1 0\np 1 2 3\n")
                                << "no triangles";
        QTest::newRow("bad index") << "i.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n") << "";
        QTest::newRow("picture") << "p.png" << QByteArray("x") << "picture";
        QTest::newRow("smd") << "m.smd" << QByteArray("version 1\n") << "no block of nodes";
        QTest::newRow("flexes") << "m.vta" << QByteArray("version 1\n") << "import the SMD";
        QTest::newRow("md5 animation") << "m.md5anim" << QByteArray("x") << "Import Animation";
        QTest::newRow("unknown") << "m.xyz" << QByteArray("x") << "xyz";
        QTest::newRow("glb") << "m.glb" << QByteArray("glTF\x02\x00\x00\x00", 8) << "";
    }
    void faults() {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, word);
        const auto file = write(name.toUtf8().constData(), content);
        const auto model = import(file);
        QVERIFY(!model);
        QCOMPARE(model.error().file, file);
        QVERIFY2(QString::fromStdString(model.error().message).contains(word), model.error().message.c_str());
    }

    void missingAndDirectory() {
        QVERIFY(!import(path("missing.obj")));
        const auto directory = import(folder_.path().toStdString());
        QVERIFY(!directory);
        QVERIFY(directory.error().message.find("directory") != std::string::npos);
    }

    void truncationsNeverCrash() {
        QFile whole(QString::fromStdString(data("materials.obj")));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray text = whole.readAll();
        for (int length = 0; length < text.size(); ++length) {
            const auto model = import(write("cut.obj", text.left(length)));
            QVERIFY(model ? isSound(*model) : !model.error().message.empty());
        }
    }

    void damagedModelsNeverCrash() {
        QFile whole(QString::fromStdString(data("materials.obj")));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray text = whole.readAll();
        std::mt19937 random(12);
        for (int round = 0; round < 500; ++round) {
            QByteArray bent = text;
            for (auto i = random() % 5; i < 5; ++i)
                bent[static_cast<int>(random() % static_cast<unsigned>(bent.size()))] =
                    static_cast<char>(random() % 96 + 32);
            const auto model = import(write("bent.obj", bent));
            QVERIFY(model ? isSound(*model) : !model.error().message.empty());
        }
    }

    /// skins/bend.fbx is bend.gltf without its topmost node, as assimp exported it (the times of its keys set
    /// right by hand): it must move as that one does.
    void fbxMovesAsGltfDoes() {
        const auto gltf = import(data("bend.gltf"));
        const auto fbx = import(data("skins/bend.fbx"));
        QVERIFY2(gltf && fbx, fbx ? "" : describe(fbx.error()).c_str());
        QCOMPARE(fbx->clips.size(), std::size_t(1));
        QVERIFY(fbx->mesh->isSkinned());
        for (const Bone& bone : fbx->mesh->skeleton->bones)
            QVERIFY2(bone.name.find("$Assimp") == std::string::npos, bone.name.c_str());
        const auto posed = [](const ImportedModel& model, double seconds, const glm::dmat4& top) {
            std::vector<glm::dvec3> points;
            const Mesh& mesh = *model.mesh;
            const auto matrices = skinningMatrices(
                *mesh.skeleton, poseAtFrame(*mesh.skeleton, *model.clips[0], seconds * model.clips[0]->fps));
            for (const glm::uvec3& triangle : mesh.triangles)
                for (glm::length_t corner = 0; corner < 3; ++corner) {
                    const std::uint32_t vertex = triangle[corner];
                    glm::dvec4 sum(0.0);
                    for (auto k = mesh.firstInfluence[vertex]; k < mesh.firstInfluence[vertex + 1]; ++k)
                        sum += static_cast<double>(mesh.influences[k].weight) *
                               glm::dvec4(matrices[mesh.influences[k].bone] *
                                          glm::vec4(mesh.positions[vertex], 1.0F));
                    points.emplace_back(top * sum);
                }
            return points;
        };
        Transform top;
        top.translation = {1, 2, 3};
        top.rotation = rotationFromEulerDegrees({0, 90, 0});
        top.scale = glm::dvec3(2.0);
        for (const double seconds : {0.0, 0.3, 0.7, 1.0}) {
            const auto expected = posed(*gltf, seconds, glm::dmat4(1.0));
            const auto found = posed(*fbx, seconds, top.matrix());
            QCOMPARE(found.size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                QVERIFY2(glm::length(found[i] - expected[i]) < 0.02,
                         qPrintable(QString("corner %1 after %2 s").arg(i).arg(seconds)));
        }
    }

    void animationsOfOtherFormats_data() {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("animation");
        QTest::addColumn<QString>("bone");
        QTest::addColumn<QString>("clip");
        QTest::newRow("glTF") << "bend.gltf"
                              << "bend.gltf"
                              << "tip"
                              << "bend";
        QTest::newRow("Collada without a model") << "bend.gltf"
                                                 << "skins/tip.dae"
                                                 << "tip"
                                                 << "";
        QTest::newRow("FBX") << "skins/bend.fbx"
                             << "skins/bend.fbx"
                             << "tip"
                             << "bend";
        QTest::newRow("MD5") << "skins/flag.md5mesh"
                             << "skins/blow.md5anim"
                             << "cloth"
                             << "blow";
    }
    void animationsOfOtherFormats() {
        QFETCH(QString, model);
        QFETCH(QString, animation);
        QFETCH(QString, bone);
        QFETCH(QString, clip);
        const auto imported = import(data(model.toUtf8().constData()));
        QVERIFY2(imported, imported ? "" : describe(imported.error()).c_str());
        QVERIFY(imported->mesh->isSkinned());
        const Skeleton& skeleton = *imported->mesh->skeleton;
        MeshSource source;
        source.file = data(model.toUtf8().constData());
        Progress progress;
        const auto added = importAnimation(data(animation.toUtf8().constData()), skeleton, source, progress);
        QVERIFY2(added, added ? "" : describe(added.error()).c_str());
        QCOMPARE(added->clips.size(), std::size_t(1));
        const Clip& found = *added->clips[0];
        QVERIFY(clip.isEmpty() || found.name == clip.toStdString());
        QVERIFY(found.frameCount > 1);
        bool moves = false; // the bone that is animated, and none that is not there
        for (const BoneTrack& track : found.tracks) {
            QCOMPARE(track.frames.size(), static_cast<std::size_t>(found.frameCount));
            const Bone& moved = skeleton.bones.at(static_cast<std::size_t>(track.bone));
            if (moved.name == bone.toStdString())
                moves = !(track.frames.front() == track.frames[track.frames.size() / 2]);
        }
        QVERIFY(moves);
        if (model == animation) // what the model brought along, once more
            for (std::size_t i = 0; i < found.tracks.size(); ++i) {
                QCOMPARE(found.tracks[i].bone, imported->clips[0]->tracks[i].bone);
                QVERIFY(found.tracks[i].frames == imported->clips[0]->tracks[i].frames);
            }
    }

    void cancelling() {
        Progress progress;
        progress.cancel();
        const auto model = importModel(data("materials.obj"), {}, progress);
        QVERIFY(!model);
        QVERIFY(model.error().message.find("cancelled") != std::string::npos);
    }

    void gltfWithBonesAndClip() {
        const auto model = import(data("bend.gltf"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY(isSound(*model));
        const Mesh& mesh = *model->mesh;
        QVERIFY(mesh.isSkinned());
        QCOMPARE(model->clips.size(), std::size_t(1));
        QCOMPARE(model->clips[0]->frameCount, 31);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            float sum = 0.0F;
            glm::vec3 posed(0.0F); // in the bind pose every vertex stays where it is
            for (auto k = mesh.firstInfluence[i]; k < mesh.firstInfluence[i + 1]; ++k) {
                glm::dmat4 global(1.0);
                for (int b = static_cast<int>(mesh.influences[k].bone); b >= 0;
                     b = mesh.skeleton->bones[b].parent) {
                    const BonePose& bind = mesh.skeleton->bones[static_cast<std::size_t>(b)].bind;
                    Transform local;
                    local.translation = bind.translation;
                    local.rotation = glm::dquat(bind.rotation);
                    local.scale = bind.scale;
                    global = local.matrix() * global;
                }
                const auto& inverse = mesh.skeleton->bones[mesh.influences[k].bone].inverseBind;
                posed += mesh.influences[k].weight *
                         glm::vec3(global * glm::dmat4(inverse) * glm::dvec4(mesh.positions[i], 1.0));
                sum += mesh.influences[k].weight;
            }
            QVERIFY(std::abs(sum - 1.0F) < 1e-5F);
            QVERIFY(glm::length(posed - mesh.positions[i]) < 1e-5F);
        }
        Scene scene;
        addModel(scene, *model, {});
        QVERIFY(scene.objects[0].dynamic);
    }

    void addedModelsKeepTheirMaterials() {
        const auto model = import(data("materials.obj"));
        QVERIFY(model);
        Scene scene;
        MeshSource source;
        source.file = data("materials.obj");
        addModel(scene, *model, source);
        addModel(scene, *model, source);
        QCOMPARE(scene.objects[0].name, std::string("materials"));
        QCOMPARE(scene.objects[1].name, std::string("materials 2"));
        QCOMPARE(scene.objects[0].materials.size(), model->mesh->slots.size());
        QCOMPARE(scene.materials.size(), 2 * model->mesh->slots.size());
        QVERIFY(!scene.objects[0].dynamic);
    }

    void everyAssetIsHandled() {
        if (!QDir(assetFolder() + "/obj").exists())
            QSKIP("the shared assets are not here");
        QDirIterator files(assetFolder() + "/obj", {"*.obj"}, QDir::Files, QDirIterator::Subdirectories);
        int count = 0;
        while (files.hasNext()) {
            const std::string file = files.next().toStdString();
            const auto model = import(file);
            const bool pointsOnly = file.ends_with("point_cloud.obj") || file.ends_with("testline.obj") ||
                                    file.ends_with("testpoints.obj");
            QVERIFY2(model.has_value() != pointsOnly, file.c_str());
            if (model)
                QVERIFY2(isSound(*model), file.c_str());
            else
                QVERIFY(model.error().message.find("no triangles") != std::string::npos);
            ++count;
        }
        QVERIFY(count >= 30);
    }

    void knownAssets() {
        if (!QDir(assetFolder() + "/obj").exists())
            QSKIP("the shared assets are not here");
        QCOMPARE(import(asset("odd-assimp/box_UTF16BE.obj"))->mesh->triangles.size(), std::size_t(12));
        QCOMPARE(import(asset("cornell/CornellBox-Original.obj"))->mesh->triangles.size(), std::size_t(36));
        const auto spaces = import(asset("odd-assimp/space_in_material_name.obj"));
        QCOMPARE(spaces->mesh->slots, std::vector<std::string>{"Hard Shiny Plastic White"});
        const auto cornell = import(asset("cornell/CornellBox-Sphere.obj"));
        QVERIFY(findMaterial(*cornell, "light")->emission.x > 9.9);
        QVERIFY(findMaterial(*cornell, "leftSphere")->metallic == 1.0);
        QVERIFY(findMaterial(*cornell, "rightSphere")->transmission == 1.0);
        const auto spider = import(asset("odd-assimp/spider.obj"));
        for (const Material& material : spider->materials)
            QVERIFY(material.baseColorTexture.image);
    }

    void largeModelIsFast() {
        const std::string file = asset("large/motorBike.obj");
        if (!QFile::exists(QString::fromStdString(file)))
            QSKIP("the shared assets are not here");
        QElapsedTimer timer;
        timer.start();
        const auto model = import(file);
        QVERIFY(model);
        QCOMPARE(model->mesh->triangles.size(), std::size_t(331'653));
        qInfo("motorBike: %lld ms", static_cast<long long>(timer.elapsed()));
        QVERIFY(timer.elapsed() < 20'000); // sanitizers and busy machines included
    }
};

QTEST_GUILESS_MAIN(TestImport)
#include "tst_import.moc"
