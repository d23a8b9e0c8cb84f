#include "core/import/import_batch.h"
#include "core/import/qc_importer.h"
#include "core/import/qc_lexer.h"
#include "core/import/qc_reader.h"

#include "core/animation/pose.h"
#include "tests/support/text_file.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace prizma;

namespace {

Result<QcScript> nothingToInclude(const std::string&) {
    return failure("not here");
}

Result<QcModel> read(const std::string& text) {
    return readQc({"test.qc", text}, nothingToInclude);
}

std::string data(const std::string& name) {
    return std::string(PRIZMA_TEST_DATA) + "/smd/" + name;
}

Result<ImportedModel> import(const std::string& file) {
    Progress progress;
    return importModel(file, {usualUpAxis(file), 1.0}, progress);
}

bool hasWarning(const Diagnostics& warnings, const std::string& part) {
    for (const Diagnostic& warning : warnings)
        if (warning.message.find(part) != std::string::npos)
            return true;
    return false;
}

const std::string tiny = "version 1\nnodes\n0 \"base\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\n"
                         "triangles\nm\n0 0 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 0 0\n0 1 1 0 0 0 1 0 0\nend\n";

} // namespace

class TestQc : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string write(const QString& name, const std::string& content) const {
        return test::writeFile(folder_, name, content);
    }

  private Q_SLOTS:
    void words() {
        QcLexer lexer("a \"b c\" {d}// e\n/* f\n */ # g\n; h\n$i \"j\nk");
        std::vector<std::pair<std::string, int>> found;
        while (const auto token = lexer.next())
            found.emplace_back(token->text, token->line);
        const std::vector<std::pair<std::string, int>> expected{{"a", 1}, {"b c", 1}, {"{", 1}, {"d", 1},
                                                                {"}", 1}, {"$i", 5},  {"j", 5}, {"k", 6}};
        QVERIFY(found == expected);
    }

    void sequences_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("fps");
        QTest::addColumn<bool>("loops");
        QTest::newRow("one line") << "$sequence run \"run.smd\" fps 24 loop"
                                  << "run.smd" << 24.0 << true;
        QTest::newRow("block") << "$sequence run {\n \"run.smd\"\n fps 12.5\n}"
                               << "run.smd" << 12.5 << false;
        QTest::newRow("options before") << "$sequence run fps 10 run"
                                        << "run" << 10.0 << false;
        QTest::newRow("usual rate") << "$sequence run run loop"
                                    << "run" << 30.0 << true;
        QTest::newRow("activity") << "$sequence run ACT_RUN 1 \"run\""
                                  << "run" << 30.0 << false;
        QTest::newRow("bad rate") << "$sequence run \"run\" fps -3"
                                  << "run" << 30.0 << false;
        QTest::newRow("event") << "$sequence run \"run\" { event 5004 3 \"a.wav\" } fps 9"
                               << "run" << 9.0 << false;
        QTest::newRow("animation") << "$animation A \"run.smd\" fps 15 loop\n$sequence run a"
                                   << "run.smd" << 15.0 << true;
        QTest::newRow("own rate") << "$animation A \"run.smd\" fps 15\n$sequence run a fps 20"
                                  << "run.smd" << 20.0 << false;
        QTest::newRow("capitals") << "$SEQUENCE run \"run.smd\" FPS 24 Loop"
                                  << "run.smd" << 24.0 << true;
    }
    void sequences() {
        QFETCH(QString, text);
        QFETCH(QString, file);
        QFETCH(double, fps);
        QFETCH(bool, loops);
        const auto qc = read("$modelname \"x.mdl\"\n" + text.toStdString() + "\n$hbox 0 \"b\" 1 2 3\n");
        QVERIFY2(qc, qc ? "" : describe(qc.error()).c_str());
        QCOMPARE(qc->sequences.size(), std::size_t(1));
        QCOMPARE(qc->sequences[0].name, std::string("run"));
        QCOMPARE(qc->sequences[0].file, file.toStdString());
        QCOMPARE(qc->sequences[0].fps, fps);
        QCOMPARE(qc->sequences[0].loops, loops);
    }

    void bodiesAndScales() {
        const auto qc =
            read("$body a \"a.smd\"\n$scale 2\n$body b b\n$bodygroup g\n{\n studio \"c\"\n studio d\n}\n"
                 "$model m \"m.smd\" { eyeball x y { } flexfile f { flex smile frame 2 } }\n"
                 "$upaxis y $cd \"C:\\work\" $cdtexture tex\n$scale nonsense\n$body e e");
        QVERIFY2(qc, qc ? "" : describe(qc.error()).c_str());
        QCOMPARE(qc->bodies.size(), std::size_t(5));
        const double scales[] = {1.0, 2.0, 2.0, 2.0, 2.0};
        const char* files[] = {"a.smd", "b", "c", "m.smd", "e"};
        for (std::size_t i = 0; i < 5; ++i) {
            QCOMPARE(qc->bodies[i].scale, scales[i]);
            QCOMPARE(qc->bodies[i].file, std::string(files[i]));
        }
        QCOMPARE(qc->bodies[3].flexFile, std::string("f"));
        QCOMPARE(qc->bodies[3].flexes.at(0).name, std::string("smile"));
        QCOMPARE(qc->bodies[3].flexes.at(0).frame, 2);
        QVERIFY(qc->upAxis == UpAxis::Y);
        QVERIFY(hasWarning(qc->warnings, "offers 2 choices"));
        QVERIFY(hasWarning(qc->warnings, "scale"));
    }

    void damage_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("word");
        QTest::newRow("no file") << "$body x\n$body y \"y\"" << 1 << "file";
        QTest::newRow("no name") << "\n$sequence" << 2 << "name";
        QTest::newRow("sequence of nothing") << "$sequence x { fps 3 }" << 1 << "SMD";
        QTest::newRow("open brace") << "$body a a\n$sequence x \"x\" {\n fps 3\n" << 2 << "not closed";
        QTest::newRow("empty file name") << "$sequence x \"\"" << 1 << "SMD";
        QTest::newRow("no folder") << "$cdmaterials" << 1 << "folder";
    }
    void damage() {
        QFETCH(QString, text);
        QFETCH(int, line);
        QFETCH(QString, word);
        const auto qc = read(text.toStdString());
        QVERIFY(!qc);
        QCOMPARE(qc.error().line, line);
        QVERIFY2(QString::fromStdString(qc.error().message).contains(word), qc.error().message.c_str());
    }

    void includesThatNeverEnd() {
        QElapsedTimer timer;
        timer.start();
        const auto self = readQc({"a.qc", "$include \"a.qc\""}, [](const std::string& name) {
            return Result<QcScript>(QcScript{name, "$include \"a.qc\"\n$include \"a.qc\""});
        });
        QVERIFY(!self);
        QVERIFY(self.error().message.find("includes") != std::string::npos);
        QVERIFY(timer.elapsed() < 2000);
        const auto qc = read("$include \"gone.qci\"\n$body a a");
        QVERIFY(qc && hasWarning(qc->warnings, "gone.qci"));
        QCOMPARE(qc->bodies.size(), std::size_t(1));
    }

    void wholeModel() {
        QVERIFY(usualUpAxis(data("arm.qc")) == UpAxis::Z);
        const auto model = import(data("arm.qc"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        const Mesh& mesh = *model->mesh;
        QCOMPARE(mesh.triangles.size(), std::size_t(3));
        QVERIFY(std::abs(mesh.bounds.high.x - 2.0F) < 1e-6F); // $scale 2
        QCOMPARE(mesh.morphTargets.size(), std::size_t(1));
        QCOMPARE(mesh.morphTargets[0].name, std::string("up"));
        QVERIFY(model->materials[0].baseColorTexture.image);
        QVERIFY(model->materials[1].baseColorTexture.image); // in the folder of $cdmaterials
        QCOMPARE(model->clips.size(), std::size_t(3));
        QCOMPARE(model->clips[0]->name, std::string("wave"));
        QCOMPARE(model->clips[0]->fps, 12.0);
        QVERIFY(model->clips[0]->loops);
        QCOMPARE(model->clips[0]->frameCount, 3);
        QCOMPARE(model->clips[1]->name, std::string("quick wave"));
        QCOMPARE(model->clips[1]->fps, 60.5);
        QVERIFY(!model->clips[1]->loops);
        QCOMPARE(model->clips[1]->frameCount, 2);
        QCOMPARE(model->clips[2]->fps, 15.0);
        QVERIFY(hasWarning(model->warnings, "\"lost\" was left out"));
        QVERIFY(hasWarning(model->warnings, "\"hat\" offers 2 choices"));
        for (const BoneTrack& track : model->clips[1]->tracks)
            QCOMPARE(track.frames.size(), std::size_t(2));
        // The scale reaches the animation: the first frame of the whole clip is the bind pose.
        for (const glm::mat4& matrix :
             skinningMatrices(*mesh.skeleton, poseAtFrame(*mesh.skeleton, *model->clips[0], 0.0)))
            for (int column = 0; column < 4; ++column)
                QVERIFY(glm::length(matrix[column] - glm::mat4(1.0F)[column]) < 1e-5F);
    }

    void bodiesShareBones() {
        // The second body was made in another pose: its arm lies at another place.
        write("a.smd", "version 1\nnodes\n0 \"base\" -1\n1 \"arm\" 0\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\n"
                       "1 5 0 0 0 0 0\nend\ntriangles\nm\n1 5 0 0 0 0 1 0 0\n1 6 0 0 0 0 1 0 0\n"
                       "1 6 1 0 0 0 1 0 0\nend\n");
        write("b.smd", "version 1\nnodes\n4 \"arm\" -1\n5 \"hat\" 4\nend\nskeleton\ntime 0\n4 0 0 1 0 0 0\n"
                       "5 0 0 1 0 0 0\nend\ntriangles\nn\n4 0 0 1 0 0 1 0 0\n4 1 0 1 0 0 1 0 0\n"
                       "5 1 1 2 0 0 1 0 0\nend\n");
        const auto model = import(write("two.qc", "$upaxis y\n$body a a\n$body b b\n"));
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        const Mesh& mesh = *model->mesh;
        QCOMPARE(mesh.skeleton->bones.size(), std::size_t(3));
        QCOMPARE(mesh.skeleton->bones[2].name, std::string("hat"));
        QCOMPARE(mesh.skeleton->bones[2].parent, 1);
        QCOMPARE(mesh.slots, (std::vector<std::string>{"m", "n"}));
        const glm::vec3 moved[] = {{5, 0, 0}, {6, 0, 0}, {6, 1, 1}};
        for (glm::length_t i = 0; i < 3; ++i)
            QVERIFY(glm::length(mesh.positions[mesh.triangles[1][i]] - moved[i]) < 1e-5F);
        for (const glm::mat4& matrix : skinningMatrices(*mesh.skeleton, bindPose(*mesh.skeleton)))
            QVERIFY(glm::length(matrix[3] - glm::vec4(0, 0, 0, 1)) < 1e-5F);
    }

    void bodiesThatAreMissing() {
        write("tiny.smd", tiny);
        const auto some = import(write("some.qc", "$body a \"gone\"\n$body b \"TINY\"\n"));
        QVERIFY2(some, some ? "" : describe(some.error()).c_str());
        QVERIFY(hasWarning(some->warnings, "\"gone\" was left out"));
        const auto none = import(write("none.qc", "\n$body a \"gone\"\n"));
        QVERIFY(!none);
        QCOMPARE(none.error().line, 2);
        const auto empty = import(write("empty.qc", "// nothing\n"));
        QVERIFY(!empty);
        QVERIFY(empty.error().message.find("no model") != std::string::npos);
        const auto foreign = import(write("dmx.qc", "$model a \"a.dmx\"\n"));
        QVERIFY(!foreign);
        QVERIFY(foreign.error().message.find("SMD") != std::string::npos);
    }

    void oddPathsAreHarmless() {
        write("tiny.smd", tiny);
        const std::string longName(10'000, 'x');
        std::string up;
        for (int i = 0; i < 3000; ++i)
            up += "../";
        for (const std::string& name :
             {longName, up + "etc/passwd", std::string("/dev/zero"), std::string("/proc/self/mem"),
              std::string("."), std::string(".."), std::string("tiny.smd/x.smd"),
              std::string("\\\\server\\share\\x.smd")}) {
            const auto model =
                import(write("odd.qc", "$include \"" + name + "\"\n$cdmaterials \"" + name +
                                           "\"\n$body b \"tiny\"\n$sequence s \"" + name + "\"\n"));
            QVERIFY2(model, model ? "" : describe(model.error()).c_str());
            QVERIFY(model->clips.empty());
        }
    }

    void filesThatComeWithOthers() {
        const BatchFiles sorted =
            sortFiles({data("wave.smd"), data("arm.smd"), data("arm.vta"), data("arm.qc")});
        QCOMPARE(sorted.models, std::vector{data("arm.qc")});
        QVERIFY(sorted.animations.empty());
        const BatchFiles bare = sortFiles({data("wave.smd"), data("arm.smd"), data("arm.vta")});
        QCOMPARE(bare.models, std::vector{data("arm.smd")});
        QCOMPARE(bare.animations, std::vector{data("wave.smd")});
    }

    void gameFolders() {
        write("game/materials/models/Hat/m.tga", "");
        QDir(folder_.path()).mkpath("game/materials/models/Hat");
        QVERIFY(QFile::copy(QString::fromStdString(data("Skins/Glow.png")),
                            folder_.filePath("game/materials/models/Hat/M.png")));
        QFile::remove(folder_.filePath("game/materials/models/Hat/m.tga"));
        write("game/modelsrc/hat/hat.smd", tiny);
        const auto model =
            import(write("game/modelsrc/hat/hat.qc", "$cdmaterials \"models\\hat\\\"\n$body b \"hat\"\n"));
        QVERIFY(model);
        QVERIFY(model->materials[0].baseColorTexture.image);
    }

    void mutationsNeverCrash() {
        QFile file(QString::fromStdString(data("arm.qc")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const std::string whole = file.readAll().toStdString();
        std::mt19937 random(11);
        const char* words[] = {"{",  "}",          "\"", "$sequence", "$body", "fps",
                               "-1", "frames 9 3", "\n", "/*",        "$"};
        for (int round = 0; round < 5000; ++round) {
            std::string text = whole.substr(0, round % 3 == 0 ? random() % whole.size() : whole.size());
            for (auto i = random() % 5; i > 0 && !text.empty(); --i) {
                const std::size_t at = random() % text.size();
                switch (random() % 3) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                default:
                    text.insert(at, words[random() % std::size(words)]);
                    break;
                }
            }
            const auto qc = readQc({"m.qc", text}, [&](const std::string&) {
                return Result<QcScript>(QcScript{"i.qci", text.substr(text.size() / 2)});
            });
            QVERIFY(qc || !qc.error().message.empty());
        }
    }
};

QTEST_GUILESS_MAIN(TestQc)
#include "tst_qc.moc"
