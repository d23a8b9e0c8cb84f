#include "ui/main_window/file_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace prizma {
namespace {

/// The folder that a file dialog opened last time, one for each purpose.
QString lastFolder(const QString& purpose) {
    const QString home = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    return QSettings().value(QStringLiteral("folders/") + purpose, home).toString();
}

} // namespace

void showFileDialog(QFileDialog* dialog, const QString& purpose,
                    std::function<void(const QStringList&)> use) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (dialog->directory() == QDir::current())
        dialog->setDirectory(lastFolder(purpose));
    QObject::connect(dialog, &QFileDialog::filesSelected, dialog,
                     [purpose, use = std::move(use)](const QStringList& files) {
                         QSettings().setValue(QStringLiteral("folders/") + purpose,
                                              QFileInfo(files.value(0)).absolutePath());
                         use(files);
                     });
    dialog->open();
}

} // namespace prizma
