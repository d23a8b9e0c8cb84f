#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace prizma {

/// Goes through a text line by line and counts them. Lines end with LF or CRLF, or all with CR alone.
class LineReader {
  public:
    explicit LineReader(std::string_view text);

    bool next();                   ///< To the next line, from the start to the first; false at the end.
    std::string_view line() const; ///< Without what ends it.
    int number() const { return number_; } ///< 1-based.
    std::string_view peek() const;         ///< The line after this one; empty if there is none.

    double fraction() const; ///< How much of the text was passed, 0 to 1.

  private:
    std::string_view lineAt(std::size_t start) const;

    std::string_view text_;
    char end_;
    std::size_t start_ = 0, next_ = 0;
    int number_ = 0;
};

/// The fields of one line, separated by spaces or tabs. A field that begins with //, # or ; begins a comment
/// up to the line's end.
class Fields {
  public:
    explicit Fields(std::string_view line) : rest_(line) {}

    bool atEnd();

    /// The next field; what is in quotes is one, without them. Nothing at the end or if the closing quote is
    /// missing.
    std::optional<std::string_view> word();

    std::optional<int> integer();

    /// A finite number, read without regard to the locale. One too small for a double is 0.
    std::optional<double> number();

    std::string_view rest(); ///< All that follows, a comment too, without spaces around it.

  private:
    std::string_view plainWord();

    std::string_view rest_;
};

std::string_view trimmed(std::string_view text);

/// Whether a line is blank or holds nothing but a comment.
bool isBlankOrComment(std::string_view line);

} // namespace prizma
