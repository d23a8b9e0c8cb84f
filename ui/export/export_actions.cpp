#include "ui/export/export_actions.h"

#include "ui/document/document.h"
#include "ui/export/animation_export_dialog.h"
#include "ui/export/animation_exporter.h"
#include "ui/export/export_progress_dialog.h"
#include "ui/export/image_exporter.h"
#include "ui/main_window/theme.h"
#include "ui/viewport/render_session.h"

#include <QAction>
#include <QFileInfo>

namespace prizma {

ExportActions::ExportActions(Document& document, RenderSession& session, QWidget& window)
    : QObject(&window),
      document_(document),
      session_(session),
      window_(window),
      imageExporter_(new ImageExporter(document, session, window)),
      exporter_(new AnimationExporter(this)),
      exportImage_(new QAction(icon(QStringLiteral("document-export")), tr("&Export Image…"), this)),
      exportAnimation_(new QAction(icon(QStringLiteral("timeline")), tr("Export Ani&mation…"), this)) {
    exportImage_->setShortcut(Qt::CTRL | Qt::Key_E);
    exportImage_->setStatusTip(tr("Save the picture that is in the view"));
    connect(exportImage_, &QAction::triggered, imageExporter_, &ImageExporter::ask);
    connect(imageExporter_, &ImageExporter::message, this, &ExportActions::message);
    exportAnimation_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
    exportAnimation_->setStatusTip(tr("Render the frames of the timeline into pictures or a video"));
    connect(exportAnimation_, &QAction::triggered, this, [this] {
        if (exporter_->isBusy())
            showProgress();
        else
            ask();
    });
    connect(exporter_, &AnimationExporter::started, this, &ExportActions::showProgress);
    connect(exporter_, &AnimationExporter::message, this, &ExportActions::message);
}

void ExportActions::ask() {
    const QString name = QFileInfo(document_.title()).completeBaseName();
    auto* dialog = new AnimationExportDialog(document_.scene(), name, &window_);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { start(dialog->animation()); });
    dialog->open();
}

void ExportActions::start(const AnimationExport& animation) {
    exporter_->start(document_.scene(), QString::fromStdString(session_.device().id), animation);
}

void ExportActions::showProgress() {
    auto* dialog = window_.findChild<ExportProgressDialog*>();
    if (!dialog)
        dialog = new ExportProgressDialog(*exporter_, &window_);
    dialog->show();
    dialog->raise();
}

} // namespace prizma
