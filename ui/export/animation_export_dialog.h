#pragma once

#include "core/render/animation_export.h"
#include "core/scene/scene.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace prizma {

class NumberField;

/// Asks which frames are to be exported, in what size and quality, and where to. Remembers the answers,
/// frames apart, for the next time.
class AnimationExportDialog : public QDialog {
    Q_OBJECT

  public:
    /// `name` is what the files are called at first.
    AnimationExportDialog(const Scene& scene, const QString& name, QWidget* parent = nullptr);

    AnimationExport animation() const;

    /// Puts the files elsewhere, as the dialog for it would.
    void setOutput(const QString& file);

    void accept() override;

  private:
    void makeFields(const Scene& scene);
    QWidget* makePair(NumberField* first, const QString& between, NumberField* second);
    QWidget* makeOutputRow();
    void recall(const QString& name);
    void browse();
    void changeFormat();
    void check();
    AnimationFormat format() const;

    double fps_;
    QComboBox* format_;
    NumberField* first_;
    NumberField* last_;
    NumberField* width_;
    NumberField* height_;
    NumberField* samples_;
    QLineEdit* output_;
    QCheckBox* overwrite_;
    QCheckBox* keepPictures_;
    QLabel* note_; ///< What is wrong, or what will happen.
    QPushButton* export_;
};

} // namespace prizma
