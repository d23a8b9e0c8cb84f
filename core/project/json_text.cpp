#include "core/project/json_text.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace prizma {
namespace {

constexpr std::size_t deepestNesting = 64; ///< Far beyond any real project; spares the stack.

/// Walks over the text for the parser and counts lines on the way; copies share one counter.
struct LineCounter {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    int* line = nullptr;

    reference operator*() const { return *at; }
    LineCounter& operator++() {
        if (line && *at == '\n')
            ++*line;
        ++at;
        return *this;
    }
    LineCounter operator++(int) {
        LineCounter old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const LineCounter& a, const LineCounter& b) { return a.at == b.at; }
};

struct TooDeep : std::exception {};

/// Follows the parser and notes the line of each value.
class LineRecorder {
  public:
    LineRecorder(std::map<std::string, int>& lines, const int& line) : lines_(lines), line_(line) {}

    void follow(Json::parse_event_t event, const Json& parsed) {
        using Event = Json::parse_event_t;
        switch (event) {
        case Event::key:
            open_.back().key = parsed.get<std::string>();
            break;
        case Event::object_start:
        case Event::array_start:
            beginValue();
            open_.push_back({currentPath_, {}, 0, event == Event::array_start});
            if (open_.size() > deepestNesting)
                throw TooDeep();
            break;
        case Event::object_end:
        case Event::array_end:
            open_.pop_back();
            break;
        case Event::value:
            beginValue();
            break;
        }
    }

  private:
    struct Container {
        std::string path, key;
        int index;
        bool isArray;
    };

    void beginValue() {
        currentPath_.clear();
        if (!open_.empty()) {
            Container& parent = open_.back();
            currentPath_ = parent.path + "/" + (parent.isArray ? std::to_string(parent.index++) : parent.key);
        }
        lines_[currentPath_] = line_;
    }

    std::map<std::string, int>& lines_;
    const int& line_;
    std::vector<Container> open_;
    std::string currentPath_;
};

int lineAt(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

bool isFlat(const Json& list) {
    return std::none_of(list.begin(), list.end(), [](const Json& item) { return item.is_structured(); });
}

std::string formatScalar(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void format(const Json& json, const std::string& indent, std::string& text) {
    const std::string inner = indent + "  ";
    if (json.is_array() && isFlat(json)) {
        text += '[';
        for (std::size_t i = 0; i < json.size(); ++i)
            text += (i > 0 ? ", " : "") + formatScalar(json[i]);
        text += ']';
    } else if (json.is_array()) {
        text += '[';
        for (std::size_t i = 0; i < json.size(); ++i) {
            text += (i > 0 ? ",\n" : "\n") + inner;
            format(json[i], inner, text);
        }
        text += "\n" + indent + "]";
    } else if (json.is_object() && !json.empty()) {
        text += '{';
        bool first = true;
        for (const auto& [key, value] : json.items()) {
            text += (first ? "\n" : ",\n") + inner + formatScalar(key) + ": ";
            format(value, inner, text);
            first = false;
        }
        text += "\n" + indent + "}";
    } else {
        text += formatScalar(json);
    }
}

} // namespace

int JsonText::lineOf(std::string path) const {
    while (true) {
        if (const auto found = lines.find(path); found != lines.end())
            return found->second;
        const auto slash = path.find_last_of('/');
        if (slash == std::string::npos)
            return 0;
        path.resize(slash);
    }
}

Result<JsonText> parseJson(const std::string& text, const std::string& file) {
    JsonText result;
    int line = 1;
    LineRecorder recorder(result.lines, line);
    try {
        const LineCounter begin{text.data(), &line};
        const LineCounter end{text.data() + text.size(), nullptr};
        result.root = Json::parse(begin, end, [&](int, Json::parse_event_t event, Json& parsed) {
            recorder.follow(event, parsed);
            return true;
        });
        return result;
    } catch (const Json::parse_error& error) {
        const bool ended = error.byte >= text.size();
        return failure(ended ? "The file ends too early: it is damaged or was cut off."
                             : "The file is not valid JSON here.",
                       file, lineAt(text, error.byte > 0 ? error.byte - 1 : 0));
    } catch (const TooDeep&) {
        return failure("The file is nested too deeply.", file, line);
    } catch (const std::exception& error) {
        return failure(std::string("The file could not be read: ") + error.what(), file, line);
    }
}

std::string formatJson(const Json& json) {
    std::string text;
    format(json, "", text);
    return text + "\n";
}

} // namespace prizma
