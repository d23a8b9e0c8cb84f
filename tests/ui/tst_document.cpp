#include "core/scene/edits.h"
#include "core/scene/starter_scene.h"
#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/properties/expression.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace prizma;

namespace {

Scene makeScene() {
    Scene scene = makeStarterScene();
    addPrimitive(scene, PrimitiveType::Cube);
    addPrimitive(scene, PrimitiveType::Sphere);
    addMaterial(scene);
    return scene;
}

bool looksEqual(Scene a, const Scene& b) {
    a.lastId = b.lastId;
    return a == b;
}

EntityRef anything(const Scene& scene, std::mt19937& random) {
    std::vector<EntityRef> all{{EntityKind::Background}, {EntityKind::Render}, {EntityKind::Timeline}};
    for (const Object& object : scene.objects)
        all.push_back({EntityKind::Object, object.id});
    for (const Light& light : scene.lights)
        all.push_back({EntityKind::Light, light.id});
    for (const Material& material : scene.materials)
        all.push_back({EntityKind::Material, material.id});
    return all[random() % all.size()];
}

/// Some other value of the same kind.
PropertyValue altered(const PropertyInfo& info, std::mt19937& random) {
    const double number = std::uniform_real_distribution(0.0, 2.0)(random);
    switch (info.kind) {
    case PropertyKind::Boolean:
        return !std::get<bool>(info.value);
    case PropertyKind::Integer:
        return static_cast<int>(random() % 5);
    case PropertyKind::Number:
        return number;
    case PropertyKind::Text:
        return info.key == "clip" ? std::string() : "name " + std::to_string(random() % 100);
    case PropertyKind::Choice:
        return std::string(info.choices[random() % info.choices.size()].key);
    case PropertyKind::Vector2:
        return glm::dvec2(number, 1.0);
    case PropertyKind::Vector3:
    case PropertyKind::Color:
        return glm::dvec3(number, 0.5, 0.25);
    case PropertyKind::Rotation:
        return rotationFromEulerDegrees({number * 90.0, 10.0, 0.0});
    case PropertyKind::Texture:
        return Texture{};
    }
    return info.value;
}

void editAtRandom(Document& document, std::mt19937& random) {
    const EntityRef entity = anything(document.scene(), random);
    switch (random() % 6) {
    case 0:
        document.setSelection({entity});
        deleteSelected(document);
        break;
    case 1:
        document.setSelection({entity});
        duplicateSelected(document);
        break;
    case 2:
        addLight(document, static_cast<LightType>(random() % 5));
        break;
    default: {
        const auto all = properties(document.scene(), entity);
        const PropertyInfo& info = all[random() % all.size()];
        if (info.key == "frame")
            break; // moving in time is no step: undoKeepsTheFrame
        document.setProperty({entity}, info.key, altered(info, random));
    }
    }
}

} // namespace

class TestDocument : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void undoGoesAllTheWayBack();
    void gesturesAreSteps();
    void gestureWithoutOutcomeIsNoStep();
    void undoKeepsTheCamera();
    void cameraEditsCanBeUndone();
    void undoKeepsTheFrame();
    void movingInTimeIsNoEdit();
    void previewIsNoEdit();
    void selectionStaysValid();
    void renamingIsToldAndUnique();
    void deletedMaterialsAreReplaced();
    void idsAreNeverUsedTwice();
    void savedIsUnmodified();
    void goesWithoutAWord();
    void badValuesAreRefused();
    void expressions_data();
    void expressions();
    void brokenExpressions();
};

void TestDocument::undoGoesAllTheWayBack() {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        Document document;
        document.reset(makeScene(), {});
        const Scene first = document.scene();
        for (int i = 0; i < 60; ++i)
            editAtRandom(document, random);
        const Scene last = document.scene();
        QVERIFY(document.undoStack().count() > 10);
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QVERIFY2(looksEqual(document.scene(), first), qPrintable(QString::number(seed)));
        QVERIFY(!document.isModified());
        while (document.undoStack().canRedo())
            document.undoStack().redo();
        QVERIFY2(looksEqual(document.scene(), last), qPrintable(QString::number(seed)));
    }
}

void TestDocument::gesturesAreSteps() {
    Document document;
    document.reset(makeScene(), {});
    const EntityRef light{EntityKind::Light, document.scene().lights[0].id};
    for (int drag = 0; drag < 2; ++drag) {
        const int gesture = document.newGesture();
        for (int i = 1; i <= 10; ++i)
            document.setProperty({light}, "intensity", 100.0 * drag + i, gesture);
    }
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.scene().lights[0].intensity, 10.0);
}

void TestDocument::gestureWithoutOutcomeIsNoStep() {
    Document document;
    document.reset(makeScene(), {});
    const EntityRef light{EntityKind::Light, document.scene().lights[0].id};
    const double before = document.scene().lights[0].intensity;
    const int gesture = document.newGesture();
    document.setProperty({light}, "intensity", before + 1.0, gesture);
    document.setProperty({light}, "intensity", before, gesture);
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(!document.isModified());
}

void TestDocument::undoKeepsTheCamera() {
    Document document;
    document.reset(makeScene(), {});
    document.setProperty({{EntityKind::Render}}, "exposure", 1.0);
    Camera camera = document.scene().camera;
    camera.position.x += 5.0;
    document.setCamera(camera);
    document.undoStack().undo();
    QCOMPARE(document.scene().render.exposure, 0.0);
    QVERIFY(document.scene().camera == camera);
    document.undoStack().redo();
    QVERIFY(document.scene().camera == camera);
}

void TestDocument::cameraEditsCanBeUndone() {
    Document document;
    document.reset(makeScene(), {});
    const double before = document.scene().camera.fovY;
    document.setProperty({{EntityKind::Camera}}, "fovY", 80.0);
    QCOMPARE(document.scene().camera.fovY, 80.0);
    document.undoStack().undo();
    QCOMPARE(document.scene().camera.fovY, before);
}

void TestDocument::undoKeepsTheFrame() {
    Document document;
    document.reset(makeScene(), {});
    const EntityRef timeline{EntityKind::Timeline};
    const int gesture = document.newGesture();
    document.setProperty({timeline}, "end", 50, gesture);
    document.setFrame(7.5);
    document.setProperty({timeline}, "end", 60, gesture);
    QCOMPARE(document.undoStack().count(), 1);
    document.setFrame(8.5);
    document.undoStack().undo();
    QCOMPARE(document.scene().timeline.end, 120);
    QCOMPARE(document.scene().timeline.frame, 8.5);
    document.undoStack().redo();
    QCOMPARE(document.scene().timeline.end, 60);
    QCOMPARE(document.scene().timeline.frame, 8.5);
    // A gesture that comes to nothing while time goes on is no step, either.
    const int other = document.newGesture();
    document.setProperty({timeline}, "end", 61, other);
    document.setFrame(9.0);
    document.setProperty({timeline}, "end", 60, other);
    QCOMPARE(document.undoStack().count(), 1);
}

void TestDocument::movingInTimeIsNoEdit() {
    QTemporaryDir folder;
    Document document;
    document.reset(makeScene(), {});
    QCOMPARE(document.save(folder.filePath(QStringLiteral("a.prizma"))), QString());
    QSignalSpy changed(&document, &Document::sceneChanged);
    document.setFrame(12.25);
    QCOMPARE(changed.count(), 1);
    QVERIFY(changed.takeFirst().at(0).value<SceneDiff>().isTimeOnly());
    document.setFrame(12.25);
    document.setFrame(std::nan(""));
    QCOMPARE(changed.count(), 0);
    // In the property panel, too, although that goes the way of all edits.
    QCOMPARE(document.setProperty({{EntityKind::Timeline}}, "frame", 13.0), QString());
    QCOMPARE(document.scene().timeline.frame, 13.0);
    QVERIFY(!document.isModified());
    QCOMPARE(document.undoStack().count(), 0);
    // Saved with the project all the same.
    QCOMPARE(document.save(document.file()), QString());
    Progress progress;
    const auto loaded = loadProject(document.file().toStdString(), progress);
    QVERIFY(loaded);
    QCOMPARE(loaded->scene.timeline.frame, 13.0);
}

void TestDocument::previewIsNoEdit() {
    Document document;
    document.reset(makeScene(), {});
    const Scene before = document.scene();
    QSignalSpy previewed(&document, &Document::previewChanged);
    document.setPreview([](Scene& scene) { scene.objects.edit()[0].visible = false; });
    QCOMPARE(previewed.count(), 1);
    QVERIFY(!document.shownScene().objects[0].visible);
    QVERIFY(document.scene() == before);
    QVERIFY(!document.isModified());
    // It goes on top of whatever happens meanwhile.
    document.setFrame(3.0);
    QCOMPARE(document.shownScene().timeline.frame, 3.0);
    QVERIFY(!document.shownScene().objects[0].visible);
    document.endPreview();
    document.endPreview();
    QCOMPARE(previewed.count(), 2);
    QVERIFY(document.shownScene() == document.scene());
    document.setPreview([](Scene& scene) { scene.objects = {}; });
    document.reset(makeScene(), {});
    QVERIFY(!document.hasPreview());
}

void TestDocument::selectionStaysValid() {
    Document document;
    document.reset(makeScene(), {});
    const EntityRef object{EntityKind::Object, document.scene().objects[0].id};
    document.setSelection({object, {EntityKind::Object, 123456}, object, {EntityKind::Camera}});
    QCOMPARE(document.selection().size(), 2U); // what is not there and what comes twice is left out
    QSignalSpy changed(&document, &Document::selectionChanged);
    document.edit(QStringLiteral("remove"), [](Scene& scene) { scene.objects = {}; });
    QCOMPARE(changed.count(), 1);
    QVERIFY(document.selection() == std::vector<EntityRef>{{EntityKind::Camera}});
}

void TestDocument::renamingIsToldAndUnique() {
    Document document;
    document.reset(makeScene(), {});
    QSignalSpy changed(&document, &Document::sceneChanged);
    const auto& materials = document.scene().materials;
    const std::string taken = materials[0].name;
    QCOMPARE(document.setProperty({{EntityKind::Material, materials[1].id}}, "name", taken), QString());
    QCOMPARE(changed.count(), 1); // although the picture does not change
    QVERIFY(document.scene().materials[1].name != taken);
    QVERIFY(document.scene().materials[1].name.starts_with(taken.substr(0, taken.find(' '))));
    QVERIFY(!document.setProperty({{EntityKind::Material, materials[1].id}}, "name", std::string("  "))
                 .isEmpty());
}

void TestDocument::deletedMaterialsAreReplaced() {
    Document document;
    document.reset(makeScene(), {});
    const Id used = document.scene().objects[0].materials.at(0);
    document.setSelection({{EntityKind::Material, used}});
    deleteSelected(document);
    QVERIFY(!document.scene().findMaterial(used));
    for (const Object& object : document.scene().objects)
        for (const Id material : object.materials)
            QVERIFY(document.scene().findMaterial(material));
}

void TestDocument::idsAreNeverUsedTwice() {
    Document document;
    document.reset(makeScene(), {});
    addLight(document, LightType::Point);
    const Id first = document.selection().back().id;
    document.undoStack().undo();
    addLight(document, LightType::Point);
    QVERIFY(document.selection().back().id != first);
}

void TestDocument::savedIsUnmodified() {
    QTemporaryDir folder;
    Document document;
    document.reset(makeScene(), {});
    Camera camera = document.scene().camera;
    camera.fovY = 30.0;
    document.setCamera(camera);
    QVERIFY(!document.isModified()); // looking around in a nameless scene is no work
    addLight(document, LightType::Spot);
    QVERIFY(document.isModified());
    QCOMPARE(document.save(folder.filePath(QStringLiteral("a scene.prizma"))), QString());
    QVERIFY(!document.isModified());
    QCOMPARE(document.title(), QStringLiteral("a scene.prizma"));
    camera.fovY = 31.0;
    document.setCamera(camera);
    QVERIFY(document.isModified());
    QVERIFY(!document.save(folder.filePath(QStringLiteral("no/such/folder/x.prizma"))).isEmpty());
    QVERIFY(document.isModified());
}

void TestDocument::goesWithoutAWord() {
    int told = 0;
    {
        Document document;
        document.reset(makeScene(), {});
        addLight(document, LightType::Spot);
        QVERIFY(document.isModified());
        QObject::connect(&document, &Document::fileChanged, [&told] { ++told; });
    }
    QCOMPARE(told, 0);
}

void TestDocument::badValuesAreRefused() {
    Document document;
    document.reset(makeScene(), {});
    const EntityRef light{EntityKind::Light, document.scene().lights[0].id};
    QVERIFY(!document.setProperty({light}, "intensity", std::string("many")).isEmpty());
    QVERIFY(!document.setProperty({light}, "intensity", std::nan("")).isEmpty());
    QVERIFY(!document.setProperty({light}, "no such key", 1.0).isEmpty());
    QVERIFY(!document.setProperty({{EntityKind::Light, 99999}}, "intensity", 1.0).isEmpty());
    QCOMPARE(document.undoStack().count(), 0);
}

void TestDocument::expressions_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("expected");
    QTest::newRow("sum") << "2*3+1" << 7.0;
    QTest::newRow("brackets") << " 2 * (3 + 1) " << 8.0;
    QTest::newRow("signs") << "--2-+3" << -1.0;
    QTest::newRow("power") << "2^3^2" << 512.0;
    QTest::newRow("power binds before sign") << "-2^2" << -4.0;
    QTest::newRow("comma") << "1,5" << 1.5;
    QTest::newRow("exponent") << "1.5e-3" << 0.0015;
    QTest::newRow("percent") << "50%" << 0.5;
    QTest::newRow("unit") << "90°" << 90.0;
    QTest::newRow("pi") << "pi/2" << std::acos(0.0);
    QTest::newRow("root") << "sqrt(2)*sqrt(2)" << 2.0;
    QTest::newRow("sine of degrees") << "sin(30)" << 0.5;
    QTest::newRow("relative") << "+=5" << 15.0;
    QTest::newRow("relative product") << "*=0,5" << 5.0;
}

void TestDocument::expressions() {
    QFETCH(QString, text);
    QFETCH(double, expected);
    const auto value = evaluate(text, QStringLiteral("°"), 10.0);
    QVERIFY(value.has_value());
    QVERIFY2(std::abs(*value - expected) < 1e-12, qPrintable(QString::number(*value, 'g', 17)));
}

void TestDocument::brokenExpressions() {
    for (const char* text :
         {"", "abc", "1+", "(1", "1)", "1 2", "1/0", "sqrt(-1)", "..", "1e", "*3", "+=", "foo(1)"})
        QVERIFY2(!evaluate(QString::fromLatin1(text)).has_value(), text);
    QVERIFY(!evaluate(QString(100000, QLatin1Char('('))).has_value());
    std::mt19937 random(7);
    const QString symbols = QStringLiteral("0123456789.+-*/^()e%,=pisqrt ");
    for (int i = 0; i < 20000; ++i) {
        QString text;
        for (auto length = random() % 12; length > 0; --length)
            text += symbols[static_cast<qsizetype>(random() % static_cast<std::size_t>(symbols.size()))];
        const auto value = evaluate(text);
        QVERIFY2(!value || std::isfinite(*value), qPrintable(text));
    }
}

QTEST_MAIN(TestDocument)
#include "tst_document.moc"
