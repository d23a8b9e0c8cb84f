#include "ui/properties/number_editors.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"

#include <QHBoxLayout>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

void setUp(NumberField& field, const PropertyInfo& property) {
    field.setRange(property.minimum, property.maximum);
    field.setStep(property.step);
    field.setUnit(translated(property.unit));
    field.setToolTip(translated(property.help));
}

QHBoxLayout* makeRow(QWidget* parent) {
    auto* row = new QHBoxLayout(parent);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    return row;
}

bool meansSame(const glm::dquat& a, const glm::dquat& b) {
    return std::abs(std::abs(glm::dot(glm::normalize(a), glm::normalize(b))) - 1.0) < 1e-12;
}

double componentOf(const PropertyValue& value, int component) {
    if (const auto* pair = std::get_if<glm::dvec2>(&value))
        return (*pair)[component];
    if (const auto* triple = std::get_if<glm::dvec3>(&value))
        return (*triple)[component];
    return eulerDegrees(std::get<glm::dquat>(value))[component];
}

} // namespace

std::vector<NumberField*> makeComponentFields(const PropertyInfo& property, int count, QWidget* parent) {
    static const QStringList names{QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    std::vector<NumberField*> fields;
    for (int i = 0; i < count; ++i) {
        auto* field = new NumberField(parent);
        setUp(*field, property);
        field->setMarkColor(theme::axis(i));
        if (property.kind != PropertyKind::Color)
            field->setToolTip(QStringLiteral("%1: %2").arg(names[i], translated(property.help)));
        field->setObjectName(toQString(property.key) + names[i]);
        fields.push_back(field);
    }
    return fields;
}

ScalarEditor::ScalarEditor(const PropertyInfo& property)
    : integer_(property.kind == PropertyKind::Integer), field_(new NumberField(this)) {
    setUp(*field_, property);
    field_->setInteger(integer_);
    field_->setObjectName(toQString(property.key));
    makeRow(this)->addWidget(field_);
    setFocusProxy(field_);
    forwardGestures(field_);
    connect(field_, &NumberField::valueEdited, this, [this](double number) {
        if (integer_)
            editAll(static_cast<int>(std::lround(number)));
        else
            editAll(number);
    });
}

void ScalarEditor::show(const std::vector<PropertyValue>& values) {
    const auto number = [this](const PropertyValue& value) {
        return integer_ ? static_cast<double>(std::get<int>(value)) : std::get<double>(value);
    };
    field_->setValue(number(values.back()));
    field_->setMixed(std::any_of(values.begin(), values.end(), [&](const PropertyValue& value) {
        return number(value) != number(values.back());
    }));
}

VectorEditor::VectorEditor(const PropertyInfo& property) : kind_(property.kind) {
    auto* row = makeRow(this);
    fields_ = makeComponentFields(property, kind_ == PropertyKind::Vector2 ? 2 : 3, this);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        row->addWidget(fields_[i]);
        forwardGestures(fields_[i]);
        connect(fields_[i], &NumberField::valueEdited, this,
                [this, component = static_cast<int>(i)](double number) { editComponent(component, number); });
    }
    setFocusProxy(fields_.front());
}

void VectorEditor::show(const std::vector<PropertyValue>& values) {
    if (kind_ == PropertyKind::Rotation) {
        const auto& rotation = std::get<glm::dquat>(values.back());
        if (!meansSame(rotation, rotationFromEulerDegrees(shownAngles_)))
            shownAngles_ = eulerDegrees(rotation);
    }
    for (int i = 0; i < static_cast<int>(fields_.size()); ++i) {
        const double current = componentOf(values.back(), i);
        NumberField& field = *fields_[static_cast<std::size_t>(i)];
        field.setValue(kind_ == PropertyKind::Rotation ? shownAngles_[i] : current);
        field.setMixed(std::any_of(values.begin(), values.end(), [&](const PropertyValue& value) {
            return componentOf(value, i) != current;
        }));
    }
}

void VectorEditor::editComponent(int component, double number) {
    const glm::dvec3 before = shownAngles_;
    const glm::dquat current = rotationFromEulerDegrees(before);
    shownAngles_[component] = number;
    Q_EMIT edited([component, number, before, current](const PropertyValue& value) -> PropertyValue {
        if (auto pair = value; auto* v = std::get_if<glm::dvec2>(&pair)) {
            (*v)[component] = number;
            return pair;
        }
        if (auto triple = value; auto* v = std::get_if<glm::dvec3>(&triple)) {
            (*v)[component] = number;
            return triple;
        }
        const auto& rotation = std::get<glm::dquat>(value);
        glm::dvec3 angles = meansSame(rotation, current) ? before : eulerDegrees(rotation);
        angles[component] = number;
        return rotationFromEulerDegrees(angles);
    });
}

} // namespace prizma
