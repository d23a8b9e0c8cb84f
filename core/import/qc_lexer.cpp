#include "core/import/qc_lexer.h"

#include <algorithm>

namespace prizma {
namespace {

constexpr bool isSpace(char c) {
    return c >= 0 && c <= ' ';
}

} // namespace

void QcLexer::advance(std::size_t count) {
    const std::size_t end = std::min(at_ + count, text_.size());
    for (; at_ < end; ++at_)
        line_ += text_[at_] == '\n' ? 1 : 0;
}

void QcLexer::skipToToken() {
    while (at_ < text_.size()) {
        const std::string_view rest = text_.substr(at_);
        if (isSpace(rest.front()))
            advance(1);
        else if (rest.front() == '#' || rest.front() == ';' || rest.starts_with("//"))
            advance(std::min(rest.find('\n'), rest.size()));
        else if (rest.starts_with("/*"))
            advance(std::min(rest.find("*/", 2), rest.size() - 2) + 2);
        else
            return;
    }
}

std::optional<QcToken> QcLexer::next() {
    skipToToken();
    if (at_ >= text_.size())
        return std::nullopt;
    const std::string_view rest = text_.substr(at_);
    QcToken token;
    token.line = line_;
    if (rest.front() == '"') { // a missing quote costs no more than its line
        const std::size_t end = std::min(rest.find_first_of("\"\r\n", 1), rest.size());
        token.text = rest.substr(1, end - 1);
        token.isQuoted = true;
        advance(end + (end < rest.size() && rest[end] == '"' ? 1 : 0));
        return token;
    }
    std::size_t length = 1;
    if (rest.front() != '{' && rest.front() != '}')
        while (length < rest.size() && !isSpace(rest[length]) && rest[length] != '{' && rest[length] != '}' &&
               rest[length] != '"' && rest[length] != ';')
            ++length;
    token.text = rest.substr(0, length);
    advance(length);
    return token;
}

std::optional<QcToken> QcLexer::peek() {
    QcLexer ahead = *this;
    return ahead.next();
}

void QcLexer::skipContinuedLine() {
    for (;;) {
        const std::string_view rest = text_.substr(at_);
        const std::size_t length = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, length);
        while (!line.empty() && isSpace(line.back()))
            line.remove_suffix(1);
        advance(length + 1);
        if (!line.ends_with('\\') || at_ >= text_.size())
            return;
    }
}

} // namespace prizma
