#include "core/compute/kernel_source.h"

#include <algorithm>
#include <vector>

namespace prizma {
namespace {

constexpr std::string_view includeDirective = "#include \"";

/// `open` holds the files that are being expanded, outermost first. Files guard themselves against being read
/// twice, as an #include inside an #ifdef must not keep a later one from bringing in the text.
void expand(std::string_view name, std::string_view text, std::vector<std::string_view>& open,
            std::string& out) {
    if (std::ranges::count(open, name) > 0)
        return;
    open.push_back(name);
    const auto lineDirective = [&](int line) {
        out += "#line " + std::to_string(line) + " \"" + std::string(name) + "\"\n";
    };
    lineDirective(1);
    for (int line = 1; !text.empty(); ++line) {
        const auto end = text.find('\n');
        const std::string_view current = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (current.starts_with(includeDirective)) {
            const std::string_view rest = current.substr(includeDirective.size());
            const std::string_view included = rest.substr(0, rest.find('"'));
            expand(included, kernelFile(included), open, out);
            lineDirective(line + 1);
        } else {
            out += current;
            out += '\n';
        }
    }
    open.pop_back();
}

} // namespace

std::string expandedKernelSource(std::string_view name) {
    return expandedKernelSource(name, kernelFile(name));
}

std::string expandedKernelSource(std::string_view name, std::string_view text) {
    std::vector<std::string_view> open;
    std::string out;
    expand(name, text, open, out);
    return out;
}

} // namespace prizma
