#pragma once

#include "ui/properties/value_editor.h"

#include <glm/glm.hpp>

#include <vector>

namespace prizma {

/// Integer and Number.
class ScalarEditor : public ValueEditor {
    Q_OBJECT

  public:
    explicit ScalarEditor(const PropertyInfo& property);
    void show(const std::vector<PropertyValue>& values) override;
    NumberField* labelField() override { return field_; }

  private:
    bool integer_;
    NumberField* field_;
};

/// Vector2, Vector3, and Rotation as degrees about X, Y and Z: a field for each component.
class VectorEditor : public ValueEditor {
    Q_OBJECT

  public:
    explicit VectorEditor(const PropertyInfo& property);
    void show(const std::vector<PropertyValue>& values) override;

  private:
    void editComponent(int component, double number);

    PropertyKind kind_;
    std::vector<NumberField*> fields_;
    /// The angles on the screen: more than one triple means the same rotation, and what was typed should
    /// stay.
    glm::dvec3 shownAngles_{0.0};
};

/// Puts fields for the components of `property` into a row; their colour marks tell them apart.
std::vector<NumberField*> makeComponentFields(const PropertyInfo& property, int count, QWidget* parent);

} // namespace prizma
