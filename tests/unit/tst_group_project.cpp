#include "core/project/project_file.h"
#include "tests/support/random_groups.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

using namespace prizma;
using namespace prizma::test;

/// Groups in the project file.
class TestGroupProject : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }

    static QByteArray bytesOf(const std::string& file) {
        QFile in(QString::fromStdString(file));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }

    Result<Project> load(const QByteArray& text) const {
        QFile out(QString::fromStdString(path("written.prizma")));
        if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
            qFatal("cannot write the project");
        out.close();
        Progress progress;
        return loadProject(path("written.prizma"), progress);
    }

  private Q_SLOTS:
    void treesComeBack();
    void parentsMayComeLater();
    void missingParentsAndCirclesAreTold();
    void aParentMustBeAName();
    void unknownKeysAreKept();
};

void TestGroupProject::treesComeBack() {
    std::mt19937 random(1);
    for (int run = 0; run < 30; ++run) {
        Scene scene = randomGroups(random);
        for (Group& group : scene.groups.edit())
            group.visible = random() % 4 != 0;
        scene.lights.edit()[0].solo = true;
        scene.objects.edit()[0].seenByCamera = false;
        scene.objects.edit()[1].castsShadows = false;
        scene.objects.edit()[2].seenInReflections = false;
        QVERIFY(saveProject(path("first.prizma"), scene));
        Progress progress;
        const auto loaded = loadProject(path("first.prizma"), progress);
        QVERIFY(loaded);
        QVERIFY(loaded->warnings.empty());
        const Scene& back = loaded->scene;
        QCOMPARE(back.groups.size(), scene.groups.size());
        const auto parentName = [](const Scene& s, Id parent) {
            const Group* group = findGroup(s, parent);
            return group ? group->name : std::string();
        };
        for (std::size_t i = 0; i < scene.groups.size(); ++i) {
            QCOMPARE(back.groups[i].name, scene.groups[i].name);
            QCOMPARE(back.groups[i].visible, scene.groups[i].visible);
            QVERIFY(back.groups[i].transform == scene.groups[i].transform);
            QCOMPARE(parentName(back, back.groups[i].parent), parentName(scene, scene.groups[i].parent));
        }
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            QVERIFY(worldMatrix(back, back.objects[i]) == worldMatrix(scene, scene.objects[i]));
            QCOMPARE(back.objects[i].seenByCamera, scene.objects[i].seenByCamera);
            QCOMPARE(back.objects[i].castsShadows, scene.objects[i].castsShadows);
            QCOMPARE(back.objects[i].seenInReflections, scene.objects[i].seenInReflections);
        }
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            QCOMPARE(parentName(back, back.lights[i].parent), parentName(scene, scene.lights[i].parent));
        QVERIFY(back.lights[0].solo);
        QVERIFY(saveProject(path("second.prizma"), back, loaded->unknownKeys));
        QCOMPARE(bytesOf(path("second.prizma")), bytesOf(path("first.prizma")));
    }
}

void TestGroupProject::parentsMayComeLater() {
    const auto project = load(R"({"prizma": 1,
        "groups": [{"name": "hand", "parent": "arm", "translation": [1, 0, 0]},
                   {"name": "arm", "translation": [0, 2, 0], "parent": null}],
        "objects": [{"name": "ball", "primitive": "sphere", "size": 1, "parent": "hand"}],
        "lights": [{"name": "lamp", "parent": "arm", "position": [0, 0, 3]}]})");
    QVERIFY(project);
    QVERIFY(project->warnings.empty());
    const Scene& scene = project->scene;
    QCOMPARE(glm::dvec3(worldMatrix(scene, scene.objects[0])[3]), glm::dvec3(1.0, 2.0, 0.0));
    QCOMPARE(lightsInWorld(scene)[0].position, glm::dvec3(0.0, 2.0, 3.0));
}

void TestGroupProject::missingParentsAndCirclesAreTold() {
    const auto project = load("{\"prizma\": 1,\n"
                              "\"groups\": [{\"name\": \"a\", \"parent\": \"b\"},\n"
                              "{\"name\": \"b\", \"parent\": \"c\"},\n"
                              "{\"name\": \"c\", \"parent\": \"a\"},\n"
                              "{\"name\": \"d\", \"parent\": \"d\"}],\n"
                              "\"objects\": [{\"name\": \"o\", \"primitive\": \"cube\", \"size\": 1,\n"
                              "\"parent\": \"nowhere\"}]}");
    QVERIFY(project);
    QCOMPARE(project->warnings.size(), std::size_t{3});
    QCOMPARE(project->warnings[0].line, 4);
    QVERIFY(project->warnings[0].message.find("itself") != std::string::npos);
    QCOMPARE(project->warnings[1].line, 5);
    QCOMPARE(project->warnings[2].line, 7);
    QVERIFY(project->warnings[2].message.find("\"nowhere\"") != std::string::npos);
    // What is left is a tree.
    QCOMPARE(findGroup(project->scene, project->scene.groups[0].parent)->name, std::string("b"));
    QCOMPARE(project->scene.groups[2].parent, noId);
    QCOMPARE(project->scene.groups[3].parent, noId);
    QCOMPARE(project->scene.objects[0].parent, noId);
}

void TestGroupProject::aParentMustBeAName() {
    for (const char* list : {"groups", "objects", "lights"}) {
        const auto project =
            load(QByteArray("{\"prizma\": 1, \"") + list +
                 "\": [{\"name\": \"x\", \"primitive\": \"cube\", \"size\": 1, \"parent\": 3}]}");
        QVERIFY(!project);
        QVERIFY(project.error().message.find("\"parent\"") != std::string::npos);
    }
    QVERIFY(!load("{\"prizma\": 1, \"groups\": {}}"));
}

void TestGroupProject::unknownKeysAreKept() {
    const auto project = load(R"({"prizma": 1, "groups": [{"name": "a", "note": "mine"}]})");
    QVERIFY(project);
    QVERIFY(saveProject(path("kept.prizma"), project->scene, project->unknownKeys));
    QVERIFY(bytesOf(path("kept.prizma")).contains("\"note\": \"mine\""));
}

QTEST_GUILESS_MAIN(TestGroupProject)
#include "tst_group_project.moc"
