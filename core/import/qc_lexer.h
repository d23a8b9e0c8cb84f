#pragma once

#include <optional>
#include <string_view>

namespace prizma {

struct QcToken {
    std::string_view text;
    int line = 0;
    bool isQuoted = false;

    /// "$body" and the like; "$name$" is a variable.
    bool isCommand() const {
        return !isQuoted && text.size() > 1 && text.front() == '$' && text.back() != '$';
    }
    bool is(char brace) const { return !isQuoted && text.size() == 1 && text.front() == brace; }
};

/// Cuts a QC script into words: braces stand alone, what is in quotes is one word, comments (//, #, ; up to
/// the line's end, and /* */) are passed over. Works on any text.
class QcLexer {
  public:
    explicit QcLexer(std::string_view text) : text_(text) {}

    std::optional<QcToken> next();
    std::optional<QcToken> peek();

    /// Passes over the rest of the present line, and over those that follow a line ending in a backslash.
    void skipContinuedLine();

  private:
    void skipToToken();
    void advance(std::size_t count);

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

} // namespace prizma
