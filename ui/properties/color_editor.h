#pragma once

#include "ui/properties/value_editor.h"

#include <QColor>
#include <QPointer>

class QColorDialog;
class QToolButton;

namespace prizma {

/// The colour that a screen shows for linear RGB: what is brighter than the screen can be is scaled down.
QColor displayColor(const glm::dvec3& linear);
glm::dvec3 linearColor(const QColor& color);

/// A swatch that opens a colour dialog, and the three linear components as numbers.
class ColorEditor : public ValueEditor {
    Q_OBJECT

  public:
    explicit ColorEditor(const PropertyInfo& property);
    void show(const std::vector<PropertyValue>& values) override;

  private:
    void openDialog();
    void showSwatch();

    QString title_;
    QToolButton* swatch_;
    std::vector<NumberField*> fields_;
    glm::dvec3 color_{0.0};
    QPointer<QColorDialog> dialog_;
};

} // namespace prizma
