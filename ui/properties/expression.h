#pragma once

#include <QString>

#include <optional>

namespace prizma {

/// Evaluates what a person typed into a number field: + - * / ^, brackets, pi, sqrt(), sin() and the like (in
/// degrees), a comma as decimal point, "50%", and `unit` behind the number. "+=2", "*=0.5" and so on start
/// from `present`. Nothing if it is no expression or its value is not finite.
std::optional<double> evaluate(const QString& text, const QString& unit = {}, double present = 0.0);

} // namespace prizma
