#include "ui/properties/expression.h"

#include <cmath>
#include <numbers>

namespace prizma {
namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

/// Recursive descent; after a fault `failed` stays set and the value means nothing.
class Parser {
  public:
    explicit Parser(const QString& text) : text_(text) {}

    std::optional<double> parse() {
        const double value = sum();
        skipSpace();
        if (failed_ || at_ != text_.size() || !std::isfinite(value))
            return std::nullopt;
        return value;
    }

  private:
    void skipSpace() {
        while (at_ < text_.size() && text_[at_].isSpace())
            ++at_;
    }

    bool accept(char symbol) {
        skipSpace();
        if (at_ >= text_.size() || text_[at_] != QLatin1Char(symbol))
            return false;
        ++at_;
        return true;
    }

    double sum() {
        double value = product();
        while (!failed_) {
            if (accept('+'))
                value += product();
            else if (accept('-'))
                value -= product();
            else
                break;
        }
        return value;
    }

    double product() {
        double value = sign();
        while (!failed_) {
            if (accept('*'))
                value *= sign();
            else if (accept('/'))
                value /= sign();
            else
                break;
        }
        return value;
    }

    double sign() {
        if (++depth_ > maximumDepth)
            return fail();
        double value = 0.0;
        if (accept('-'))
            value = -sign();
        else if (accept('+'))
            value = sign();
        else
            value = power();
        --depth_;
        return value;
    }

    double power() {
        const double base = operand();
        return !failed_ && accept('^') ? std::pow(base, sign()) : base;
    }

    double operand() {
        double value = 0.0;
        skipSpace();
        if (accept('(')) {
            value = sum();
            if (!accept(')'))
                return fail();
        } else if (at_ < text_.size() && text_[at_].isLetter()) {
            value = word();
        } else {
            value = number();
        }
        return accept('%') ? value / 100.0 : value;
    }

    double number() {
        const qsizetype start = at_;
        const auto digits = [this] {
            while (at_ < text_.size() && text_[at_].isDigit())
                ++at_;
        };
        digits();
        if (at_ < text_.size() && (text_[at_] == QLatin1Char('.') || text_[at_] == QLatin1Char(','))) {
            ++at_;
            digits();
        }
        if (at_ > start && at_ < text_.size() && text_[at_].toLower() == QLatin1Char('e')) {
            const qsizetype beforeExponent = at_;
            ++at_;
            if (at_ < text_.size() && (text_[at_] == QLatin1Char('-') || text_[at_] == QLatin1Char('+')))
                ++at_;
            const qsizetype exponent = at_;
            digits();
            if (at_ == exponent)
                at_ = beforeExponent;
        }
        bool isNumber = false;
        const double value =
            text_.mid(start, at_ - start).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
        return isNumber ? value : fail();
    }

    double word() {
        const qsizetype start = at_;
        while (at_ < text_.size() && text_[at_].isLetter())
            ++at_;
        const QString name = text_.mid(start, at_ - start).toLower();
        if (name == QLatin1String("pi"))
            return std::numbers::pi;
        if (!accept('('))
            return fail();
        const double argument = sum();
        if (!accept(')'))
            return fail();
        if (name == QLatin1String("sqrt"))
            return std::sqrt(argument);
        if (name == QLatin1String("abs"))
            return std::abs(argument);
        if (name == QLatin1String("sin"))
            return std::sin(radians(argument));
        if (name == QLatin1String("cos"))
            return std::cos(radians(argument));
        if (name == QLatin1String("tan"))
            return std::tan(radians(argument));
        return fail();
    }

    double fail() {
        failed_ = true;
        return 0.0;
    }

    static constexpr int maximumDepth =
        200; ///< Of nested brackets and signs: pasted text must not use up the stack.

    const QString& text_;
    qsizetype at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

/// The operator of "+=2" and the like, or a null character. "-=" is told from a negative number by its "=".
QChar assignment(const QString& text) {
    if (text.size() < 2 || text[1] != QLatin1Char('='))
        return {};
    return QStringLiteral("+-*/").contains(text[0]) ? text[0] : QChar();
}

} // namespace

std::optional<double> evaluate(const QString& text, const QString& unit, double present) {
    QString expression = text.trimmed();
    if (!unit.isEmpty() && expression.endsWith(unit, Qt::CaseInsensitive))
        expression.chop(unit.size());
    const QChar operation = assignment(expression);
    if (operation.isNull())
        return Parser(expression).parse();
    const QString rest = expression.mid(2);
    const auto operand = Parser(rest).parse();
    if (!operand)
        return std::nullopt;
    const double value = operation == QLatin1Char('+')   ? present + *operand
                         : operation == QLatin1Char('-') ? present - *operand
                         : operation == QLatin1Char('*') ? present * *operand
                                                         : present / *operand;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace prizma
