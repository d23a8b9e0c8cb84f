#pragma once

#include "core/import/model_importer.h"

#include <QDialog>

class QCheckBox;
class QComboBox;

namespace prizma {

class NumberField;

/// Asks how the coordinates of model files are meant.
class ImportOptionsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ImportOptionsDialog(const QStringList& files, QWidget* parent = nullptr);

    ImportOptions options() const;
    bool isRemembered() const; ///< To be used for files of this kind in this folder from now on.

  private:
    QComboBox* upAxis_;
    NumberField* scale_;
    QCheckBox* remember_;
};

} // namespace prizma
