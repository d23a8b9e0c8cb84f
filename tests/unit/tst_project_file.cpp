#include "core/import/model_importer.h"
#include "core/project/project_file.h"
#include "core/scene/primitives.h"
#include "core/scene/properties.h"
#include "core/scene/starter_scene.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <random>

using namespace prizma;

namespace {

const char* const cubeObj = "mtllib two.mtl\n"
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                            "usemtl front side\nf 1 3 2\nf 1 4 3\nusemtl edge\nf 1 2 5\nf 1 5 4\n";
const char* const cubeMtl = "newmtl front side\nKd 0.1 0.2 0.3\nnewmtl edge\nKd 0.9 0.8 0.7\n";

double randomNumber(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(std::max(low, -1e5), std::min(high, 1e5))(random);
}

PropertyValue randomValue(const PropertyInfo& info, std::mt19937& random, const std::string& folder) {
    const auto number = [&] { return randomNumber(random, info.minimum, info.maximum); };
    switch (info.kind) {
    case PropertyKind::Boolean:
        return random() % 2 == 0;
    case PropertyKind::Integer:
        return static_cast<int>(number());
    case PropertyKind::Number:
        return number();
    case PropertyKind::Text:
        return "nämé \"" + std::to_string(random()) + "\" \\ /";
    case PropertyKind::Choice:
        return std::string(info.choices[random() % info.choices.size()].key);
    case PropertyKind::Vector2:
        return glm::dvec2(number(), number());
    case PropertyKind::Vector3:
    case PropertyKind::Color:
        return glm::dvec3(number(), number(), number());
    case PropertyKind::Rotation:
        return glm::normalize(glm::dquat(number(), number(), number(), number()));
    case PropertyKind::Texture:
        return Texture{folder + "/../pictures/p" + std::to_string(random()) + ".png", nullptr};
    }
    return {};
}

void randomise(Scene& scene, EntityRef entity, std::mt19937& random, const std::string& folder) {
    for (const PropertyInfo& info : properties(scene, entity))
        if (random() % 3 != 0) // the rest keep their defaults
            QVERIFY(prizma::setProperty(scene, entity, info.key, randomValue(info, random, folder)));
}

Scene randomScene(std::mt19937& random, const std::string& folder) {
    Scene scene;
    for (auto i = random() % 4 + 1; i > 0; --i)
        randomise(scene, {EntityKind::Material, addMaterial(scene, {})}, random, folder);
    for (auto i = random() % 6; i > 0; --i) {
        Object object;
        object.name = "object";
        object.source.primitive = static_cast<PrimitiveType>(random() % 5);
        object.source.size = randomNumber(random, 0.01, 10.0);
        object.mesh = makePrimitive(object.source.primitive, object.source.size);
        object.materials = {scene.materials[random() % scene.materials.size()].id};
        randomise(scene, {EntityKind::Object, addObject(scene, object)}, random, folder);
    }
    for (auto i = random() % 5; i > 0; --i)
        randomise(scene, {EntityKind::Light, addLight(scene, {})}, random, folder);
    for (const EntityKind kind :
         {EntityKind::Camera, EntityKind::Background, EntityKind::Timeline, EntityKind::Render})
        randomise(scene, {kind, noId}, random, folder);
    return scene;
}

std::string pathOf(const PropertyValue& value) {
    const auto* texture = std::get_if<Texture>(&value);
    return texture && !texture->file.empty()
               ? QDir::cleanPath(QString::fromStdString(texture->file)).toStdString()
               : std::string();
}

/// The first property in which two entities differ; empty if none does.
std::string findDifference(const Scene& a, EntityRef inA, const Scene& b, EntityRef inB) {
    const auto first = properties(a, inA);
    const auto second = properties(b, inB);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (pathOf(first[i].value) != pathOf(second[i].value) ||
            (pathOf(first[i].value).empty() && first[i].value != second[i].value))
            return std::string(first[i].key);
    return {};
}

} // namespace

class TestProjectFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const {
        return folder_.filePath(QString::fromUtf8(name)).toStdString();
    }

    void write(const std::string& file, const QByteArray& content) const {
        QFile stream(QString::fromStdString(file));
        QVERIFY(stream.open(QIODevice::WriteOnly));
        QCOMPARE(stream.write(content), content.size());
    }

    QByteArray read(const std::string& file) const {
        QFile stream(QString::fromStdString(file));
        return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
    }

    Result<Project> load(const std::string& file) const {
        Progress progress;
        return loadProject(file, progress);
    }

    Result<Project> loadText(const QByteArray& text) const {
        write(path("text.prizma"), text);
        return load(path("text.prizma"));
    }

    template <class T>
    void compare(const Scene& a, const CowList<T>& listA, const Scene& b, const CowList<T>& listB,
                 EntityKind kind) {
        QCOMPARE(listA.size(), listB.size());
        for (std::size_t i = 0; i < listA.size(); ++i)
            QCOMPARE(findDifference(a, {kind, listA[i].id}, b, {kind, listB[i].id}), std::string());
    }

  private Q_SLOTS:
    void init() {
        write(path("two.obj"), cubeObj);
        write(path("two.mtl"), cubeMtl);
    }

    void randomScenesRoundTrip() {
        std::mt19937 random(21);
        for (int round = 0; round < 60; ++round) {
            const Scene scene = randomScene(random, folder_.path().toStdString());
            QVERIFY(saveProject(path("r.prizma"), scene));
            const auto project = load(path("r.prizma"));
            QVERIFY2(project, project ? "" : describe(project.error()).c_str());
            const Scene& back = project->scene;
            compare(scene, scene.materials, back, back.materials, EntityKind::Material);
            compare(scene, scene.lights, back, back.lights, EntityKind::Light);
            compare(scene, scene.objects, back, back.objects, EntityKind::Object);
            for (const EntityKind kind :
                 {EntityKind::Camera, EntityKind::Background, EntityKind::Timeline, EntityKind::Render})
                QCOMPARE(findDifference(scene, {kind, noId}, back, {kind, noId}), std::string());
            for (std::size_t i = 0; i < scene.objects.size(); ++i) {
                QVERIFY(scene.objects[i].source == back.objects[i].source);
                QCOMPARE(back.findMaterial(back.objects[i].materials.at(0))->name,
                         scene.findMaterial(scene.objects[i].materials.at(0))->name);
            }
            const QByteArray first = read(path("r.prizma"));
            QVERIFY(saveProject(path("r.prizma"), back, project->unknownKeys));
            QCOMPARE(read(path("r.prizma")), first);
        }
    }

    void defaultsAreNotWritten() {
        QVERIFY(saveProject(path("d.prizma"), {}));
        const auto root = QJsonDocument::fromJson(read(path("d.prizma"))).object();
        QCOMPARE(root.keys(), QStringList({"lights", "materials", "objects", "prizma"}));
        QCOMPARE(root["prizma"].toInt(), 1);
    }

    void unknownKeysSurvive() {
        const QByteArray text = R"({"prizma": 1, "future": {"a": [1, {"b": null}]},
            "camera": {"fovY": 30, "lens": "thin"}, "render": {"bounces": 9},
            "materials": [{"name": "m", "sheen": 0.5}],
            "objects": [{"name": "o", "primitive": "cube", "size": 2, "material": "m", "tag": "x"}],
            "lights": [{"name": "l", "ies": "a.ies"}]})";
        auto project = loadText(text);
        QVERIFY(project);
        project->scene.camera.fovY = 40.0;
        QVERIFY(saveProject(path("u.prizma"), project->scene, project->unknownKeys));
        const auto root = QJsonDocument::fromJson(read(path("u.prizma"))).object();
        QCOMPARE(root["future"].toObject()["a"].toArray().size(), 2);
        QCOMPARE(root["camera"].toObject()["lens"].toString(), QString("thin"));
        QCOMPARE(root["camera"].toObject()["fovY"].toDouble(), 40.0);
        QCOMPARE(root["render"].toObject()["bounces"].toInt(), 9);
        QCOMPARE(root["materials"].toArray()[0].toObject()["sheen"].toDouble(), 0.5);
        QCOMPARE(root["objects"].toArray()[0].toObject()["tag"].toString(), QString("x"));
        QCOMPARE(root["lights"].toArray()[0].toObject()["ies"].toString(), QString("a.ies"));
    }

    void modelsShareTheirMesh() {
        const auto project = loadText(R"({"prizma": 1, "objects": [
            {"name": "a", "model": "two.obj"}, {"name": "b", "model": ".\\TWO.OBJ"},
            {"name": "c", "model": "two.obj", "upAxis": "z", "unitScale": 2}]})");
        QVERIFY(project);
        const auto& objects = project->scene.objects;
        QVERIFY(objects[0].mesh && objects[0].mesh == objects[1].mesh && objects[0].mesh != objects[2].mesh);
        QVERIFY(objects[0].materials == objects[1].materials);
        QCOMPARE(objects[2].mesh->bounds.high.y, 2.0F);
    }

    void materialsComeFromModelOrProject() {
        const auto project =
            loadText(R"({"prizma": 1, "materials": [{"name": "glass", "transmission": 1}], "objects": [
            {"name": "a", "model": "two.obj", "materials": {"edge": "glass"}},
            {"name": "b", "model": "two.obj", "material": "glass"},
            {"name": "c", "model": "two.obj", "material": "no such"}]})");
        QVERIFY(project);
        const Scene& scene = project->scene;
        const auto nameOf = [&](std::size_t object, std::size_t slot) {
            return scene.findMaterial(scene.objects[object].materials.at(slot))->name;
        };
        QCOMPARE(nameOf(0, 0), std::string("front side"));
        QCOMPARE(nameOf(0, 1), std::string("glass"));
        QCOMPARE(nameOf(1, 0), std::string("glass"));
        QCOMPARE(nameOf(1, 1), std::string("glass"));
        QCOMPARE(nameOf(2, 1), std::string("edge"));
        QVERIFY(scene.findMaterial(scene.objects[0].materials[0])->baseColor.z > 0.29);
        QVERIFY(!project->warnings.empty());
        // Saved and opened again, every slot has what it had.
        QVERIFY(saveProject(path("again.prizma"), scene, project->unknownKeys));
        const auto again = load(path("again.prizma"));
        QVERIFY(again);
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            for (std::size_t slot = 0; slot < 2; ++slot)
                QCOMPARE(again->scene.findMaterial(again->scene.objects[i].materials.at(slot))->name,
                         nameOf(i, slot));
        QCOMPARE(again->scene.materials.size(), scene.materials.size());
    }

    void missingModelStays() {
        auto project = loadText(R"({"prizma": 1, "materials": [{"name": "m"}], "objects": [
            {"name": "a", "model": "gone/x.obj", "materials": {"slot one": "m"}, "translation": [1, 2, 3],
             "upAxis": "z", "clips": ["walk.smd"], "clip": "walk"}]})");
        QVERIFY(project);
        QVERIFY(!project->scene.objects[0].mesh);
        bool named = false;
        for (const Diagnostic& warning : project->warnings)
            named = named || warning.file.ends_with("gone/x.obj");
        QVERIFY(named);
        QVERIFY(saveProject(path("m.prizma"), project->scene, project->unknownKeys));
        const auto object =
            QJsonDocument::fromJson(read(path("m.prizma"))).object()["objects"].toArray()[0].toObject();
        QCOMPARE(object["model"].toString(), QString("gone/x.obj"));
        QCOMPARE(object["materials"].toObject()["slot one"].toString(), QString("m"));
        QCOMPARE(object["upAxis"].toString(), QString("z"));
        QCOMPARE(object["clips"].toArray()[0].toString(), QString("walk.smd"));
        QCOMPARE(object["clip"].toString(), QString("walk"));
        QCOMPARE(object["translation"].toArray()[2].toDouble(), 3.0);
    }

    void clipsAreLoaded() {
        QVERIFY(QDir(folder_.path()).mkpath("anims/other"));
        const auto copy = [&](const char* from, const char* to) {
            QFile::remove(folder_.filePath(to));
            return QFile::copy(QStringLiteral(PRIZMA_TEST_DATA "/smd/") + from, folder_.filePath(to));
        };
        QVERIFY(copy("arm.smd", "arm.smd") && copy("wave.smd", "anims/wave.smd") &&
                copy("wave.smd", "anims/other/wave.smd"));
        const auto project = loadText(R"({"prizma": 1, "objects": [{"name": "a", "model": "arm.smd",
            "clips": ["anims/wave.smd", "gone.smd", "anims/other/wave.smd"], "clip": "wave 2"}]})");
        QVERIFY(project);
        const Object& object = project->scene.objects[0];
        QVERIFY(object.source.upAxis == UpAxis::Z); // as SMDs are, if the project does not say
        QVERIFY(object.dynamic);
        QCOMPARE(object.clip, std::string("wave 2"));
        QCOMPARE(object.clips.size(), std::size_t(2));
        QCOMPARE(object.clips[0]->name, std::string("wave"));
        QCOMPARE(object.clips[1]->name, std::string("wave 2"));
        const auto gone = std::ranges::find_if(
            project->warnings, [](const Diagnostic& warning) { return warning.file.ends_with("/gone.smd"); });
        QVERIFY(gone != project->warnings.end());
        QVERIFY(gone->severity == Severity::Warning);
        QVERIFY(saveProject(path("again.prizma"), project->scene, project->unknownKeys));
        const auto json =
            QJsonDocument::fromJson(read(path("again.prizma"))).object()["objects"].toArray()[0].toObject();
        QCOMPARE(json["clips"].toArray(), (QJsonArray{"anims/wave.smd", "gone.smd", "anims/other/wave.smd"}));
        QCOMPARE(json["upAxis"].toString(), QString("z"));
        const auto again = load(path("again.prizma"));
        QVERIFY(again);
        QCOMPARE(again->scene.objects[0].clips.size(), std::size_t(2));
        QCOMPARE(again->scene.objects[0].clip, std::string("wave 2"));
    }

    void pathsFollowTheProject() {
        Scene scene;
        Material material;
        material.name = "m";
        material.baseColorTexture.file = path("pictures/a b.png");
        addMaterial(scene, material);
        QVERIFY(QDir(folder_.path()).mkpath("sub"));
        QVERIFY(saveProject(path("sub/p.prizma"), scene));
        const auto root = QJsonDocument::fromJson(read(path("sub/p.prizma"))).object();
        QCOMPARE(root["materials"].toArray()[0].toObject()["baseColorTexture"].toString(),
                 QString("../pictures/a b.png"));
        const auto project = load(path("sub/p.prizma"));
        QVERIFY(project);
        QCOMPARE(project->scene.materials[0].baseColorTexture.file, path("pictures/a b.png"));
        QCOMPARE(project->warnings.size(), std::size_t(1));
    }

    void faults_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const char* text, int line, const char* word) {
            QTest::newRow(name) << QByteArray(text) << line << QString(word);
        };
        row("empty", "", 0, "empty");
        row("no json", "hello", 1, "JSON");
        row("a list", "[1]", 1, "not a Prizma project");
        row("comma", "{\n\"prizma\": 1,\n\"camera\": {,}\n}", 3, "JSON");
        row("cut off", "{\n\"prizma\": 1,\n\"camera\": {", 3, "cut off");
        row("no version", "{}", 1, "version");
        row("newer", "{\n\"prizma\": 2}", 2, "newer");
        row("version text", "{\"prizma\": \"1\"}", 1, "prizma");
        row("fovY", "{\"prizma\": 1,\n\"camera\":\n{\"fovY\": \"wide\"}}", 3, "fovY");
        row("position", "{\"prizma\": 1, \"camera\": {\n\"position\": [1, 2]}}", 2, "position");
        row("section", "{\"prizma\": 1,\n\"render\": 5}", 2, "render");
        row("list", "{\"prizma\": 1,\n\"lights\": {}}", 2, "lights");
        row("item", "{\"prizma\": 1,\n\"lights\": [\n7]}", 3, "lights");
        row("choice", "{\"prizma\": 1, \"lights\": [\n{\"type\": \"laser\"}]}", 2, "type");
        row("primitive", "{\"prizma\": 1, \"objects\": [\n{\"primitive\": \"cone\"}]}", 2, "primitive");
        row("size", "{\"prizma\": 1, \"objects\": [{\"primitive\": \"cube\",\n\"size\": -1}]}", 2, "size");
        row("no source", "{\"prizma\": 1, \"objects\": [\n{}]}", 2, "model");
        row("materials", "{\"prizma\": 1, \"objects\": [{\"primitive\": \"cube\",\n\"materials\": 3}]}", 2,
            "materials");
        row("whole", "{\"prizma\": 1, \"render\": {\n\"samples\": 1.5}}", 2, "samples");
    }
    void faults() {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        QFETCH(QString, word);
        const auto project = loadText(text);
        QVERIFY(!project);
        QCOMPARE(project.error().file, path("text.prizma"));
        QCOMPARE(project.error().line, line);
        QVERIFY2(QString::fromStdString(project.error().message).contains(word),
                 project.error().message.c_str());
    }

    void damagedProjectsNeverCrash() {
        Progress progress;
        const auto whole = QByteArray(R"({"prizma": 1, "camera": {"fovY": 30}, "materials": [{"name": "m"}],
            "objects": [{"name": "o", "primitive": "cube", "size": 2, "material": "m"}], "lights": [{"name": "l"}]})");
        for (int length = 0; length < whole.size(); ++length)
            QVERIFY(!loadText(whole.left(length)));
        std::mt19937 random(4);
        for (int round = 0; round < 300; ++round) {
            QByteArray bent = whole;
            bent[static_cast<int>(random() % static_cast<unsigned>(bent.size()))] =
                static_cast<char>(random());
            const auto project = loadText(bent);
            QVERIFY(project || !project.error().message.empty());
        }
        const auto deep = loadText("{\"prizma\": 1, \"x\": " + QByteArray(200'000, '['));
        QVERIFY(!deep);
    }

    void faultsOfTheDisk() {
        QVERIFY(!load(path("missing.prizma")));
        QVERIFY(!load(folder_.path().toStdString()));
        QVERIFY(!saveProject("/no/such/folder/x.prizma", {}));
        QVERIFY(!saveProject(folder_.path().toStdString(), {}));
    }

    void savingLeavesNoTemporaryFile() {
        QTemporaryDir other;
        for (int i = 0; i < 3; ++i)
            QVERIFY(saveProject(other.filePath("p.prizma").toStdString(), makeStarterScene()));
        QCOMPARE(QDir(other.path()).entryList(QDir::Files), QStringList("p.prizma"));
    }

    void cancelling() {
        write(path("c.prizma"), R"({"prizma": 1, "objects": [{"name": "a", "model": "two.obj"}]})");
        Progress progress;
        progress.cancel();
        QVERIFY(!loadProject(path("c.prizma"), progress));
    }

    void theDemoLoads() {
        const auto project = load(std::string(PRIZMA_SOURCE_DIR) + "/resources/demo/demo.prizma");
        QVERIFY2(project, project ? "" : describe(project.error()).c_str());
        QVERIFY(project->warnings.empty());
        QCOMPARE(project->scene.lights.size(), std::size_t(3));
        for (const Object& object : project->scene.objects)
            QVERIFY(object.mesh);
    }
};

QTEST_GUILESS_MAIN(TestProjectFile)
#include "tst_project_file.moc"
