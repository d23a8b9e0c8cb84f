#pragma once

#include <QDialog>

class QCheckBox;
class QComboBox;

namespace prizma {

/// What the user wants the editor to be like; kept in QSettings.
namespace preferences {
bool opensLogOnError();
bool opensDemo();   ///< At start, if no file is given.
QString language(); ///< "hu"; empty: the system's.
} // namespace preferences

class PreferencesDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PreferencesDialog(QWidget* parent = nullptr);

    void accept() override;

  private:
    void fillLanguages();

    QComboBox* language_;
    QCheckBox* openLog_;
    QCheckBox* openDemo_;
};

} // namespace prizma
