#include "ui/main_window/unsaved_changes.h"

#include "ui/document/document.h"

#include <QMessageBox>

namespace prizma {

UnsavedChanges::UnsavedChanges(Document& document, Save save, QWidget& window)
    : document_(document), save_(std::move(save)), window_(window) {}

void UnsavedChanges::guard(std::function<void()> proceed) {
    if (!document_.isModified()) {
        proceed();
        return;
    }
    if (asking_)
        return; // the question is on the screen already
    asking_ = true;
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Unsaved Changes"),
                                tr("Save the changes to “%1”?").arg(document_.title()),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
    box->setObjectName(QStringLiteral("unsavedChanges"));
    box->setInformativeText(tr("Without saving, they are lost."));
    box->setDefaultButton(QMessageBox::Save);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this, proceed = std::move(proceed)](int answer) {
        asking_ = false;
        if (answer == QMessageBox::Save)
            save_(proceed);
        else if (answer == QMessageBox::Discard)
            proceed();
    });
    box->open();
}

} // namespace prizma
