// File > Export Animation in the real window: pictures, videos, cancelling, going on.
#include "tests/ui/ui_test_support.h"

#include "core/compute/device.h"
#include "ui/export/animation_export_dialog.h"
#include "ui/export/animation_exporter.h"
#include "ui/export/export_actions.h"
#include "ui/export/export_progress_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

using namespace prizma;
using namespace prizma::test;

class TestAnimationExport : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() {
        isolation_ = std::make_unique<Isolation>();
        if (chooseDevice(listDevices(), {}) < 0)
            QSKIP("There is no OpenCL device here.");
    }
    void init();
    void cleanup() { window_.reset(); }

    void dialogChecks();
    void picturesMoveWithTheClip();
    void finishedFramesStay();
    void cancelledExportsGoOn();
    void closingEndsTheExport();
    void videos();

  private:
    const Scene& scene() const { return window_->document().scene(); }
    AnimationExporter& exporter() const { return window_->exportActions().exporter(); }
    QString file(const QString& name) const { return folder_->filePath(name); }
    QString frameName(int frame) const {
        return file(QStringLiteral("strip_%1.png").arg(frame, 4, 10, QLatin1Char('0')));
    }

    /// The dialog, filled in for frames 0 to `last` of 96 x 72 pixels with one sample.
    AnimationExportDialog* openDialog(int last);
    void accept(AnimationExportDialog& dialog);

    std::unique_ptr<Isolation> isolation_;
    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<MainWindow> window_;
};

void TestAnimationExport::init() {
    QSettings().clear();
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = showWindow();
    window_->importFile(QStringLiteral(PRIZMA_TEST_DATA "/bend.gltf"));
    QTRY_COMPARE(scene().objects.size(), 2U);
    window_->document().edit(QStringLiteral("Prepare"), [](Scene& s) {
        s.objects.edit()[1].clip = "bend";
        s.render.samples = 1;
    });
}

AnimationExportDialog* TestAnimationExport::openDialog(int last) {
    findAction(*window_->menuBar(), QStringLiteral("File/Export Animation"))->trigger();
    auto* dialog = window_->findChild<AnimationExportDialog*>();
    if (!dialog || !QTest::qWaitForWindowExposed(dialog))
        return nullptr;
    for (const auto& [name, text] :
         {std::pair("firstFrame", QStringLiteral("0")), std::pair("lastFrame", QString::number(last)),
          std::pair("width", QStringLiteral("96")), std::pair("height", QStringLiteral("72")),
          std::pair("samples", QStringLiteral("1"))})
        typeInto(*dialog->findChild<NumberField*>(QString::fromLatin1(name)), text);
    dialog->setOutput(file(QStringLiteral("strip_####.png")));
    return dialog;
}

void TestAnimationExport::accept(AnimationExportDialog& dialog) {
    auto* button = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(!window_->findChild<AnimationExportDialog*>());
}

void TestAnimationExport::dialogChecks() {
    AnimationExportDialog* dialog = openDialog(4);
    QVERIFY(dialog);
    auto* button = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    auto* note = dialog->findChild<QLabel*>(QStringLiteral("exportNote"));
    QVERIFY(button->isEnabled());
    QVERIFY2(note->text().contains(QLatin1Char('5')), qPrintable(note->text()));
    dialog->setOutput(file(QStringLiteral("strip.png"))); // no place for the number
    QVERIFY(!button->isEnabled());
    QVERIFY(note->text().contains(QStringLiteral("####")));
    dialog->setOutput(file(QStringLiteral("no such folder/strip_####.png")));
    QVERIFY(!button->isEnabled());
    dialog->setOutput(file(QStringLiteral("strip_####.png")));
    QVERIFY(button->isEnabled());
    // Another format is another kind of name.
    auto* format = dialog->findChild<QComboBox*>(QStringLiteral("format"));
    format->setCurrentIndex(static_cast<int>(AnimationFormat::Exr));
    QCOMPARE(dialog->animation().output, file(QStringLiteral("strip_####.exr")).toStdString());
    format->setCurrentIndex(static_cast<int>(AnimationFormat::Mp4));
    QCOMPARE(dialog->animation().output, file(QStringLiteral("strip.mp4")).toStdString());
    QCOMPARE(button->isEnabled(), isVideoEncoderInstalled());
    format->setCurrentIndex(static_cast<int>(AnimationFormat::Png));
    QCOMPARE(dialog->animation().output, file(QStringLiteral("strip_####.png")).toStdString());
    typeInto(*dialog->findChild<NumberField*>(QStringLiteral("lastFrame")), QStringLiteral("-3"));
    QVERIFY(!button->isEnabled());
}

void TestAnimationExport::picturesMoveWithTheClip() {
    const double before = scene().timeline.frame;
    const int steps = window_->document().undoStack().count();
    AnimationExportDialog* dialog = openDialog(3);
    QVERIFY(dialog);
    QSignalSpy finished(&exporter(), &AnimationExporter::finished);
    accept(*dialog);
    QVERIFY(exporter().isBusy());
    QVERIFY(window_->findChild<ExportProgressDialog*>());
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QTRY_VERIFY(!window_->findChild<ExportProgressDialog*>());
    for (int frame = 0; frame <= 3; ++frame) {
        const QImage picture(frameName(frame));
        QCOMPARE(picture.size(), QSize(96, 72));
        QVERIFY(frame == 0 || picture != QImage(frameName(frame - 1)));
    }
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files).size(), 4);
    QCOMPARE(scene().timeline.frame, before);
    QCOMPARE(window_->document().undoStack().count(), steps);
}

void TestAnimationExport::finishedFramesStay() {
    const auto exportFour = [this](bool overwrite) {
        AnimationExportDialog* dialog = openDialog(3);
        QVERIFY(dialog);
        if (overwrite)
            for (QCheckBox* box : dialog->findChildren<QCheckBox*>())
                if (box->text().contains(QStringLiteral("there already")))
                    box->setChecked(true);
        QSignalSpy finished(&exporter(), &AnimationExporter::finished);
        accept(*dialog);
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    };
    exportFour(false);
    // Marks that are no pictures show which frames are rendered again.
    isolation_->write(QStringLiteral("ignored"), "x");
    const QByteArray mark = "finished by somebody else";
    for (const int frame : {0, 2}) {
        QFile marked(frameName(frame));
        QVERIFY(marked.open(QIODevice::WriteOnly) && marked.write(mark) == mark.size());
    }
    QVERIFY(QFile::remove(frameName(3)));
    const auto isMarked = [&](int frame) {
        QFile picture(frameName(frame));
        return picture.open(QIODevice::ReadOnly) && picture.readAll() == mark;
    };
    exportFour(false);
    QVERIFY(isMarked(0) && isMarked(2));
    QVERIFY(!QImage(frameName(3)).isNull());
    exportFour(true);
    QVERIFY(!isMarked(0) && !isMarked(2));
    QVERIFY(!QImage(frameName(0)).isNull());
}

void TestAnimationExport::cancelledExportsGoOn() {
    constexpr int last = 79;
    const auto finishedFiles = [this] {
        return QDir(folder_->path()).entryList({QStringLiteral("strip_*.png")}, QDir::Files).size();
    };
    AnimationExportDialog* dialog = openDialog(last);
    QVERIFY(dialog);
    typeInto(*dialog->findChild<NumberField*>(QStringLiteral("samples")), QStringLiteral("16"));
    accept(*dialog);
    QTRY_VERIFY_WITH_TIMEOUT(finishedFiles() >= 2, 60000);
    auto* progress = window_->findChild<ExportProgressDialog*>();
    QVERIFY(progress);
    QTest::mouseClick(progress->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                      Qt::LeftButton);
    QTRY_VERIFY(!exporter().isBusy());
    QTest::qWait(300); // the frame that was being rendered
    const auto done = finishedFiles();
    QVERIFY2(done <= last, qPrintable(QString::number(done)));
    for (const QString& name : QDir(folder_->path()).entryList(QDir::Files))
        QVERIFY2(!QImage(file(name)).isNull(), qPrintable(name)); // no halves
    dialog = openDialog(last);
    QVERIFY(dialog);
    QVERIFY(dialog->findChild<QLabel*>(QStringLiteral("exportNote"))->text().contains(QString::number(done)));
    QSignalSpy finished(&exporter(), &AnimationExporter::finished);
    accept(*dialog);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 120000);
    QCOMPARE(finishedFiles(), last + 1);
}

void TestAnimationExport::closingEndsTheExport() {
    AnimationExportDialog* dialog = openDialog(100);
    QVERIFY(dialog);
    typeInto(*dialog->findChild<NumberField*>(QStringLiteral("samples")), QStringLiteral("100000"));
    accept(*dialog);
    QVERIFY(exporter().isBusy());
    QTest::qWait(200);
    QElapsedTimer clock;
    clock.start();
    window_.reset();
    QVERIFY2(clock.elapsed() < 3000, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(QDir(folder_->path()).entryList(QDir::Files).isEmpty()); // nothing half done
}

void TestAnimationExport::videos() {
    if (!isVideoEncoderInstalled())
        QSKIP("ffmpeg is not installed.");
    AnimationExportDialog* dialog = openDialog(5);
    QVERIFY(dialog);
    dialog->findChild<QComboBox*>(QStringLiteral("format"))
        ->setCurrentIndex(static_cast<int>(AnimationFormat::Mp4));
    QSignalSpy finished(&exporter(), &AnimationExporter::finished);
    accept(*dialog);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QFile video(file(QStringLiteral("strip.mp4")));
    QVERIFY(video.open(QIODevice::ReadOnly));
    QVERIFY(video.read(12).contains("ftyp"));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 1);
}

QTEST_MAIN(TestAnimationExport)
#include "tst_animation_export.moc"
