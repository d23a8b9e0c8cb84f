#include "ui/preferences/preferences_dialog.h"

#include "ui/import/import_settings.h"
#include "ui/main_window/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace prizma {
namespace {

const QString languageKey = QStringLiteral("language");
const QString openLogKey = QStringLiteral("log/openOnError");
const QString openDemoKey = QStringLiteral("start/demo");

/// "prizma_hu.qm" is Hungarian.
QString languageOf(QString file) {
    return file.remove(QStringLiteral("prizma_")).remove(QStringLiteral(".qm"));
}

} // namespace

namespace preferences {
bool opensLogOnError() {
    return QSettings().value(openLogKey, true).toBool();
}
bool opensDemo() {
    return QSettings().value(openDemoKey, true).toBool();
}
QString language() {
    return QSettings().value(languageKey).toString();
}
} // namespace preferences

PreferencesDialog::PreferencesDialog(QWidget* parent)
    : QDialog(parent),
      language_(new QComboBox),
      openLog_(new QCheckBox(tr("Open the &log when something goes wrong"))),
      openDemo_(new QCheckBox(tr("Open the &demo scene at start"))) {
    setWindowTitle(tr("Preferences"));
    setAttribute(Qt::WA_DeleteOnClose);
    fillLanguages();
    openLog_->setChecked(preferences::opensLogOnError());
    openDemo_->setChecked(preferences::opensDemo());

    auto* general = new QGroupBox(tr("General"));
    auto* form = new QFormLayout(general);
    form->addRow(tr("Lan&guage:"), language_);
    auto* note = new QLabel(tr("Another language comes with the next start."));
    QPalette dimmed = note->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    note->setPalette(dimmed);
    form->addRow({}, note);
    form->addRow(openDemo_);
    form->addRow(openLog_);

    auto* imports = new QGroupBox(tr("Import"));
    auto* importLayout = new QVBoxLayout(imports);
    auto* forget = new QPushButton(tr("&Forget Remembered Options"));
    forget->setToolTip(
        tr("Ask again for the up axis and the scale of model files, whatever was remembered."));
    connect(forget, &QPushButton::clicked, this, [forget] {
        forgetImportOptions();
        forget->setEnabled(false);
    });
    importLayout->addWidget(forget, 0, Qt::AlignLeft);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addWidget(general);
    layout->addWidget(imports);
    layout->addStretch(1);
    layout->addWidget(buttons);
    setMinimumWidth(400);
}

void PreferencesDialog::fillLanguages() {
    language_->addItem(tr("As the system"), QString());
    language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
    for (const QString& file : QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("prizma_*.qm")})) {
        const QString code = languageOf(file);
        QString name = QLocale(code).nativeLanguageName();
        if (!name.isEmpty())
            name[0] = name[0].toUpper();
        language_->addItem(name, code);
    }
    language_->setCurrentIndex(std::max(0, language_->findData(preferences::language())));
}

void PreferencesDialog::accept() {
    QSettings settings;
    settings.setValue(languageKey, language_->currentData());
    settings.setValue(openLogKey, openLog_->isChecked());
    settings.setValue(openDemoKey, openDemo_->isChecked());
    QDialog::accept();
}

} // namespace prizma
