#include "tests/ui/ui_test_support.h"

#include "core/scene/edits.h"
#include "core/scene/starter_scene.h"
#include "ui/document/edits.h"
#include "ui/scene_tree/scene_model.h"
#include "ui/scene_tree/scene_tree.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <random>

using namespace prizma;
using namespace prizma::test;

class TestSceneTree : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() { isolation_ = std::make_unique<Isolation>(); }
    void init();
    void cleanup();
    void modelStaysConsistent();
    void editorRenames();
    void escapeLeavesTheName();
    void eyeHides();
    void bulbSwitchesOff();
    void selectionGoesBothWays();
    void selectionSurvivesEdits();
    void collapsedStaysCollapsed();
    void filterFinds();
    void groupsCannotBeSelected();

  private:
    QRect rectOf(EntityRef entity, int column = 0) const;
    void click(EntityRef entity, int column = 0, Qt::KeyboardModifiers modifiers = {}) const;
    EntityRef object(std::size_t index) const {
        return {EntityKind::Object, document_->scene().objects[index].id};
    }
    EntityRef light(std::size_t index) const {
        return {EntityKind::Light, document_->scene().lights[index].id};
    }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<SceneTree> tree_;
};

void TestSceneTree::init() {
    document_ = std::make_unique<Document>();
    Scene scene = makeStarterScene();
    for (const PrimitiveType type : {PrimitiveType::Cube, PrimitiveType::Sphere, PrimitiveType::Torus})
        addPrimitive(scene, type);
    document_->reset(scene, {});
    tree_ = std::make_unique<SceneTree>(*document_);
    tree_->resize(300, 600);
    tree_->show();
    QVERIFY(QTest::qWaitForWindowActive(tree_.get()));
}

void TestSceneTree::cleanup() {
    tree_.reset();
    document_.reset();
}

QRect TestSceneTree::rectOf(EntityRef entity, int column) const {
    return tree_->view().visualRect(tree_->indexOf(entity).siblingAtColumn(column));
}

void TestSceneTree::click(EntityRef entity, int column, Qt::KeyboardModifiers modifiers) const {
    QTest::mouseClick(tree_->view().viewport(), Qt::LeftButton, modifiers, rectOf(entity, column).center());
}

void TestSceneTree::modelStaysConsistent() {
    SceneModel model(*document_);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        switch (random() % 6) {
        case 0:
            addPrimitive(*document_, PrimitiveType::Cube);
            break;
        case 1:
            selectAll(*document_);
            duplicateSelected(*document_);
            document_->undoStack().undo();
            break;
        case 2:
            if (!document_->scene().objects.empty()) {
                document_->setSelection({object(random() % document_->scene().objects.size())});
                deleteSelected(*document_);
            }
            break;
        case 3:
            document_->edit(QStringLiteral("turn round"), [](Scene& scene) {
                auto& objects = scene.objects.edit();
                std::reverse(objects.begin(), objects.end());
            });
            break;
        case 4:
            document_->undoStack().undo();
            break;
        default:
            addLight(*document_, LightType::Spot);
            break;
        }
        const Scene& scene = document_->scene();
        QCOMPARE(model.rowCount(model.index(0, 0)), static_cast<int>(scene.objects.size()));
        for (int row = 0; row < static_cast<int>(scene.objects.size()); ++row) {
            const QModelIndex index = model.index(row, 0, model.index(0, 0));
            QVERIFY(*model.entityAt(index) == object(static_cast<std::size_t>(row)));
            QCOMPARE(index.data().toString(), toQString(scene.objects[static_cast<std::size_t>(row)].name));
        }
    }
}

void TestSceneTree::editorRenames() {
    const std::string before = document_->scene().objects[1].name;
    click(object(1));
    QTest::keyClick(&tree_->view(), Qt::Key_F2);
    auto* editor = tree_->view().findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, QStringLiteral("big box"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(toQString(document_->scene().objects[1].name), QStringLiteral("big box"));
    QCOMPARE(tree_->indexOf(object(1)).data().toString(), QStringLiteral("big box"));
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QCOMPARE(document_->scene().objects[1].name, before);
    QCOMPARE(tree_->indexOf(object(1)).data().toString(), toQString(before));
}

void TestSceneTree::escapeLeavesTheName() {
    click(object(1));
    QTest::keyClick(&tree_->view(), Qt::Key_F2);
    auto* editor = tree_->view().findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("never"));
    QTest::keyClick(editor, Qt::Key_Escape);
    QCOMPARE(document_->undoStack().count(), 0);
}

void TestSceneTree::eyeHides() {
    click(object(1), SceneModel::SwitchColumn);
    QVERIFY(!document_->scene().objects[1].visible);
    click(object(1), SceneModel::SwitchColumn);
    QVERIFY(document_->scene().objects[1].visible);
    QCOMPARE(document_->undoStack().count(), 2);
}

void TestSceneTree::bulbSwitchesOff() {
    click(light(0), SceneModel::SwitchColumn);
    QVERIFY(!document_->scene().lights[0].enabled);
    document_->undoStack().undo();
    QVERIFY(document_->scene().lights[0].enabled);
}

void TestSceneTree::selectionGoesBothWays() {
    click(object(1));
    QVERIFY(document_->selection() == std::vector{object(1)});
    click(object(2), 0, Qt::ControlModifier);
    QVERIFY((document_->selection() == std::vector{object(1), object(2)}));
    click(light(0));
    QVERIFY(document_->selection() == std::vector{light(0)});

    document_->setSelection({object(2), object(3)});
    const auto selected = tree_->view().selectionModel()->selectedRows();
    QCOMPARE(selected.size(), 2);
    QVERIFY(selected.contains(tree_->indexOf(object(2))));
    QVERIFY(selected.contains(tree_->indexOf(object(3))));
    QCOMPARE(tree_->view().currentIndex(), tree_->indexOf(object(3)));
}

void TestSceneTree::selectionSurvivesEdits() {
    document_->setSelection({object(1), object(3)});
    const auto wanted = document_->selection();
    document_->edit(QStringLiteral("remove one"), [this](Scene& scene) {
        const EntityRef gone = object(2);
        removeEntities(scene, std::span(&gone, 1));
    });
    QVERIFY(document_->selection() == wanted);
    QCOMPARE(tree_->view().selectionModel()->selectedRows().size(), 2);
    document_->undoStack().undo();
    QVERIFY(document_->selection() == wanted);
    QCOMPARE(tree_->view().selectionModel()->selectedRows().size(), 2);
    deleteSelected(*document_);
    QVERIFY(document_->selection().empty());
    QVERIFY(tree_->view().selectionModel()->selectedRows().isEmpty());
}

void TestSceneTree::collapsedStaysCollapsed() {
    const QModelIndex lights = tree_->indexOf(light(0)).parent();
    tree_->view().collapse(lights);
    addPrimitive(*document_, PrimitiveType::Cube);
    document_->undoStack().undo();
    QVERIFY(!tree_->view().isExpanded(tree_->indexOf(light(0)).parent()));
    QVERIFY(tree_->view().isExpanded(tree_->indexOf(object(0)).parent()));
}

void TestSceneTree::filterFinds() {
    document_->setSelection({object(1)});
    auto* filter = tree_->findChild<QLineEdit*>(QStringLiteral("treeFilter"));
    QTest::keyClicks(filter, toQString(document_->scene().objects[3].name).toUpper());
    QVERIFY(tree_->indexOf(object(3)).isValid());
    QVERIFY(!tree_->indexOf(object(1)).isValid());
    QVERIFY(document_->selection() == std::vector{object(1)}); // hidden, but still selected
    filter->clear();
    QVERIFY(tree_->indexOf(object(1)).isValid());
    QVERIFY(tree_->view().selectionModel()->isSelected(tree_->indexOf(object(1))));
}

void TestSceneTree::groupsCannotBeSelected() {
    document_->setSelection({object(1)});
    const QRect group = tree_->view().visualRect(tree_->indexOf(object(0)).parent());
    QTest::mouseClick(tree_->view().viewport(), Qt::LeftButton, {}, group.center());
    for (const EntityRef& entity : document_->selection())
        QVERIFY(entity.id != noId);
    QVERIFY(!tree_->view().selectionModel()->isSelected(tree_->indexOf(object(0)).parent()));
}

QTEST_MAIN(TestSceneTree)
#include "tst_scene_tree.moc"
