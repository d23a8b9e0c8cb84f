#include "ui/properties/value_editor.h"

#include "ui/document/strings.h"
#include "ui/properties/color_editor.h"
#include "ui/properties/number_editors.h"
#include "ui/properties/number_field.h"
#include "ui/properties/simple_editors.h"
#include "ui/properties/texture_editor.h"

namespace prizma {

void ValueEditor::forwardGestures(NumberField* field) {
    connect(field, &NumberField::gestureStarted, this, &ValueEditor::gestureStarted);
    connect(field, &NumberField::gestureFinished, this, &ValueEditor::gestureFinished);
}

void ValueEditor::editAll(PropertyValue value) {
    Q_EMIT edited([value = std::move(value)](const PropertyValue&) { return value; });
}

std::unique_ptr<ValueEditor> makeValueEditor(const PropertyInfo& property,
                                             const std::vector<ShownChoice>& choices) {
    std::vector<ShownChoice> shown = choices;
    if (shown.empty())
        for (const Choice& choice : property.choices)
            shown.push_back({std::string(choice.key), translated(choice.label)});
    if (!shown.empty())
        return std::make_unique<ChoiceEditor>(shown);
    switch (property.kind) {
    case PropertyKind::Boolean:
        return std::make_unique<BooleanEditor>();
    case PropertyKind::Integer:
    case PropertyKind::Number:
        return std::make_unique<ScalarEditor>(property);
    case PropertyKind::Vector2:
    case PropertyKind::Vector3:
    case PropertyKind::Rotation:
        return std::make_unique<VectorEditor>(property);
    case PropertyKind::Color:
        return std::make_unique<ColorEditor>(property);
    case PropertyKind::Texture:
        return std::make_unique<TextureEditor>();
    case PropertyKind::Text:
    case PropertyKind::Choice:
        break;
    }
    return std::make_unique<TextEditor>();
}

} // namespace prizma
