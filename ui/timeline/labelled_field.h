#pragma once

#include <QString>

class QBoxLayout;

namespace prizma {

class NumberField;

/// Adds a number field to `layout` behind its name, wide enough for `longest`.
NumberField* addLabelledField(QBoxLayout& layout, const QString& label, const QString& longest);

} // namespace prizma
