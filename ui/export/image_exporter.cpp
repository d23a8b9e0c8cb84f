#include "ui/export/image_exporter.h"

#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/import/background_job.h"
#include "ui/main_window/file_dialog.h"
#include "ui/viewport/render_session.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace prizma {
namespace {

const QString formatKey = QStringLiteral("picture/format");

/// In the order of PictureFormat.
QStringList filters() {
    return {ImageExporter::tr("PNG, 8 bits a channel (*.png)"),
            ImageExporter::tr("PNG, 16 bits a channel (*.png)"),
            ImageExporter::tr("OpenEXR, linear, 32 bits a channel (*.exr)")};
}

PictureFormat formatOf(const QFileDialog& dialog) {
    return static_cast<PictureFormat>(std::max<qsizetype>(filters().indexOf(dialog.selectedNameFilter()), 0));
}

} // namespace

ImageExporter::ImageExporter(Document& document, RenderSession& session, QWidget& window)
    : QObject(&window), document_(document), session_(session), window_(window) {}

void ImageExporter::ask() {
    auto* dialog = new QFileDialog(&window_, tr("Export the Picture"));
    dialog->setObjectName(QStringLiteral("exportImage"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(filters());
    const auto suggest = [dialog, name = QFileInfo(document_.title()).completeBaseName()] {
        const QString suffix = toQString(extensionOf(formatOf(*dialog)));
        dialog->setDefaultSuffix(suffix);
        dialog->selectFile(QStringLiteral("%1.%2").arg(name, suffix));
    };
    connect(dialog, &QFileDialog::filterSelected, this, suggest);
    dialog->selectNameFilter(filters().value(QSettings().value(formatKey, 0).toInt(), filters().first()));
    showFileDialog(dialog, QStringLiteral("picture"), [this, dialog](const QStringList& files) {
        const PictureFormat format = formatOf(*dialog);
        QSettings().setValue(formatKey, static_cast<int>(format));
        exportTo(files.value(0), format);
    });
    suggest();
}

void ImageExporter::exportTo(const QString& file, PictureFormat format) {
    session_.capture(format, [this, file, format](const Result<Picture>& picture) {
        if (picture)
            write(file, format, *picture);
        else
            Q_EMIT message({Severity::Error, picture.error().message, toStdString(file), 0});
    });
}

void ImageExporter::write(const QString& file, PictureFormat format, const Picture& picture) {
    new BackgroundJob(
        tr("Writing %1…").arg(QFileInfo(file).fileName()),
        [this, file, format, picture](Progress&) -> BackgroundJob::Delivery {
            const auto written = savePicture(picture, format, toStdString(file));
            return [this, file, written, samples = picture.samples] {
                const QString text = samples == 1
                                         ? tr("The picture was saved, with 1 sample a pixel.")
                                         : tr("The picture was saved, with %1 samples a pixel.").arg(samples);
                Q_EMIT message(
                    written ? Diagnostic{Severity::Information, toStdString(text), toStdString(file), 0}
                            : written.error());
            };
        },
        this);
}

} // namespace prizma
