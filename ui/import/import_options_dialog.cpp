#include "ui/import/import_options_dialog.h"

#include "ui/import/import_settings.h"
#include "ui/properties/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace prizma {

ImportOptionsDialog::ImportOptionsDialog(const QStringList& files, QWidget* parent)
    : QDialog(parent), upAxis_(new QComboBox), scale_(new NumberField), remember_(new QCheckBox) {
    setWindowTitle(tr("Import Model"));
    setAttribute(Qt::WA_DeleteOnClose);
    const QFileInfo first(files.value(0));
    const ImportOptions preset = importOptionsFor(files.value(0));

    auto* heading = new QLabel(files.size() == 1
                                   ? tr("How is <b>%1</b> to be read?").arg(first.fileName().toHtmlEscaped())
                                   : tr("How are these %1 files to be read?").arg(files.size()));
    upAxis_->addItem(tr("Y (most OBJ, FBX and glTF files)"));
    upAxis_->addItem(tr("Z (SMD, STL and CAD files)"));
    upAxis_->setCurrentIndex(preset.upAxis == UpAxis::Z ? 1 : 0);
    upAxis_->setToolTip(
        tr("The axis that points up in the file. The model is turned so that it stands upright."));
    scale_->setRange(1e-6, 1e6);
    scale_->setStep(0.1);
    scale_->setValue(preset.unitScale);
    scale_->setToolTip(tr("Scene units for each unit of the file: 0.01 turns centimetres into metres."));
    remember_->setText(
        tr("Read all .%1 files in this folder this way, without asking").arg(first.suffix().toLower()));
    remember_->setToolTip(tr("Preferences can make the editor forget this."));

    auto* form = new QFormLayout;
    form->addRow(tr("&Up axis:"), upAxis_);
    form->addRow(tr("&Scale:"), scale_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addWidget(heading);
    layout->addLayout(form);
    layout->addWidget(remember_);
    layout->addWidget(buttons);
    setMinimumWidth(420);
}

ImportOptions ImportOptionsDialog::options() const {
    return {upAxis_->currentIndex() == 1 ? UpAxis::Z : UpAxis::Y, scale_->value()};
}

bool ImportOptionsDialog::isRemembered() const {
    return remember_->isChecked();
}

} // namespace prizma
