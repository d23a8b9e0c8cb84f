#include "tests/ui/ui_test_support.h"

#include "core/scene/edits.h"
#include "core/scene/starter_scene.h"
#include "ui/document/edits.h"
#include "ui/properties/color_editor.h"
#include "ui/properties/property_editor.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>

#include <cmath>

using namespace prizma;
using namespace prizma::test;

class TestPropertyEditor : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() { isolation_ = std::make_unique<Isolation>(); }
    void init();
    void cleanup();
    void typingIsOneStep();
    void draggingIsOneStep();
    void twoDragsAreTwoSteps();
    void draggingTheLabel();
    void escapeReverts();
    void escapeCancelsADrag();
    void nonsenseIsRefused();
    void numbersAreClamped();
    void arrowKeysStep();
    void wheelNeedsFocus();
    void oneComponentOfMany();
    void severalAtOnce();
    void typeChangesTheRows();
    void rotationKeepsWhatWasTyped();
    void resetGoesBack();
    void colourDialogIsOneStep();
    void colourConversion();
    void textureIsReadInTheBackground();
    void textureThatIsMissing();
    void materialSlots();
    void materialFitsIntoANarrowPanel();
    void followsUndo();

  private:
    void select(const std::vector<EntityRef>& entities) { document_->setSelection(entities); }
    EntityRef object(std::size_t index) const {
        return {EntityKind::Object, document_->scene().objects[index].id};
    }
    EntityRef light(std::size_t index) const {
        return {EntityKind::Light, document_->scene().lights[index].id};
    }
    EntityRef material(std::size_t index) const {
        return {EntityKind::Material, document_->scene().materials[index].id};
    }
    NumberField& field(const char* name) const;
    int steps() const { return document_->undoStack().count(); }
    double intensity(std::size_t index) const { return document_->scene().lights[index].intensity; }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<PropertyEditor> editor_;
};

void TestPropertyEditor::init() {
    document_ = std::make_unique<Document>();
    Scene scene;
    for (const double strength : {10.0, 20.0, 30.0}) {
        Light light;
        light.name = "light";
        light.intensity = strength;
        light.position = {strength, strength + 1.0, strength + 2.0};
        addLight(scene, light);
    }
    addPrimitive(scene, PrimitiveType::Cube);
    addPrimitive(scene, PrimitiveType::Sphere);
    addMaterial(scene);
    document_->reset(scene, {});
    editor_ = std::make_unique<PropertyEditor>(*document_);
    editor_->resize(340, 700);
    editor_->show();
    QVERIFY(QTest::qWaitForWindowActive(editor_.get()));
}

void TestPropertyEditor::cleanup() {
    editor_.reset();
    document_.reset();
}

NumberField& TestPropertyEditor::field(const char* name) const {
    NumberField* found = visibleField(*editor_, QString::fromLatin1(name));
    if (!found)
        qFatal("there is no field %s", name);
    return *found;
}

void TestPropertyEditor::typingIsOneStep() {
    select({light(0)});
    typeInto(field("intensity"), QStringLiteral("2*3+1"));
    QCOMPARE(intensity(0), 7.0);
    QCOMPARE(steps(), 1);
    document_->undoStack().undo();
    QCOMPARE(intensity(0), 10.0);
}

void TestPropertyEditor::draggingIsOneStep() {
    select({light(0)});
    drag(field("intensity"), 60);
    QVERIFY(intensity(0) > 10.0);
    QCOMPARE(steps(), 1);
    QVERIFY(document_->undoStack().undoText().contains(QStringLiteral("intensity")));
    document_->undoStack().undo();
    QCOMPARE(intensity(0), 10.0);
}

void TestPropertyEditor::twoDragsAreTwoSteps() {
    select({light(0)});
    drag(field("intensity"), 60);
    const double afterFirst = intensity(0);
    drag(field("intensity"), -30);
    QCOMPARE(steps(), 2);
    document_->undoStack().undo();
    QCOMPARE(intensity(0), afterFirst);
}

void TestPropertyEditor::draggingTheLabel() {
    select({light(0)});
    QLabel* label = nullptr;
    for (QLabel* candidate : editor_->findChildren<QLabel*>())
        if (candidate->text() == QStringLiteral("Intensity") && candidate->isVisible())
            label = candidate;
    QVERIFY(label);
    dragHorizontally(*label, 40);
    QVERIFY(intensity(0) > 10.0);
    QCOMPARE(steps(), 1);
}

void TestPropertyEditor::escapeReverts() {
    select({light(0)});
    NumberField& number = field("intensity");
    QTest::mouseClick(number.findChild<QLineEdit*>(), Qt::LeftButton);
    QTest::keyClicks(&number, QStringLiteral("99"));
    QTest::keyClick(&number, Qt::Key_Escape);
    QVERIFY(!number.hasFocus());
    QCOMPARE(intensity(0), 10.0);
    QCOMPARE(steps(), 0);
    QCOMPARE(number.findChild<QLineEdit*>()->text(), QStringLiteral("10 W/sr"));
}

void TestPropertyEditor::escapeCancelsADrag() {
    select({light(0)});
    NumberField& number = field("intensity");
    number.beginDrag();
    number.dragBy(50, {});
    QVERIFY(intensity(0) > 10.0);
    QTest::keyClick(&number, Qt::Key_Escape);
    QCOMPARE(intensity(0), 10.0);
    QCOMPARE(steps(), 0);
}

void TestPropertyEditor::nonsenseIsRefused() {
    select({light(0)});
    NumberField& number = field("intensity");
    typeInto(number, QStringLiteral("2*"));
    QCOMPARE(intensity(0), 10.0);
    QVERIFY(number.hasFocus()); // to be put right
    QTest::keyClicks(&number, QStringLiteral("4"));
    QTest::keyClick(&number, Qt::Key_Return);
    QCOMPARE(intensity(0), 8.0);
}

void TestPropertyEditor::numbersAreClamped() {
    select({material(0)});
    typeInto(field("roughness"), QStringLiteral("17"));
    QCOMPARE(document_->scene().materials[0].roughness, 1.0);
    typeInto(field("roughness"), QStringLiteral("-3"));
    QCOMPARE(document_->scene().materials[0].roughness, 0.0);
}

void TestPropertyEditor::arrowKeysStep() {
    select({light(0)});
    NumberField& number = field("intensity");
    QTest::mouseClick(number.findChild<QLineEdit*>(), Qt::LeftButton);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&number, Qt::Key_Up);
    QCOMPARE(intensity(0), 25.0);
    QCOMPARE(steps(), 1); // pressed in quick succession
}

void TestPropertyEditor::wheelNeedsFocus() {
    select({light(0)});
    NumberField& number = field("intensity");
    const auto turn = [&number] {
        QWheelEvent wheel(number.rect().center(), number.mapToGlobal(number.rect().center()), {}, {0, 120},
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&number, &wheel);
        return wheel.isAccepted();
    };
    QVERIFY(!turn());
    QCOMPARE(intensity(0), 10.0);
    QTest::mouseClick(number.findChild<QLineEdit*>(), Qt::LeftButton);
    QVERIFY(turn());
    QCOMPARE(intensity(0), 15.0);
}

void TestPropertyEditor::oneComponentOfMany() {
    select({light(0), light(1)});
    typeInto(field("positionX"), QStringLiteral("-4"));
    QVERIFY(document_->scene().lights[0].position == glm::dvec3(-4, 11, 12));
    QVERIFY(document_->scene().lights[1].position == glm::dvec3(-4, 21, 22));
    QCOMPARE(steps(), 1);
}

void TestPropertyEditor::severalAtOnce() {
    select({light(0), light(1), light(2)});
    QCOMPARE(field("intensity").findChild<QLineEdit*>()->text(), QStringLiteral("—"));
    typeInto(field("intensity"), QStringLiteral("5"));
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(intensity(i), 5.0);
    QCOMPARE(steps(), 1);
    document_->undoStack().undo();
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(intensity(i), 10.0 * static_cast<double>(i + 1));
}

void TestPropertyEditor::typeChangesTheRows() {
    select({light(0)});
    QVERIFY(!visibleField(*editor_, QStringLiteral("radius")));
    QComboBox* type = nullptr;
    for (QComboBox* box : editor_->findChildren<QComboBox*>())
        if (box->isVisible())
            type = box;
    QVERIFY(type);
    type->setFocus();
    QTest::keyClick(type, Qt::Key_End);
    QVERIFY(document_->scene().lights[0].type == LightType::Sphere);
    QVERIFY(visibleField(*editor_, QStringLiteral("radius")));
    QVERIFY(!visibleField(*editor_, QStringLiteral("intensity")));
}

void TestPropertyEditor::rotationKeepsWhatWasTyped() {
    select({object(0)});
    typeInto(field("rotationY"), QStringLiteral("100"));
    QCOMPARE(field("rotationX").value(), 0.0);
    QCOMPARE(field("rotationY").value(), 100.0);
    typeInto(field("rotationX"), QStringLiteral("30"));
    QCOMPARE(field("rotationY").value(), 100.0);
    const glm::dquat expected = rotationFromEulerDegrees({30, 100, 0});
    QVERIFY(std::abs(std::abs(glm::dot(document_->scene().objects[0].transform.rotation, expected)) - 1.0) <
            1e-12);
}

void TestPropertyEditor::resetGoesBack() {
    select({material(0)});
    typeInto(field("roughness"), QStringLiteral("0.9"));
    auto* reset = editor_->findChild<QToolButton*>(QStringLiteral("roughnessReset"));
    QVERIFY(reset->isVisible());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(document_->scene().materials[0].roughness, Material().roughness);
    QVERIFY(!reset->isVisible());
}

void TestPropertyEditor::colourDialogIsOneStep() {
    select({material(0)});
    auto* swatch = editor_->findChild<QWidget*>(QStringLiteral("baseColorEditor"))
                       ->findChild<QToolButton*>(QStringLiteral("swatch"));
    QTest::mouseClick(swatch, Qt::LeftButton);
    auto* dialog = editor_->findChild<QColorDialog*>();
    QVERIFY(dialog);
    dialog->setCurrentColor(QColor(255, 0, 0));
    dialog->setCurrentColor(QColor(0, 188, 0));
    dialog->accept();
    const glm::dvec3 color = document_->scene().materials[0].baseColor;
    QCOMPARE(color.r, 0.0);
    QVERIFY2(std::abs(color.g - 0.5029) < 1e-3, qPrintable(QString::number(color.g))); // sRGB 188
    QCOMPARE(steps(), 1);
}

void TestPropertyEditor::colourConversion() {
    QCOMPARE(displayColor({1.0, 1.0, 1.0}), QColor(255, 255, 255));
    QCOMPARE(displayColor({0.0, 0.2158605, 1.0}).green(), 128);
    QCOMPARE(displayColor({4.0, 0.0, 0.0}).red(), 255); // brighter than white: scaled down
    for (int value = 0; value <= 255; value += 5) {
        const QColor color(value, 255 - value, 128);
        QCOMPARE(displayColor(linearColor(color)).rgb(), color.rgb());
    }
}

void TestPropertyEditor::textureIsReadInTheBackground() {
    const QString file = isolation_->path(QStringLiteral("checks.png"));
    QImage picture(4, 4, QImage::Format_RGB32);
    picture.fill(QColor(10, 200, 30));
    QVERIFY(picture.save(file));
    select({material(0)});
    auto* path = editor_->findChild<QWidget*>(QStringLiteral("baseColorTextureEditor"))
                     ->findChild<QLineEdit*>(QStringLiteral("texturePath"));
    QTest::mouseClick(path, Qt::LeftButton);
    QTest::keyClicks(path, file);
    QTest::keyClick(path, Qt::Key_Return);
    select({material(1)}); // the picture is for what was selected when it was asked for
    QTRY_VERIFY(document_->scene().materials[0].baseColorTexture.image);
    QCOMPARE(toQString(document_->scene().materials[0].baseColorTexture.file), file);
    QVERIFY(!document_->scene().materials[1].baseColorTexture.isSet());
    QCOMPARE(steps(), 1);
}

void TestPropertyEditor::textureThatIsMissing() {
    select({material(0)});
    QSignalSpy messages(editor_.get(), &PropertyEditor::message);
    auto* path = editor_->findChild<QWidget*>(QStringLiteral("baseColorTextureEditor"))
                     ->findChild<QLineEdit*>(QStringLiteral("texturePath"));
    QTest::mouseClick(path, Qt::LeftButton);
    QTest::keyClicks(path, isolation_->path(QStringLiteral("nowhere.png")));
    QTest::keyClick(path, Qt::Key_Return);
    QTRY_COMPARE(messages.count(), 1);
    const auto diagnostic = messages.first().first().value<Diagnostic>();
    QVERIFY(toQString(diagnostic.file).contains(QStringLiteral("nowhere.png")));
    QCOMPARE(steps(), 0);
    QVERIFY(!document_->scene().materials[0].baseColorTexture.isSet());
}

void TestPropertyEditor::materialFitsIntoANarrowPanel() {
    editor_->resize(280, 700); // the least that the window gives it
    select({material(0)});
    QTest::qWait(50);
    QStringList headings;
    for (const QLabel* label : editor_->findChildren<QLabel*>(QStringLiteral("sectionHeading")))
        if (label->isVisible())
            headings += label->text();
    QCOMPARE(headings, QStringList({"Colour", "Holes", "Reflection", "Glass", "Light", "Relief"}));
    int editors = 0;
    for (const ValueEditor* row : editor_->findChildren<ValueEditor*>()) {
        if (!row->isVisible())
            continue;
        ++editors;
        const int right = row->mapTo(editor_.get(), QPoint(row->width(), 0)).x();
        QVERIFY2(right <= editor_->width(), qPrintable(row->objectName()));
    }
    QVERIFY(editors > 15);
}

void TestPropertyEditor::materialSlots() {
    select({object(0), object(1)});
    auto* box = editor_->findChild<QComboBox*>(QStringLiteral("slot0"));
    QVERIFY(box && box->isVisible());
    box->setFocus();
    QTest::keyClick(box, Qt::Key_End);
    const Id last = document_->scene().materials.back().id;
    QCOMPARE(document_->scene().objects[0].materials.at(0), last);
    QCOMPARE(document_->scene().objects[1].materials.at(0), last);
    QCOMPARE(steps(), 1);
}

void TestPropertyEditor::followsUndo() {
    select({light(0)});
    typeInto(field("intensity"), QStringLiteral("77"));
    field("intensity").clearFocus();
    document_->undoStack().undo();
    QCOMPARE(field("intensity").value(), 10.0);
    document_->undoStack().redo();
    QCOMPARE(field("intensity").value(), 77.0);
}

QTEST_MAIN(TestPropertyEditor)
#include "tst_property_editor.moc"
