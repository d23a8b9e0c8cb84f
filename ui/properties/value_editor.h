#pragma once

#include "core/scene/properties.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

namespace prizma {

class NumberField;

/// Shows and edits the values that one property has in all selected things.
class ValueEditor : public QWidget {
    Q_OBJECT

  public:
    /// What an edit makes of each present value. (An edit of X leaves every thing its own Y and Z.)
    using Change = std::function<PropertyValue(const PropertyValue&)>;

    using QWidget::QWidget;

    /// At least one value; the last is the current thing's. Tells nobody.
    virtual void show(const std::vector<PropertyValue>& values) = 0;

    /// The field that dragging the property's label turns; null if there is none.
    virtual NumberField* labelField() { return nullptr; }

    using QWidget::show;

  Q_SIGNALS:
    void gestureStarted(); ///< Edits until `gestureFinished` are one undo step.
    void edited(const prizma::ValueEditor::Change& change);
    void gestureFinished();
    void fileChosen(const QString& file); ///< A texture is to be read from there.

  protected:
    void forwardGestures(NumberField* field);

    /// Tells that every value is to become `value`.
    void editAll(PropertyValue value);
};

/// Possible values of a choice with the texts that are shown for them.
struct ShownChoice {
    std::string key;
    QString label;
};

/// The editor for a property. `choices` replaces the ones that the property has by itself, unless empty.
std::unique_ptr<ValueEditor> makeValueEditor(const PropertyInfo& property,
                                             const std::vector<ShownChoice>& choices = {});

} // namespace prizma
