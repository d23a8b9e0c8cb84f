#pragma once

#include "ui/properties/value_editor.h"

#include <QLabel>
#include <QObject>

class QGridLayout;
class QToolButton;

namespace prizma {

/// A property's name; dragging it turns the number beside it.
class PropertyLabel : public QLabel {
    Q_OBJECT

  public:
    PropertyLabel(const QString& text, ValueEditor& editor);

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    NumberField* field_;
    int lastX_ = 0;
    bool dragging_ = false;
};

/// One line of the property panel: name, editor, and a button that is there while the value is not the
/// default.
class PropertyRow : public QObject {
    Q_OBJECT

  public:
    /// Adds its widgets to a new row of `grid`.
    PropertyRow(const PropertyInfo& property, std::unique_ptr<ValueEditor> editor, QGridLayout& grid,
                QObject* parent);

    const std::string& key() const { return key_; }
    ValueEditor& editor() { return *editor_; }

    /// `values` of all selected things, the current one's last.
    void show(const std::vector<PropertyValue>& values);

  Q_SIGNALS:
    void resetRequested(const prizma::PropertyValue& value);

  private:
    std::string key_;
    PropertyValue defaultValue_;
    ValueEditor* editor_; ///< Owned by the grid's widget.
    QToolButton* reset_;
};

} // namespace prizma
