#include "core/import/color_words.h"

#include <string>
#include <utility>

namespace prizma {
namespace {

constexpr std::pair<std::string_view, glm::dvec3> colors[] = {
    {"black", {0.02, 0.02, 0.02}}, {"white", {0.9, 0.9, 0.9}},      {"grey", {0.22, 0.22, 0.22}},
    {"gray", {0.22, 0.22, 0.22}},  {"red", {0.6, 0.03, 0.03}},      {"green", {0.05, 0.4, 0.06}},
    {"blue", {0.04, 0.1, 0.6}},    {"yellow", {0.8, 0.6, 0.04}},    {"orange", {0.8, 0.22, 0.02}},
    {"purple", {0.25, 0.04, 0.4}}, {"pink", {0.8, 0.25, 0.4}},      {"brown", {0.16, 0.07, 0.03}},
    {"cyan", {0.04, 0.55, 0.6}},   {"magenta", {0.55, 0.03, 0.45}},
};

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}

} // namespace

std::optional<glm::dvec3> colorOfName(std::string_view name) {
    for (std::size_t start = 0; start < name.size();) {
        if (!isLetter(name[start])) {
            ++start;
            continue;
        }
        std::size_t end = start + 1; // words end at other characters and where capitals begin anew
        while (end < name.size() && isLetter(name[end]) && (isUpper(name[end - 1]) || !isUpper(name[end])))
            ++end;
        std::string word(name.substr(start, end - start));
        for (char& c : word)
            c = isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
        for (const auto& [text, color] : colors)
            if (word == text)
                return color;
        start = end;
    }
    return std::nullopt;
}

} // namespace prizma
