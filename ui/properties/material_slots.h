#pragma once

#include "core/scene/scene.h"

#include <QWidget>

#include <vector>

class QComboBox;

namespace prizma {

class Document;

/// The material slots of the selected objects, with a choice of material for each and a way to get there.
class MaterialSlots : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialSlots(Document& document, QWidget* parent = nullptr);

    /// Shows the slots of the last one of `objects`; an edit of a slot is for all that have it.
    void show(const std::vector<Id>& objects);

    using QWidget::show;

  private:
    void rebuild(const std::vector<std::string>& names);
    void fill(QComboBox& box, Id current);
    void chosen(int slot, int index);
    void jump(int slot);
    void assignNew(int slot);

    Document& document_;
    std::vector<Id> objects_;
    std::vector<std::string> names_;
    std::vector<QComboBox*> boxes_;
    QWidget* content_ = nullptr;
};

} // namespace prizma
