#include "ui/timeline/labelled_field.h"

#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"

#include <QBoxLayout>
#include <QLabel>

namespace prizma {

NumberField* addLabelledField(QBoxLayout& layout, const QString& label, const QString& longest) {
    constexpr int frame = 16; // What a field needs around its text.
    auto* caption = new QLabel(label);
    QPalette dimmed = caption->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    caption->setPalette(dimmed);
    caption->setContentsMargins(6, 0, 2, 0);
    auto* field = new NumberField;
    field->setAccessibleName(label);
    field->setFixedWidth(field->fontMetrics().horizontalAdvance(longest) + frame);
    layout.addWidget(caption);
    layout.addWidget(field);
    return field;
}

} // namespace prizma
