#include "core/import/fault_tally.h"

#include <algorithm>

namespace prizma {

void FaultTally::add(std::string_view message, int line) {
    const auto same = std::ranges::find(kinds_, message, &Kind::message);
    if (same != kinds_.end())
        ++same->count;
    else
        kinds_.push_back({message, line, 1});
}

Diagnostics FaultTally::warnings(const std::string& file) const {
    Diagnostics warnings;
    for (const Kind& kind : kinds_) {
        std::string text(kind.message);
        if (kind.count > 1)
            text += " This is the first of " + std::to_string(kind.count) + " such lines.";
        warnings.push_back({Severity::Warning, std::move(text), file, kind.firstLine});
    }
    return warnings;
}

std::string listOf(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
        list += (i > 0 ? ", " : "") + names[i];
    if (names.size() > most)
        list += " and " + std::to_string(names.size() - most) + " more";
    return list;
}

} // namespace prizma
