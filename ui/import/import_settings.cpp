#include "ui/import/import_settings.h"

#include "ui/document/strings.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QSettings>

namespace prizma {
namespace {

const QString group = QStringLiteral("importOptions");

/// A key of QSettings may not hold slashes, hence the hash of the folder.
QString keyOf(const QString& file) {
    const QFileInfo info(file);
    const QByteArray folder =
        QCryptographicHash::hash(info.absolutePath().toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
    return group + QLatin1Char('/') + QString::fromLatin1(folder) + QLatin1Char('-') +
           info.suffix().toLower();
}

} // namespace

std::optional<ImportOptions> rememberedImportOptions(const QString& file) {
    const QStringList stored = QSettings().value(keyOf(file)).toStringList();
    if (stored.size() != 2)
        return std::nullopt;
    bool isNumber = false;
    const double scale = stored[1].toDouble(&isNumber);
    if (!isNumber || !(scale > 0.0))
        return std::nullopt;
    return ImportOptions{stored[0] == QLatin1String("z") ? UpAxis::Z : UpAxis::Y, scale};
}

void rememberImportOptions(const QString& file, const ImportOptions& options) {
    const QString axis = options.upAxis == UpAxis::Z ? QStringLiteral("z") : QStringLiteral("y");
    QSettings().setValue(keyOf(file), QStringList{axis, QString::number(options.unitScale, 'g', 17)});
}

void forgetImportOptions() {
    QSettings().remove(group);
}

ImportOptions importOptionsFor(const QString& file) {
    if (const auto remembered = rememberedImportOptions(file))
        return *remembered;
    return {usualUpAxis(toStdString(file)), 1.0};
}

} // namespace prizma
