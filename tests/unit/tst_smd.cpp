#include "core/import/smd_importer.h"
#include "core/import/smd_reader.h"
#include "core/import/vta_reader.h"

#include "core/animation/pose.h"
#include "core/import/animation_importer.h"
#include "tests/support/text_file.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <cmath>
#include <random>

using namespace prizma;

namespace {

const std::string head = "version 1\nnodes\n0 \"a\" -1\n1 \"b\" 0\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\n"
                         "1 0 0 1 0 0 0\nend\n";

/// A reference of one triangle whose first vertex is `vertex`.
std::string modelWith(const std::string& vertex, const std::string& material = "m") {
    return head + "triangles\n" + material + "\n" + vertex + "\n0 1 0 0 0 0 1 1 0\n0 0 1 0 0 0 1 0 1\nend\n";
}

Result<SmdFile> read(const std::string& text) {
    Progress progress;
    return readSmd(text, "test.smd", ProgressPart(progress));
}

std::string data(const std::string& name) {
    return std::string(PRIZMA_TEST_DATA) + "/smd/" + name;
}

Result<ImportedModel> import(const std::string& file, const ImportOptions& options = {UpAxis::Z, 1.0}) {
    Progress progress;
    return importModel(file, options, progress);
}

bool hasWarning(const Diagnostics& warnings, const std::string& part, int line = 0) {
    for (const Diagnostic& warning : warnings)
        if (warning.message.find(part) != std::string::npos && (line == 0 || warning.line == line))
            return true;
    return false;
}

std::vector<BoneInfluence> influencesOf(const SmdFile& smd, std::size_t corner) {
    const auto list = smd.bindings[smd.corners[corner].binding];
    return {list.begin(), list.end()};
}

QByteArray contentOf(const std::string& file) {
    QFile stream(QString::fromStdString(file));
    if (!stream.open(QIODevice::ReadOnly))
        qFatal("no %s", file.c_str());
    return stream.readAll();
}

/// Everything that is done with a text that claims to be an SMD ends well or in an error with words.
void survives(const std::string& text) {
    const auto smd = read(text);
    if (!smd) {
        QVERIFY(!smd.error().message.empty());
        return;
    }
    const auto model = buildSmdModel(*smd, "test.smd", {UpAxis::Z, 1.0});
    if (!model) {
        QVERIFY(!model.error().message.empty());
        return;
    }
    // The only fault a file that was read may still have: numbers that overflow when bones are put together.
    const std::string fault = findFault(*model->mesh);
    QVERIFY2(fault.empty() || fault.find("finite") != std::string::npos, fault.c_str());
    for (const ClipPtr& clip : model->clips)
        for (const BoneTrack& track : clip->tracks)
            QCOMPARE(track.frames.size(), static_cast<std::size_t>(clip->frameCount));
}

} // namespace

class TestSmd : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string write(const QString& name, const std::string& content) const {
        return test::writeFile(folder_, name, content);
    }

  private Q_SLOTS:
    void bonesComeInOrder() {
        const auto smd = read(contentOf(data("arm.smd")).toStdString());
        QVERIFY2(smd, smd ? "" : describe(smd.error()).c_str());
        QVERIFY(smd->warnings.empty());
        QCOMPARE(smd->bones.size(), std::size_t(3));
        for (std::size_t i = 0; i < smd->bones.size(); ++i)
            QVERIFY(smd->bones[i].parent < static_cast<int>(i));
        QCOMPARE(smd->bones[0].name, std::string("base"));
        QCOMPARE(smd->bones[1].name, std::string("arm bone"));
        QCOMPARE(smd->bones[2].parent, 1);
        QCOMPARE(smd->corners.size(), std::size_t(9));
        QCOMPARE(smd->materials, (std::vector<std::string>{"Stone Wall.bmp", "skins\\glow"}));
    }

    void weights_data() {
        QTest::addColumn<QString>("tail");
        QTest::addColumn<double>("ofA");
        QTest::addColumn<double>("ofB");
        QTest::addColumn<QString>("warning");
        QTest::newRow("Half-Life") << "" << 1.0 << 0.0 << "";
        QTest::newRow("no links") << "0" << 1.0 << 0.0 << "";
        QTest::newRow("one link") << "1 1 1.0" << 0.0 << 1.0 << "";
        QTest::newRow("two") << "2 0 0.25 1 0.75" << 0.25 << 0.75 << "";
        QTest::newRow("the rest is the first bone's") << "1 1 0.6" << 0.4 << 0.6 << "";
        QTest::newRow("rounded sums have no rest") << "1 1 0.999" << 0.0 << 1.0 << "";
        QTest::newRow("too much") << "2 0 1.0 1 1.0" << 0.5 << 0.5 << "more than 1";
        QTest::newRow("one bone twice") << "3 1 0.5 0 0.25 1 0.25" << 0.25 << 0.75 << "";
        QTest::newRow("negative") << "2 0 -0.5 1 1" << 0.0 << 1.0 << "negative";
        QTest::newRow("comment") << "1 1 1 // hm" << 0.0 << 1.0 << "";
        QTest::newRow("excess") << "1 1 1 5 6" << 0.0 << 1.0 << "more on the vertex's line";
    }
    void weights() {
        QFETCH(QString, tail);
        QFETCH(double, ofA);
        QFETCH(double, ofB);
        QFETCH(QString, warning);
        const auto smd = read(modelWith("0 0 0 0 0 0 1 0 0 " + tail.toStdString()));
        QVERIFY2(smd, smd ? "" : describe(smd.error()).c_str());
        double found[2] = {0.0, 0.0};
        for (const BoneInfluence& influence : influencesOf(*smd, 0))
            found[influence.bone] += static_cast<double>(influence.weight);
        QVERIFY(std::abs(found[0] - ofA) < 1e-6 && std::abs(found[1] - ofB) < 1e-6);
        QCOMPARE(influencesOf(*smd, 0).size(), std::size_t((ofA > 0.0 ? 1 : 0) + (ofB > 0.0 ? 1 : 0)));
        QCOMPARE(smd->warnings.empty(), warning.isEmpty());
        QVERIFY(warning.isEmpty() || hasWarning(smd->warnings, warning.toStdString(), 13));
    }

    void theRestGoesToTheRootIfItsBoneIsMissing() {
        const auto smd = read(modelWith("9 0 0 0 0 0 1 0 0 1 1 0.6"));
        QVERIFY(smd);
        QCOMPARE(influencesOf(*smd, 0).size(), std::size_t(2));
        QVERIFY(hasWarning(smd->warnings, "the root took it", 13));
        // A list that sums to 1 needs no such bone.
        const auto whole = read(modelWith("9 0 0 0 0 0 1 0 0 1 1 1"));
        QVERIFY(whole && whole->warnings.empty());
    }

    void linesAsPeopleWriteThem() {
        std::string text = modelWith("0 +1.5 -.5 1e-400 0 0 1 0.25 1E0 ; remark\n# a line of its own\n");
        const auto plain = read(text);
        QVERIFY2(plain, plain ? "" : describe(plain.error()).c_str());
        QVERIFY(plain->corners[0].position == glm::vec3(1.5F, -0.5F, 0.0F));
        QVERIFY(plain->corners[0].texCoord == glm::vec2(0.25F, 1.0F));
        std::string dos;
        std::string mac;
        for (const char c : text) {
            dos += c == '\n' ? "\r\n" : std::string(1, c);
            mac += c == '\n' ? '\r' : c;
        }
        for (const std::string& other : {dos, mac, "\n\n// remark\n" + text, text + "\n\n"}) {
            const auto same = read(other);
            QVERIFY2(same, same ? "" : describe(same.error()).c_str());
            QCOMPARE(same->materials, plain->materials);
            QCOMPARE(same->corners.size(), plain->corners.size());
            QVERIFY(same->warnings.empty());
        }
        text.pop_back(); // "end" as the last bytes
        QVERIFY(read(text));
    }

    void materialNames_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("name");
        QTest::newRow("spaces") << "  old brick wall.bmp "
                                << "old brick wall.bmp";
        QTest::newRow("nothing") << ""
                                 << "";
        QTest::newRow("looks like a comment") << "#256.bmp"
                                              << "#256.bmp";
        QTest::newRow("number") << "metal #2.bmp"
                                << "metal #2.bmp";
        QTest::newRow("remark") << "wall.bmp // the old one"
                                << "wall.bmp";
        QTest::newRow("path") << "models//hat\\a b.tga"
                              << "models//hat\\a b.tga";
        QTest::newRow("after a comment") << "// comment\nwall"
                                         << "wall";
        QTest::newRow("after empty lines") << "\n\n\nwall"
                                           << "wall";
        QTest::newRow("like a vertex") << "0 1 2"
                                       << "0 1 2";
    }
    void materialNames() {
        QFETCH(QString, line);
        QFETCH(QString, name);
        const auto smd = read(modelWith("0 0 0 0 0 0 1 0 0", line.toStdString()));
        QVERIFY2(smd, smd ? "" : describe(smd.error()).c_str());
        QCOMPARE(smd->materials, std::vector<std::string>{name.toStdString()});
        QCOMPARE(smd->corners.size(), std::size_t(3));
    }

    void localeDoesNotMatter() {
        const std::string before = std::setlocale(LC_ALL, nullptr);
        for (const char* locale : {"hu_HU.UTF-8", "de_DE.UTF-8", "C.UTF-8"})
            if (std::setlocale(LC_ALL, locale))
                QVERIFY(read(modelWith("0 0.5 0 0 0 0 1 0 0"))->corners[0].position.x == 0.5F);
        std::setlocale(LC_ALL, before.c_str());
    }

    void damage_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const std::string& text, int line, const char* word) {
            QTest::newRow(name) << QString::fromStdString(text) << line << word;
        };
        row("empty", "", 0, "no block of nodes");
        row("prose", "Once upon a time", 1, "not an SMD");
        row("no nodes", "version 1\nskeleton\ntime 0\nend\n", 0, "no block of nodes");
        row("nodes cut", "version 1\nnodes\n0 \"a\" -1\n", 2, "ends within");
        row("skeleton cut", head.substr(0, head.size() - 4), 6, "ends within");
        row("triangles cut", head + "triangles\nm\n0 0 0 0 0 0 1 0 0\n", 11, "ends within");
        row("two corners", head + "triangles\nm\n0 0 0 0 0 0 1 0 0\n0 0 0 0 0 0 1 0 0\nend\n", 15,
            "three corners");
        row("bone without parent", "version 1\nnodes\n0 \"a\"\nend\n", 3, "parent's number");
        row("open quote", "version 1\nnodes\n0 \"a -1\nend\n", 3, "name in quotes");
        row("short key", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\n0 1 2 3 4 5\nend\n", 7,
            "six finite numbers");
        row("key before time", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\n0 0 0 0 0 0 0\nend\n", 6,
            "\"time\"");
        row("time of words", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime soon\nend\n", 6,
            "whole number");
        row("nan", modelWith("0 nan 0 0 0 0 1 0 0"), 13, "finite");
        row("infinity", modelWith("0 0 inf 0 0 0 1 0 0"), 13, "finite");
        row("too large", modelWith("0 1e39 0 0 0 0 1 0 0"), 13, "finite");
        row("far too large", modelWith("0 0 0 0 0 0 1 1e999 0"), 13, "finite");
        row("Microsoft's nan", modelWith("0 -1.#IND 0 0 0 0 1 0 0"), 13, "finite");
        row("comma", modelWith("0 0,5 0 0 0 0 1 0 0"), 13, "finite");
        row("hexadecimal", modelWith("0 0x10 0 0 0 0 1 0 0"), 13, "finite");
        row("glued", modelWith("0 1.0.0 0 0 0 0 1 0 0"), 13, "finite");
        row("short vertex", modelWith("0 0 0 0 0 0 1 0"), 13, "eight");
        row("unknown bone", modelWith("5 0 0 0 0 0 1 0 0"), 13, "bone 5");
        row("unknown link", modelWith("0 0 0 0 0 0 1 0 0 1 77 1"), 13, "bone 77");
        row("links that are not there", modelWith("0 0 0 0 0 0 1 0 0 2000000000 1 1"), 13, "only 1 follow");
        row("negative links", modelWith("0 0 0 0 0 0 1 0 0 -1"), 13, "from 0 up");
        row("more links than ints", modelWith("0 0 0 0 0 0 1 0 0 99999999999"), 13, "from 0 up");
        row("link without weight", modelWith("0 0 0 0 0 0 1 0 0 1 1"), 13, "bone weight");
        row("weight of nan", modelWith("0 0 0 0 0 0 1 0 0 1 1 nan"), 13, "bone weight");
        row("nodes twice", head + "nodes\nend\n", 11, "second block");
    }
    void damage() {
        QFETCH(QString, text);
        QFETCH(int, line);
        QFETCH(QString, word);
        const auto smd = read(text.toStdString());
        QVERIFY(!smd);
        QCOMPARE(smd.error().file, std::string("test.smd"));
        QVERIFY2(QString::fromStdString(smd.error().message).contains(word), smd.error().message.c_str());
        QCOMPARE(smd.error().line, line);
    }

    void faultsThatArePutUpWith_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const std::string& text, int line, const char* word) {
            QTest::newRow(name) << QString::fromStdString(text) << line << word;
        };
        row("no version", head.substr(10), 1, "version 1");
        row("version 2", "version 2" + head.substr(9), 1, "Only version 1");
        row("unknown block", head + "secrets\n1 2 3\nend\n", 11, "skipped");
        row("times skip", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\ntime 2\ntime 3\nend\n", 7,
            "skip or repeat");
        row("times repeat", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\ntime 0\nend\n", 7,
            "skip or repeat");
        row("parent that is not there", "version 1\nnodes\n0 \"a\" 6\nend\n", 3, "made a root");
        row("its own parent", "version 1\nnodes\n0 \"a\" 0\nend\n", 3, "its own ancestor");
        row("a ring", "version 1\nnodes\n0 \"a\" 2\n1 \"b\" 0\n2 \"c\" 1\nend\n", 4, "its own ancestor");
        row("number twice", "version 1\nnodes\n0 \"a\" -1\n0 \"b\" -1\nend\n", 4, "given before");
        row("place of nobody", "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\n4 0 0 0 0 0 0\nend\n", 7,
            "not among the nodes");
    }
    void faultsThatArePutUpWith() {
        QFETCH(QString, text);
        QFETCH(int, line);
        QFETCH(QString, word);
        const auto smd = read(text.toStdString());
        QVERIFY2(smd, smd ? "" : describe(smd.error()).c_str());
        QCOMPARE(smd->warnings.size(), std::size_t(1));
        QVERIFY2(hasWarning(smd->warnings, word.toStdString(), line), describe(smd->warnings[0]).c_str());
        for (std::size_t i = 0; i < smd->bones.size(); ++i)
            QVERIFY(smd->bones[i].parent < static_cast<int>(i));
    }

    void aMillionFaultsAreOneWarning() {
        std::string text = "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\n";
        for (int i = 0; i < 20'000; ++i)
            text += "9 0 0 0 0 0 0\n";
        const auto smd = read(text + "end\n");
        QVERIFY(smd);
        QCOMPARE(smd->warnings.size(), std::size_t(1));
        QVERIFY(hasWarning(smd->warnings, "20000 such lines", 7));
    }

    /// Little text that would become much: bones and frames, most of them not filled in.
    void blownUpFilesAreTurnedAway() {
        std::string text = "version 1\nnodes\n";
        for (int i = 0; i < 20'000; ++i)
            text += std::to_string(i) + " \"b" + std::to_string(i) + "\" -1\n";
        text += "end\nskeleton\ntime 0\n";
        for (int i = 0; i < 20'000; ++i)
            text += std::to_string(i) + " 0 0 0 0 0 0\n";
        for (int i = 1; i < 30'000; ++i)
            text += "time " + std::to_string(i) + "\n";
        QElapsedTimer timer;
        timer.start();
        const auto file = write("blown.smd", text + "end\n");
        Progress progress;
        const auto animation = importSmdAnimation(file, {}, ProgressPart(progress));
        QVERIFY(!animation);
        QVERIFY(animation.error().message.find("cannot be") != std::string::npos);
        QVERIFY(timer.elapsed() < 5000);
    }

    void deepBranchesAreFast() {
        std::string text = "version 1\nnodes\n";
        constexpr int count = 100'000;
        for (int i = 0; i < count; ++i) // each the child of the next
            text += std::to_string(i) + " \"b\" " + std::to_string(i + 1 < count ? i + 1 : -1) + "\n";
        QElapsedTimer timer;
        timer.start();
        const auto smd = read(text + "end\n");
        QVERIFY(smd);
        QCOMPARE(smd->bones.size(), std::size_t(count));
        QCOMPARE(smd->bones.back().parent, count - 2);
        QVERIFY(timer.elapsed() < 5000);
    }

    void cancelIsHeard() {
        std::string text = head + "triangles\n";
        for (int i = 0; i < 5000; ++i)
            text += "m\n0 0 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 0 0\n0 1 1 0 0 0 1 0 0\n";
        Progress progress;
        progress.cancel();
        const auto smd = readSmd(text, "test.smd", ProgressPart(progress));
        QVERIFY(!smd);
        QVERIFY(smd.error().message.find("cancelled") != std::string::npos);
    }

    void largeFilesAreQuick() {
        std::string text = head + "triangles\n";
        for (int i = 0; i < 200'000; ++i) {
            const std::string x = std::to_string(i * 0.001);
            text += "some material.bmp\n";
            for (const char* y : {"0.25", "1.5", "2.75"})
                text += "0 " + x + " " + y +
                        " 0.125000 0.000000 0.000000 1.000000 0.500000 0.250000 2 0 0.5 1 0.5\n";
        }
        text += "end\n";
        QElapsedTimer timer;
        timer.start();
        const auto smd = read(text);
        QVERIFY(smd);
        QCOMPARE(smd->corners.size(), std::size_t(600'000));
        QCOMPARE(smd->bindings.size(), std::size_t(1));
        const double megabytes = static_cast<double>(text.size()) / 1e6;
        qInfo("%.0f MB in %lld ms", megabytes, static_cast<long long>(timer.elapsed()));
        QVERIFY(timer.elapsed() < 10'000); // sanitizers and busy machines included
    }

    void modelStandsUpright() {
        const auto file = data("arm.smd");
        const auto z = import(file, {UpAxis::Z, 2.0});
        const auto y = import(file, {UpAxis::Y, 1.0});
        QVERIFY2(z && y, z ? "" : describe(z.error()).c_str());
        QVERIFY(findFault(*z->mesh).empty());
        QCOMPARE(z->mesh->triangles.size(), std::size_t(3));
        QCOMPARE(z->mesh->positions.size(), std::size_t(7)); // four of the square, three above
        for (std::size_t i = 0; i < z->mesh->positions.size(); ++i) {
            const glm::vec3 file3 = y->mesh->positions[i];
            QVERIFY(glm::length(z->mesh->positions[i] - 2.0F * glm::vec3(file3.x, file3.z, -file3.y)) <
                    1e-6F);
        }
        // In the bind pose nothing moves, turned and scaled or not.
        for (const auto* model : {&*z, &*y})
            for (const glm::mat4& matrix :
                 skinningMatrices(*model->mesh->skeleton, bindPose(*model->mesh->skeleton)))
                for (int column = 0; column < 4; ++column)
                    QVERIFY(glm::length(matrix[column] - glm::mat4(1.0F)[column]) < 1e-5F);
    }

    void picturesAreFound() {
        const auto model = import(data("arm.smd"));
        QVERIFY(model);
        QCOMPARE(model->mesh->slots, (std::vector<std::string>{"Stone Wall.bmp", "skins\\glow"}));
        QVERIFY(model->materials[0].baseColorTexture.image); // by another extension and case
        QVERIFY(model->materials[0].baseColorTexture.file.ends_with("STONE wall.PNG"));
        QVERIFY(!model->materials[1].baseColorTexture.isSet()); // only a QC would name that folder
        QVERIFY(hasWarning(model->warnings, "glow"));
        const auto lost = import(write("lost.smd", modelWith("0 0 0 0 0 0 1 0 0", "lost.bmp")));
        QVERIFY(lost && lost->materials[0].baseColorTexture.isSet());
        QVERIFY(!lost->materials[0].baseColorTexture.image);
        QVERIFY(hasWarning(lost->warnings, "missing"));
        const auto red = import(write("red.smd", modelWith("0 0 0 0 0 0 1 0 0", "matRed_2")));
        QVERIFY(red && red->materials[0].baseColor.x > 5 * red->materials[0].baseColor.y);
    }

    void animationIsNoModel() {
        const auto model = import(data("wave.smd"));
        QVERIFY(!model);
        QVERIFY(model.error().message.find("Import Animation") != std::string::npos);
        QVERIFY(isAnimationFile(data("wave.smd")));
        QVERIFY(!isAnimationFile(data("arm.smd")));
        QVERIFY(!isAnimationFile(data("arm.qc")));
        // The word alone makes no model.
        QVERIFY(isSmdAnimation("version 1\nnodes\n0 \"triangles\" -1\nend\n"));
        QVERIFY(!isSmdAnimation("nodes\nend\n \tTriangles\r\nend"));
        QVERIFY(!isSmdAnimation("triangles"));
    }

    /// Names pair, not numbers; gaps are filled; the turn and the scale are those of the model.
    void animationPairsByName() {
        for (const UpAxis axis : {UpAxis::Y, UpAxis::Z}) {
            const auto model = import(data("arm.smd"), {axis, 3.0});
            QVERIFY(model);
            MeshSource source;
            source.file = data("arm.smd");
            source.upAxis = axis;
            source.unitScale = 3.0;
            Progress progress;
            const Skeleton& skeleton = *model->mesh->skeleton;
            const auto animation = importAnimation(data("wave.smd"), skeleton, source, progress);
            QVERIFY2(animation, animation ? "" : describe(animation.error()).c_str());
            QCOMPARE(animation->clips.size(), std::size_t(1));
            const Clip& clip = *animation->clips[0];
            QCOMPARE(clip.name, std::string("wave"));
            QCOMPARE(clip.frameCount, 3);
            QCOMPARE(clip.fps, 30.0);
            QVERIFY(hasWarning(animation->warnings, "tail"));
            QVERIFY(hasWarning(animation->warnings, "Bones that some frames lack"));
            // The first frame is the bind pose.
            const Pose bind = bindPose(skeleton);
            const Pose first = poseAtFrame(skeleton, clip, 0.0);
            for (std::size_t i = 0; i < bind.size(); ++i) {
                QVERIFY(glm::length(bind[i].translation - first[i].translation) < 1e-5F);
                QVERIFY(std::abs(glm::dot(bind[i].rotation, first[i].rotation)) > 0.99999F);
            }
            // The last by hand: Rz(90 deg) Ry(0.25) Rx(0.5) at height 2, and the hand 2 along X, 1 along Z.
            const Pose last = poseAtFrame(skeleton, clip, 2.0);
            const auto toObject = skinningMatrices(skeleton, last);
            const glm::dmat4 arm = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 2)) *
                                   glm::rotate(glm::dmat4(1.0), 1.5707963, glm::dvec3(0, 0, 1)) *
                                   glm::rotate(glm::dmat4(1.0), 0.25, glm::dvec3(0, 1, 0)) *
                                   glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(1, 0, 0));
            glm::dvec3 hand(arm * glm::dvec4(2, 0, 1, 1));
            if (axis == UpAxis::Z)
                hand = {hand.x, hand.z, -hand.y};
            const glm::mat4 handBind = glm::inverse(skeleton.bones[2].inverseBind);
            const glm::vec3 found = glm::vec3(toObject[2] * handBind * glm::vec4(0, 0, 0, 1));
            QVERIFY(glm::length(found - 3.0F * glm::vec3(hand)) < 1e-4F);
        }
    }

    void foreignAnimationIsTurnedAway() {
        const auto model = import(data("arm.smd"));
        QVERIFY(model);
        MeshSource source;
        source.file = data("arm.smd");
        Progress progress;
        const auto tell = [&](const std::string& file) {
            const auto animation = importAnimation(file, *model->mesh->skeleton, source, progress);
            return animation ? std::string() : animation.error().message;
        };
        QVERIFY(tell(write("foreign.smd", "version 1\nnodes\n0 \"x\" -1\nend\nskeleton\ntime 0\nend\n"))
                    .find("no bone in common") != std::string::npos);
        QVERIFY(tell(write("none.smd", "version 1\nnodes\n0 \"base\" -1\nend\n")).find("no frames") !=
                std::string::npos);
        QVERIFY(tell(data("missing.smd")).find("no such file") != std::string::npos);
        QVERIFY(tell(data("arm.vta")).find("not a format") != std::string::npos);
        QVERIFY(!tell(write("cut.smd", "version 1\nnodes\n0 \"base\" -1\n")).empty());
    }

    void clipsGetNamesOfTheirOwn() {
        Object object;
        ImportedAnimation walk;
        walk.file = "/a/walk.smd";
        walk.clips = {std::make_shared<Clip>(Clip{"walk", 30.0, 1, true, {}})};
        addAnimation(object, walk);
        QCOMPARE(object.clip, std::string("walk"));
        QVERIFY(object.dynamic);
        ImportedAnimation other = walk;
        other.file = "/b/walk.smd";
        addAnimation(object, other);
        QCOMPARE(object.clips.size(), std::size_t(2));
        QCOMPARE(object.clips[1]->name, std::string("walk 2"));
        QCOMPARE(object.clip, std::string("walk"));
        // The same file again replaces its clip.
        ImportedAnimation run;
        run.file = "/a/run.smd";
        run.clips = {std::make_shared<Clip>(Clip{"run", 30.0, 1, true, {}})};
        addAnimation(object, run);
        run.clips = {std::make_shared<Clip>(Clip{"run", 30.0, 7, true, {}})};
        addAnimation(object, run);
        QCOMPARE(object.clips.size(), std::size_t(3));
        QCOMPARE(object.clips[2]->frameCount, 7);
        QCOMPARE(object.clipFiles, (std::vector<std::string>{"/a/walk.smd", "/b/walk.smd", "/a/run.smd"}));
    }

    void flexesBecomeMorphTargets() {
        const auto model = import(data("arm.smd"), {UpAxis::Z, 2.0});
        QVERIFY(model);
        const Mesh& mesh = *model->mesh;
        QCOMPARE(mesh.morphTargets.size(), std::size_t(2));
        const MorphTarget& lift = mesh.morphTargets[0];
        QCOMPARE(lift.name, std::string("lift"));
        QCOMPARE(lift.vertices.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(std::abs(mesh.positions[lift.vertices[i]].y - 2.0F) < 1e-6F);
            QVERIFY(glm::length(lift.positionOffsets[i] - glm::vec3(0, 2, 0)) < 1e-6F);
            QVERIFY(glm::length(lift.normalOffsets[i]) < 1e-6F);
        }
        const MorphTarget& lean = mesh.morphTargets[1];
        QCOMPARE(lean.vertices.size(), std::size_t(1));
        QVERIFY(glm::length(mesh.normals[lean.vertices[0]] + lean.normalOffsets[0] -
                            glm::vec3(0, 0.8F, -0.6F)) < 1e-6F);
    }

    void damagedFlexesCostOnlyThemselves() {
        write("face.smd", modelWith("0 0 0 0 0 0 1 0 0"));
        for (const char* text : {"", "version 1\n", "version 1\nvertexanimation\n0 1 2 3\nend\n",
                                 "version 1\nvertexanimation\ntime 0\n0 0 0 nan 0 0 1\nend\n",
                                 "version 1\nvertexanimation\ntime 0\n0 50 50 50 0 0 1\nend\n"}) {
            const auto vta = write("face.vta", text);
            const auto model = import(folder_.filePath(QStringLiteral("face.smd")).toStdString());
            QVERIFY(model);
            QVERIFY(model->mesh->morphTargets.empty());
            QVERIFY(hasWarning(model->warnings, "flexes were left out"));
        }
    }

    void truncationsNeverCrash() {
        for (const char* name : {"arm.smd", "wave.smd"}) {
            const std::string text = contentOf(data(name)).toStdString();
            for (std::size_t length = 0; length < text.size(); ++length)
                survives(text.substr(0, length));
        }
        const std::string flexes = contentOf(data("arm.vta")).toStdString();
        for (std::size_t length = 0; length < flexes.size(); ++length) {
            Progress progress;
            const auto vta = readVta(flexes.substr(0, length), "test.vta", ProgressPart(progress));
            QVERIFY(vta || !vta.error().message.empty());
        }
    }

    void mutationsNeverCrash() {
        const std::string whole = contentOf(data("arm.smd")).toStdString();
        std::mt19937 random(7);
        const char* words[] = {"end",        "time",        "-1", "1e38",  "nan",
                               "2147483647", "-2147483648", "\"", "nodes", "triangles",
                               "0.001",      "\n",          " ",  "//",    "99999999999999999999"};
        for (int round = 0; round < 4000; ++round) {
            std::string text = whole;
            for (auto i = 1 + random() % 4; i > 0 && !text.empty(); --i) {
                const std::size_t at = random() % text.size();
                switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                case 2:
                    text.insert(at, words[random() % std::size(words)]);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 60));
                    break;
                }
            }
            survives(text);
        }
    }
};

QTEST_GUILESS_MAIN(TestSmd)
#include "tst_smd.moc"
