#include "core/import/text_fields.h"

#include <charconv>
#include <cmath>

namespace prizma {
namespace {

constexpr bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool beginsComment(std::string_view text) {
    return text.starts_with('#') || text.starts_with(';') || text.starts_with("//");
}

void skipSpaces(std::string_view& text) {
    std::size_t at = 0;
    while (at < text.size() && isSpace(text[at]))
        ++at;
    text.remove_prefix(at);
}

/// from_chars takes no plus sign.
std::string_view withoutPlus(std::string_view text) {
    return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

bool isTiny(std::string_view text) {
    return text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
}

} // namespace

LineReader::LineReader(std::string_view text)
    : text_(text),
      end_(text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r'
                                                                                                  : '\n') {}

std::string_view LineReader::lineAt(std::size_t start) const {
    return start < text_.size() ? text_.substr(start, text_.find(end_, start) - start) : std::string_view();
}

bool LineReader::next() {
    if (next_ >= text_.size())
        return false;
    start_ = next_;
    const std::size_t end = text_.find(end_, start_);
    next_ = end == std::string_view::npos ? text_.size() : end + 1;
    ++number_;
    return true;
}

std::string_view LineReader::line() const {
    std::string_view line = text_.substr(start_, next_ - start_);
    if (line.ends_with(end_))
        line.remove_suffix(1);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

std::string_view LineReader::peek() const {
    return lineAt(next_);
}

double LineReader::fraction() const {
    return text_.empty() ? 1.0 : static_cast<double>(next_) / static_cast<double>(text_.size());
}

bool Fields::atEnd() {
    skipSpaces(rest_);
    return rest_.empty() || beginsComment(rest_);
}

std::string_view Fields::plainWord() {
    std::size_t length = 0;
    while (length < rest_.size() && !isSpace(rest_[length]))
        ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
}

std::optional<std::string_view> Fields::word() {
    if (atEnd())
        return std::nullopt;
    if (rest_.front() != '"')
        return plainWord();
    const std::size_t close = rest_.find('"', 1);
    if (close == std::string_view::npos)
        return std::nullopt;
    const std::string_view word = rest_.substr(1, close - 1);
    rest_.remove_prefix(close + 1);
    return word;
}

std::optional<int> Fields::integer() {
    if (atEnd())
        return std::nullopt;
    const std::string_view text = withoutPlus(plainWord());
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

std::optional<double> Fields::number() {
    if (atEnd())
        return std::nullopt;
    const std::string_view text = withoutPlus(plainWord());
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size())
        return std::nullopt;
    if (error == std::errc::result_out_of_range && isTiny(text))
        return 0.0;
    if (error != std::errc() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string_view Fields::rest() {
    return trimmed(rest_);
}

std::string_view trimmed(std::string_view text) {
    skipSpaces(text);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

bool isBlankOrComment(std::string_view line) {
    return Fields(line).atEnd();
}

} // namespace prizma
