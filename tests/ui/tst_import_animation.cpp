// SMD and QC models and their animations through the real window: menus, dialogs, drops, undo, cancel.
#include "tests/ui/ui_test_support.h"

#include "ui/import/import_settings.h"
#include "ui/log/log_panel.h"
#include "ui/main_window/file_actions.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QStatusBar>

using namespace prizma;
using namespace prizma::test;

namespace {

QString data(const QString& name) {
    return QStringLiteral(PRIZMA_TEST_DATA "/smd/") + name;
}

template <class Dialog>
Dialog* shownDialog(QWidget& window) {
    for (Dialog* dialog : window.findChildren<Dialog*>())
        if (dialog->isVisible())
            return dialog;
    return nullptr;
}

void drop(QWidget& window, const QStringList& files) {
    QMimeData mime;
    QList<QUrl> urls;
    for (const QString& file : files)
        urls += QUrl::fromLocalFile(file);
    mime.setUrls(urls);
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &mime, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QDropEvent event({100, 100}, Qt::CopyAction, &mime, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &event);
}

} // namespace

class TestImportAnimation : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() { isolation_ = std::make_unique<Isolation>(); }
    void init() {
        QSettings().clear();
        window_ = showWindow();
        objects_ = scene().objects.size();
    }
    void cleanup() { window_.reset(); }

    void scriptBringsAllItsSequences();
    void dialogKnowsWhatIsUp();
    void animationThroughTheMenu();
    void animationNeedsAnObject();
    void referenceAndAnimationsDropTogether();
    void animationDropsOnTheSelectedObject();
    void damagedAnimationIsToldAndLeftOut();
    void animationCanBeCancelled();
    void projectBringsClipsBack();

  private:
    const Scene& scene() const { return window_->document().scene(); }
    const Object& last() const { return scene().objects.back(); }

    bool importArm() {
        window_->importFile(data("arm.smd"));
        return QTest::qWaitFor([this] { return scene().objects.size() == objects_ + 1; });
    }

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<MainWindow> window_;
    std::size_t objects_ = 0;
};

void TestImportAnimation::scriptBringsAllItsSequences() {
    window_->importFile(data("arm.qc"));
    QTRY_COMPARE(scene().objects.size(), objects_ + 1);
    QCOMPARE(last().clips.size(), 3u);
    QVERIFY(last().source.upAxis == UpAxis::Z);
    QVERIFY(last().dynamic);
    bool told = false; // what the script names in vain is in the log
    for (int row = 0; row < window_->log().count(); ++row)
        told = told || window_->log().at(row).message.find("\"lost\"") != std::string::npos;
    QVERIFY(told);
}

void TestImportAnimation::dialogKnowsWhatIsUp() {
    trigger(*window_, QStringLiteral("File/Import Model"));
    auto* files = shownDialog<QFileDialog>(*window_);
    QVERIFY(files);
    QVERIFY(files->nameFilters().first().contains(QStringLiteral("*.smd")));
    QVERIFY(files->nameFilters().first().contains(QStringLiteral("*.qc")));
    Q_EMIT files->filesSelected({data("arm.smd"), data("wave.smd")});
    files->close();
    QDialog* options = nullptr;
    QTRY_VERIFY((options = shownDialog<QDialog>(*window_)) && options->findChild<QComboBox*>());
    QCOMPARE(options->findChild<QComboBox*>()->currentIndex(), 1); // Z
    options->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    QTRY_COMPARE(scene().objects.size(), objects_ + 1);
    QVERIFY(last().source.upAxis == UpAxis::Z);
    QCOMPARE(last().clips.size(), 1u); // the animation came with its model
}

void TestImportAnimation::animationThroughTheMenu() {
    QVERIFY(importArm());
    const Scene before = scene();
    trigger(*window_, QStringLiteral("File/Import Animation"));
    auto* files = shownDialog<QFileDialog>(*window_);
    QVERIFY(files);
    QVERIFY(files->fileMode() == QFileDialog::ExistingFiles);
    Q_EMIT files->filesSelected({data("wave.smd"), data("arm.qc")});
    files->close();
    QTRY_COMPARE(last().clips.size(), 4u);
    QCOMPARE(last().clips[0]->name, std::string("wave"));
    QCOMPARE(last().clips[1]->name, std::string("wave 2"));
    QCOMPARE(last().clips[1]->fps, 12.0);
    QCOMPARE(last().clip, std::string("wave"));
    QCOMPARE(last().clipFiles,
             (std::vector<std::string>{toStdString(data("wave.smd")), toStdString(data("arm.qc"))}));
    QTRY_VERIFY(window_->statusBar()->currentMessage().contains(QStringLiteral("4 new clips")));
    trigger(*window_, QStringLiteral("Edit/Undo")); // all of it is one step
    QVERIFY(scene().objects == before.objects);
    trigger(*window_, QStringLiteral("Edit/Redo"));
    QCOMPARE(last().clips.size(), 4u);
}

void TestImportAnimation::animationNeedsAnObject() {
    const Scene before = scene();
    trigger(*window_, QStringLiteral("File/Import Animation"));
    auto* box = shownDialog<QMessageBox>(*window_);
    QVERIFY(box);
    QVERIFY(box->text().contains(QStringLiteral("bones")));
    box->close();
    // As a model an animation is told of, too.
    drop(*window_, {data("wave.smd")});
    QTRY_VERIFY(shownDialog<QMessageBox>(*window_));
    QVERIFY(shownDialog<QMessageBox>(*window_)->text().contains(QStringLiteral("wave.smd")));
    window_->importFile(data("wave.smd"));
    QTRY_COMPARE(window_->log().count(), 1);
    QVERIFY(window_->log().at(0).message.find("Import Animation") != std::string::npos);
    QVERIFY(scene() == before);
}

void TestImportAnimation::referenceAndAnimationsDropTogether() {
    const QString second = isolation_->path(QStringLiteral("second.smd"));
    QFile::remove(second);
    QVERIFY(QFile::copy(data("wave.smd"), second));
    rememberImportOptions(data("arm.smd"), {UpAxis::Z, 2.0});
    const Scene before = scene();
    drop(*window_, {data("wave.smd"), data("arm.smd"), second, data("arm.vta")});
    QTRY_COMPARE(scene().objects.size(), objects_ + 1);
    QCOMPARE(last().clips.size(), 2u);
    QCOMPARE(last().clips[0]->name, std::string("wave"));
    QCOMPARE(last().clips[1]->name, std::string("second"));
    QCOMPARE(last().source.unitScale, 2.0);
    QCOMPARE(last().mesh->morphTargets.size(), 2u);
    for (int row = 0; row < window_->log().count(); ++row)
        QVERIFY(window_->log().at(row).severity != Severity::Error);
    trigger(*window_, QStringLiteral("Edit/Undo"));
    QVERIFY(scene().objects == before.objects);
    QVERIFY(scene().materials == before.materials);
}

void TestImportAnimation::animationDropsOnTheSelectedObject() {
    QVERIFY(importArm());
    const Id first = last().id;
    trigger(*window_, QStringLiteral("Edit/Duplicate"));
    QCOMPARE(scene().objects.size(), objects_ + 2);
    window_->document().setSelection({{EntityKind::Object, first}});
    drop(*window_, {data("wave.smd")});
    QTRY_COMPARE(scene().findObject(first)->clips.size(), 1u);
    QVERIFY(last().clips.empty());
}

void TestImportAnimation::damagedAnimationIsToldAndLeftOut() {
    QVERIFY(importArm());
    const int told = window_->log().count();
    const QString bad = isolation_->write(QStringLiteral("bad.smd"), "version 1\nnodes\n0 \"base\" -1\n");
    const Scene before = scene();
    window_->fileActions().importAnimationFiles({bad});
    QTRY_COMPARE(window_->log().count(), told + 1);
    const Diagnostic message = window_->log().at(told);
    QVERIFY(message.severity == Severity::Error);
    QCOMPARE(message.line, 2);
    QVERIFY(toQString(message.file).endsWith(QStringLiteral("bad.smd")));
    QVERIFY(scene() == before);
    // The good ones of several come in all the same.
    window_->fileActions().importAnimationFiles({bad, data("wave.smd")});
    QTRY_COMPARE(last().clips.size(), 1u);
}

void TestImportAnimation::animationCanBeCancelled() {
    QVERIFY(importArm());
    QByteArray large = "version 1\nnodes\n0 \"base\" -1\nend\nskeleton\n";
    for (int i = 0; i < 300'000; ++i)
        large += "time " + QByteArray::number(i) + "\n0 0 0 0 0 0 0\n";
    const QString file = isolation_->write(QStringLiteral("large.smd"), large + "end\n");
    const Scene before = scene();
    window_->fileActions().importAnimationFiles({file});
    auto* cancel = window_->findChild<QWidget*>(QStringLiteral("cancelImport"));
    QVERIFY(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    QVERIFY(!cancel->isVisible());
    QTest::qWait(300);
    QVERIFY(scene() == before);
}

void TestImportAnimation::projectBringsClipsBack() {
    QVERIFY(importArm());
    window_->fileActions().importAnimationFiles({data("wave.smd")});
    QTRY_COMPARE(last().clips.size(), 1u);
    const QString file = isolation_->path(QStringLiteral("animated.prizma"));
    window_->fileActions().saveFile(file);
    trigger(*window_, QStringLiteral("File/New"));
    QTRY_VERIFY(last().clips.empty());
    window_->openFile(file);
    QTRY_COMPARE(window_->document().file(), file);
    QCOMPARE(last().clips.size(), 1u);
    QCOMPARE(last().clips[0]->frameCount, 3);
    QCOMPARE(last().clip, std::string("wave"));
    QVERIFY(last().source.upAxis == UpAxis::Z);
}

QTEST_MAIN(TestImportAnimation)
#include "tst_import_animation.moc"
