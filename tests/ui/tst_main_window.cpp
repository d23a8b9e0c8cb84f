#include "tests/ui/ui_test_support.h"

#include "core/scene/property_tables.h"
#include "core/scene/starter_scene.h"
#include "ui/document/edits.h"
#include "ui/import/import_settings.h"
#include "ui/log/log_panel.h"
#include "ui/main_window/file_actions.h"
#include "ui/properties/property_editor.h"
#include "ui/scene_tree/scene_tree.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTreeWidget>

using namespace prizma;
using namespace prizma::test;

namespace {

constexpr auto triangle = "o thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

QDockWidget* panel(MainWindow& window, const char* name) {
    return window.findChild<QDockWidget*>(QString::fromLatin1(name));
}

QMessageBox* question(MainWindow& window) {
    return window.findChild<QMessageBox*>(QStringLiteral("unsavedChanges"));
}

} // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() { isolation_ = std::make_unique<Isolation>(); }
    void init() {
        QSettings().clear();
        window_ = showWindow();
    }
    void cleanup() { window_.reset(); }

    void renameThenUndo();
    void addLightThroughTheMenu();
    void deleteAndDuplicate();
    void undoAndRedoAll();
    void titleTellsFileAndState();
    void importSelectsAndFrames();
    void brokenImportChangesNothing_data();
    void brokenImportChangesNothing();
    void brokenProjectChangesNothing();
    void missingTextureIsAWarning();
    void importCanBeCancelled();
    void saveAndOpenAgain();
    void sampleHasNoFile();
    void closeAsksFirst();
    void cancelKeepsTheWork();
    void newAsksFirst();
    void dropImports();
    void recentFilesAreKept();
    void layoutIsReset();
    void layoutIsRemembered();
    void shadersCanBeChosen();
    void everyShaderHasItsKey();
    void displayIsChosenInTheMenu();
    void shortcutsAreUnique();
    void cheatSheetListsAll();
    void doubleClickOnAMessageSelects();

  private:
    const Scene& scene() const { return window_->document().scene(); }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<MainWindow> window_;
};

void TestMainWindow::renameThenUndo() {
    QTreeView& view = window_->sceneTree().view();
    const EntityRef object{EntityKind::Object, scene().objects[0].id};
    const std::string before = scene().objects[0].name;
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {},
                      view.visualRect(window_->sceneTree().indexOf(object)).center());
    QTest::keyClick(&view, Qt::Key_F2);
    auto* editor = view.findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, QStringLiteral("floor 7"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(toQString(scene().objects[0].name), QStringLiteral("floor 7"));
    QVERIFY(window_->isWindowModified());
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(scene().objects[0].name, before);
    QVERIFY(!window_->isWindowModified());
}

void TestMainWindow::addLightThroughTheMenu() {
    const auto count = scene().lights.size();
    trigger(*window_, QStringLiteral("Add/Light/Spot"));
    QCOMPARE(scene().lights.size(), count + 1);
    QVERIFY(scene().lights.back().type == LightType::Spot);
    QVERIFY((window_->document().selection() ==
             std::vector{EntityRef{EntityKind::Light, scene().lights.back().id}}));
    QVERIFY(visibleField(window_->propertyEditor(), QStringLiteral("outerAngle")));
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(scene().lights.size(), count);
}

void TestMainWindow::deleteAndDuplicate() {
    trigger(*window_, QStringLiteral("Add/Primitive/Cube"));
    const auto count = scene().objects.size();
    QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(scene().objects.size(), count + 1);
    const Id copy = scene().objects.back().id;
    QVERIFY(scene().objects.back().name != scene().objects[count - 1].name);
    QTest::keyClick(window_.get(), Qt::Key_Delete);
    QCOMPARE(scene().objects.size(), count);
    QVERIFY(!scene().findObject(copy));
    QVERIFY(window_->document().selection().empty());
    QVERIFY(!findAction(*window_->menuBar(), QStringLiteral("Edit/Delete"))->isEnabled());
}

void TestMainWindow::undoAndRedoAll() {
    const Scene before = scene();
    for (const char* path :
         {"Add/Light/Point", "Add/Primitive/Torus", "Add/Material", "Edit/Duplicate", "Edit/Delete"})
        trigger(*window_, QString::fromLatin1(path));
    const Scene after = scene();
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(scene().objects == before.objects && scene().lights == before.lights &&
            scene().materials == before.materials);
    QVERIFY(!findAction(*window_->menuBar(), QStringLiteral("Edit/Undo"))->isEnabled());
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(scene().objects == after.objects && scene().lights == after.lights &&
            scene().materials == after.materials);
}

void TestMainWindow::titleTellsFileAndState() {
    QVERIFY(window_->windowTitle().startsWith(QStringLiteral("Untitled[*] – Prizma")));
    trigger(*window_, QStringLiteral("Add/Primitive/Cube"));
    QVERIFY(window_->isWindowModified());
    window_->fileActions().saveFile(isolation_->path(QStringLiteral("two words.prizma")));
    QVERIFY(window_->windowTitle().startsWith(QStringLiteral("two words.prizma[*] – Prizma")));
    QVERIFY(!window_->isWindowModified());
}

void TestMainWindow::importSelectsAndFrames() {
    const Camera camera = scene().camera;
    // A hundred times as large as the starter scene.
    const QString file =
        isolation_->write(QStringLiteral("a b.obj"), "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 3\n");
    const auto count = scene().objects.size();
    window_->importFile(file);
    QTRY_COMPARE(scene().objects.size(), count + 1);
    const Object& object = scene().objects.back();
    QCOMPARE(toQString(object.source.file), file);
    QVERIFY((window_->document().selection() == std::vector{EntityRef{EntityKind::Object, object.id}}));
    QTRY_VERIFY(scene().camera != camera);
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QCOMPARE(scene().objects.size(), count);
}

void TestMainWindow::brokenImportChangesNothing_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("this is no model");
    QTest::newRow("bytes") << QByteArray::fromHex("00ff00fe8081828384000000");
    QTest::newRow("indices") << QByteArray("v 0 0 0\nf 1 2 3\n");
    QTest::newRow("points only") << QByteArray("v 0 0 0\nv 1 0 0\n");
}

void TestMainWindow::brokenImportChangesNothing() {
    QFETCH(QByteArray, content);
    const QString file = isolation_->write(QStringLiteral("broken.obj"), content);
    const Scene before = scene();
    QDockWidget* log = panel(*window_, "logPanel");
    QVERIFY(!log->isVisible());
    window_->importFile(file);
    QTRY_COMPARE(window_->log().count(), 1);
    QVERIFY(toQString(window_->log().at(0).file).contains(QStringLiteral("broken.obj")));
    QVERIFY(window_->log().at(0).severity == Severity::Error);
    QVERIFY(!window_->log().at(0).message.empty());
    QVERIFY(log->isVisible());
    QVERIFY(window_->statusBar()->currentMessage().contains(QStringLiteral("broken.obj")));
    QVERIFY(scene() == before);
    QVERIFY(!window_->document().undoStack().canUndo());
}

void TestMainWindow::brokenProjectChangesNothing() {
    const QString file = isolation_->write(QStringLiteral("broken.prizma"), "{\"prizma\": 1, \"objects\": [");
    const Scene before = scene();
    window_->openFile(file);
    QTRY_COMPARE(window_->log().count(), 1);
    QVERIFY(toQString(window_->log().at(0).file).contains(QStringLiteral("broken.prizma")));
    QVERIFY(scene() == before);
    QVERIFY(window_->document().file().isEmpty());
}

void TestMainWindow::missingTextureIsAWarning() {
    isolation_->write(QStringLiteral("skin.mtl"), "newmtl skin\nKd 1 1 1\nmap_Kd no such picture.png\n");
    const QString file =
        isolation_->write(QStringLiteral("skin.obj"),
                          "mtllib skin.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl skin\nf 1/1 2/1 3/1\n");
    const auto count = scene().objects.size();
    window_->importFile(file);
    QTRY_COMPARE(scene().objects.size(), count + 1);
    QVERIFY(window_->log().count() >= 1);
    bool warned = false;
    for (int row = 0; row < window_->log().count(); ++row) {
        const Diagnostic message = window_->log().at(row);
        QVERIFY(message.severity != Severity::Error);
        warned = warned || describe(message).find("no such picture.png") != std::string::npos;
    }
    QVERIFY(warned);
    QVERIFY(!panel(*window_, "logPanel")->isVisible());
}

void TestMainWindow::importCanBeCancelled() {
    QByteArray large;
    for (int i = 0; i < 200000; ++i)
        large += "v " + QByteArray::number(i % 997) + ' ' + QByteArray::number(i % 991) + " 0\n";
    for (int i = 1; i + 2 < 200000; ++i)
        large += "f " + QByteArray::number(i) + ' ' + QByteArray::number(i + 1) + ' ' +
                 QByteArray::number(i + 2) + '\n';
    const QString file = isolation_->write(QStringLiteral("large.obj"), large);
    const Scene before = scene();
    window_->importFile(file);
    auto* cancel = window_->findChild<QWidget*>(QStringLiteral("cancelImport"));
    QVERIFY(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(!cancel->isVisible());
    QTest::qWait(300);
    QVERIFY(scene() == before);
}

void TestMainWindow::saveAndOpenAgain() {
    trigger(*window_, QStringLiteral("Add/Primitive/Sphere"));
    trigger(*window_, QStringLiteral("Add/Light/Rectangle"));
    const Scene before = scene();
    const QString file = isolation_->path(QStringLiteral("again.prizma"));
    window_->fileActions().saveFile(file);
    trigger(*window_, QStringLiteral("File/New"));
    QVERIFY(window_->document().file().isEmpty());
    window_->openFile(file);
    QTRY_COMPARE(window_->document().file(), file);
    QCOMPARE(scene().objects.size(), before.objects.size());
    QCOMPARE(scene().lights.size(), before.lights.size());
    QCOMPARE(scene().objects.back().name, before.objects.back().name);
    QVERIFY(!window_->isWindowModified());
    QVERIFY(!window_->document().undoStack().canUndo());
}

void TestMainWindow::sampleHasNoFile() {
    trigger(*window_, QStringLiteral("Add/Primitive/Sphere"));
    const QString file = isolation_->path(QStringLiteral("sample.prizma"));
    window_->fileActions().saveFile(file);
    trigger(*window_, QStringLiteral("File/New"));
    const auto count = scene().objects.size();
    window_->openSample(file);
    QTRY_COMPARE(scene().objects.size(), count + 1);
    QVERIFY(window_->document().file().isEmpty());
    QVERIFY(!window_->isWindowModified());
}

void TestMainWindow::closeAsksFirst() {
    trigger(*window_, QStringLiteral("Add/Primitive/Sphere"));
    window_->close();
    QVERIFY(window_->isVisible());
    QVERIFY(question(*window_));
    question(*window_)->button(QMessageBox::Discard)->click();
    QTRY_VERIFY(!window_->isVisible());
}

void TestMainWindow::cancelKeepsTheWork() {
    trigger(*window_, QStringLiteral("Add/Primitive/Sphere"));
    const Scene before = scene();
    window_->openFile(isolation_->write(QStringLiteral("other.prizma"), "{\"prizma\": 1}"));
    QVERIFY(question(*window_));
    question(*window_)->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!question(*window_));
    QVERIFY(scene() == before);
    QVERIFY(window_->isWindowModified());
}

void TestMainWindow::newAsksFirst() {
    window_->fileActions().saveFile(isolation_->path(QStringLiteral("kept.prizma")));
    trigger(*window_, QStringLiteral("Add/Primitive/Sphere"));
    const auto count = scene().objects.size();
    trigger(*window_, QStringLiteral("File/New"));
    QVERIFY(question(*window_));
    question(*window_)->button(QMessageBox::Save)->click();
    QTRY_VERIFY(window_->document().file().isEmpty());
    window_->openFile(isolation_->path(QStringLiteral("kept.prizma")));
    QTRY_COMPARE(scene().objects.size(), count); // it was saved before it went
}

void TestMainWindow::dropImports() {
    const QString file = isolation_->write(QStringLiteral("dropped.obj"), triangle);
    rememberImportOptions(file, {UpAxis::Z, 2.0});
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    const auto count = scene().objects.size();
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_COMPARE(scene().objects.size(), count + 1);
    QVERIFY(scene().objects.back().source.upAxis == UpAxis::Z);
    QCOMPARE(scene().objects.back().source.unitScale, 2.0);
}

void TestMainWindow::recentFilesAreKept() {
    const QString file = isolation_->path(QStringLiteral("recent.prizma"));
    window_->fileActions().saveFile(file);
    trigger(*window_, QStringLiteral("File/New"));
    QMenu* recent = findAction(*window_->menuBar(), QStringLiteral("File/Open Recent"))->menu();
    Q_EMIT recent->aboutToShow();
    QVERIFY(recent->actions().first()->text().contains(QStringLiteral("recent.prizma")));
    recent->actions().first()->trigger();
    QTRY_COMPARE(window_->document().file(), file);
}

void TestMainWindow::layoutIsReset() {
    QDockWidget* tree = panel(*window_, "scenePanel");
    QDockWidget* properties = panel(*window_, "propertyPanel");
    tree->hide();
    properties->setFloating(true);
    panel(*window_, "logPanel")->show();
    trigger(*window_, QStringLiteral("View/Reset Layout"));
    QVERIFY(tree->isVisible());
    QVERIFY(!properties->isFloating());
    QVERIFY(!panel(*window_, "logPanel")->isVisible());
    QCOMPARE(window_->dockWidgetArea(tree), Qt::LeftDockWidgetArea);
    QCOMPARE(window_->dockWidgetArea(properties), Qt::RightDockWidgetArea);
}

void TestMainWindow::layoutIsRemembered() {
    panel(*window_, "scenePanel")->hide();
    window_->addDockWidget(Qt::LeftDockWidgetArea, panel(*window_, "propertyPanel"));
    window_->close();
    window_ = showWindow();
    QVERIFY(!panel(*window_, "scenePanel")->isVisible());
    QCOMPARE(window_->dockWidgetArea(panel(*window_, "propertyPanel")), Qt::LeftDockWidgetArea);
}

void TestMainWindow::shadersCanBeChosen() {
    trigger(*window_, QStringLiteral("Render/Shader/Normals"));
    QVERIFY(scene().render.shader == ShaderType::Normals);
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QVERIFY(scene().render.shader == ShaderType::Whitted);
    QVERIFY(findAction(*window_->menuBar(), QStringLiteral("Render/Shader/Whitted"))->isChecked());
}

void TestMainWindow::everyShaderHasItsKey() {
    const auto shaders = choicesOf<ShaderType>();
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        const auto key = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i));
        QTest::keyClick(window_.get(), key, Qt::ControlModifier);
        QCOMPARE(static_cast<std::size_t>(scene().render.shader), i);
        const QString path = QStringLiteral("Render/Shader/") + translated(shaders[i].label);
        QVERIFY2(findAction(*window_->menuBar(), path)->isChecked(), qPrintable(path));
    }
}

void TestMainWindow::displayIsChosenInTheMenu() {
    const auto action = [&](const char* path) {
        return findAction(*window_->menuBar(), QString::fromLatin1(path));
    };
    QVERIFY(action("View/Colours/Standard (sRGB)")->isChecked());
    trigger(*window_, QStringLiteral("View/Colours/Filmic"));
    QVERIFY(scene().render.viewTransform == ViewTransform::Filmic);
    QVERIFY(!action("View/Colours/Standard (sRGB)")->isChecked());
    trigger(*window_, QStringLiteral("View/Denoise Preview"));
    QVERIFY(scene().render.denoise);
    QVERIFY(window_->isWindowModified());
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QVERIFY(!scene().render.denoise && !action("View/Denoise Preview")->isChecked());
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QVERIFY(scene().render.viewTransform == ViewTransform::Standard);
    QVERIFY(action("View/Colours/Standard (sRGB)")->isChecked());
    QVERIFY(!window_->isWindowModified());
}

namespace {

void collect(const QList<QAction*>& actions, QList<QAction*>& all) {
    for (QAction* action : actions) {
        if (action->menu())
            collect(action->menu()->actions(), all);
        else if (!action->isSeparator())
            all += action;
    }
}

} // namespace

void TestMainWindow::shortcutsAreUnique() {
    QList<QAction*> all;
    collect(window_->menuBar()->actions(), all);
    QVERIFY(all.size() > 40);
    QMap<QString, QString> taken;
    for (const QAction* action : all)
        for (const QKeySequence& key : action->shortcuts()) {
            QVERIFY2(!taken.contains(key.toString()),
                     qPrintable(action->text() + QStringLiteral(" / ") + taken.value(key.toString())));
            taken.insert(key.toString(), action->text());
        }
}

void TestMainWindow::cheatSheetListsAll() {
    trigger(*window_, QStringLiteral("Help/Keyboard Shortcuts"));
    auto* list = window_->findChild<QTreeWidget*>(QStringLiteral("shortcutList"));
    QVERIFY(list);
    QList<QAction*> all;
    collect(window_->menuBar()->actions(), all);
    for (const QAction* action : all) {
        QString text = action->text();
        text.remove(QLatin1Char('&'));
        QVERIFY2(!list->findItems(text, Qt::MatchEndsWith | Qt::MatchRecursive).isEmpty(), qPrintable(text));
    }
}

void TestMainWindow::doubleClickOnAMessageSelects() {
    const QString file = isolation_->write(QStringLiteral("cause.obj"), triangle);
    window_->importFile(file);
    QTRY_VERIFY(!window_->document().selection().empty());
    const auto cause = window_->document().selection();
    window_->document().setSelection({});
    window_->log().add({Severity::Error, "something is odd", toStdString(file), 3});
    auto* list = window_->findChild<QTreeWidget*>(QStringLiteral("logList"));
    QTRY_VERIFY(list->isVisible());
    const QPoint place = list->visualItemRect(list->topLevelItem(window_->log().count() - 1)).center();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, place);
    QVERIFY(window_->document().selection() == cause);
}

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"
