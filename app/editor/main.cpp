#include "core/compute/worker_affinity.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/theme.h"
#include "ui/preferences/preferences_dialog.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

namespace {

/// The first of the places where the resources may be: beside an installed program, else in the source tree.
QString findResource(const QString& name) {
    for (const QString& folder : {QCoreApplication::applicationDirPath() + QStringLiteral("/../share/prizma"),
                                  QStringLiteral(PRIZMA_RESOURCE_DIR)})
        if (const QString file = folder + QLatin1Char('/') + name; QFileInfo::exists(file))
            return file;
    return {};
}

/// Texts of our own and of Qt's dialogs in the user's language.
void installTranslators(QApplication& application, QTranslator& own, QTranslator& qt) {
    const QString chosen = prizma::preferences::language();
    const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
    if (own.load(locale, QStringLiteral("prizma"), QStringLiteral("_"), QStringLiteral(":/i18n")))
        QApplication::installTranslator(&own);
    if (qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        application.installTranslator(&qt);
}

} // namespace

int main(int argc, char** argv) {
    prizma::keepDeviceWorkersApart();
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Prizma"));
    QApplication::setApplicationName(QStringLiteral("prizma"));
    QApplication::setApplicationDisplayName({});
    QApplication::setApplicationVersion(QStringLiteral(PRIZMA_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("prizma"));
    QTranslator own;
    QTranslator qt;
    installTranslators(application, own, qt);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "Edits 3D scenes in a view that is ray traced live."));
    parser.addHelpOption();
    parser.addVersionOption();
    const QCommandLineOption device(
        QStringLiteral("device"),
        QCoreApplication::translate("main", "Renders on this OpenCL device (see prizma-render devices)."),
        QCoreApplication::translate("main", "ID"));
    parser.addOption(device);
    parser.addPositionalArgument(
        QCoreApplication::translate("main", "FILE"),
        QCoreApplication::translate("main", "Projects to open and models to import."),
        QStringLiteral("[FILE...]"));
    parser.process(application);

    prizma::applyTheme(application);
    const QString remembered = QSettings().value(QStringLiteral("device")).toString();
    prizma::MainWindow window(parser.isSet(device) ? parser.value(device) : remembered);
    window.show();
    const QString demo = findResource(QStringLiteral("demo/demo.prizma"));
    if (!parser.positionalArguments().isEmpty())
        window.takeFiles(parser.positionalArguments());
    else if (!demo.isEmpty() && prizma::preferences::opensDemo())
        window.openSample(demo);
    return QApplication::exec();
}
