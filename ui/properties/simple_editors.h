#pragma once

#include "ui/properties/value_editor.h"

#include <vector>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace prizma {

class BooleanEditor : public ValueEditor {
    Q_OBJECT

  public:
    BooleanEditor();
    void show(const std::vector<PropertyValue>& values) override;

  private:
    QCheckBox* box_;
};

class ChoiceEditor : public ValueEditor {
    Q_OBJECT

  public:
    explicit ChoiceEditor(std::vector<ShownChoice> choices);
    void show(const std::vector<PropertyValue>& values) override;

  private:
    std::vector<ShownChoice> choices_;
    QComboBox* box_;
};

class TextEditor : public ValueEditor {
    Q_OBJECT

  public:
    TextEditor();
    void show(const std::vector<PropertyValue>& values) override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QLineEdit* line_;
    QString shown_;
};

} // namespace prizma
