#include "core/import/file_finder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace prizma {
namespace {

namespace fs = std::filesystem;

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

bool isFile(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// `folder`/`part` regardless of case; of several the first by name, so that the answer is always the same.
std::optional<fs::path> findEntry(const fs::path& folder, const fs::path& part) {
    std::error_code error;
    if (part == ".." || part == "." || fs::exists(folder / part, error))
        return folder / part;
    std::optional<fs::path> best;
    const std::string wanted = lowerCase(part.string());
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (lowerCase(entry->path().filename().string()) == wanted && (!best || entry->path() < *best))
            best = entry->path();
    return best;
}

std::optional<fs::path> findRegardlessOfCase(const fs::path& path) {
    fs::path found = path.root_path();
    for (const fs::path& part : path.relative_path()) {
        const auto next = findEntry(found, part);
        if (!next)
            return std::nullopt;
        found = *next;
    }
    return found;
}

std::optional<fs::path> findFileRegardlessOfCase(const fs::path& path) {
    const auto found = findRegardlessOfCase(path);
    return found && isFile(*found) ? found : std::nullopt;
}

constexpr std::size_t longestName = 4096; ///< Beyond it no system has a file, and looking takes long.

} // namespace

std::string cleanFileName(const std::string& name) {
    std::string clean = name;
    std::replace(clean.begin(), clean.end(), '\\', '/');
    constexpr auto outer = " \t\r\n\"'";
    const auto first = clean.find_first_not_of(outer);
    if (first == std::string::npos)
        return {};
    return clean.substr(first, clean.find_last_not_of(outer) - first + 1);
}

std::optional<std::string> findFile(const std::string& folder, const std::string& name) {
    const std::string clean = cleanFileName(name);
    if (clean.empty() || name.size() > longestName || clean.find('\0') != std::string::npos)
        return std::nullopt;
    if (isFile(fs::path(folder) / name)) // a name that really has quotes or backslashes in it
        return absolutePath((fs::path(folder) / name).string());
    const fs::path path = fs::path(absolutePath(folder)) / clean;
    if (isFile(path))
        return absolutePath(path.string());
    if (const auto found = findFileRegardlessOfCase(path.lexically_normal()))
        return found->string();
    if (const auto found =
            findFileRegardlessOfCase(fs::path(absolutePath(folder)) / fs::path(clean).filename()))
        return found->string();
    return std::nullopt;
}

std::optional<std::string> findFolder(const std::string& folder, const std::string& name) {
    const std::string clean = cleanFileName(name);
    if (clean.empty() || clean.size() > longestName || clean.find('\0') != std::string::npos)
        return std::nullopt;
    std::error_code error;
    const auto found = findRegardlessOfCase((fs::path(absolutePath(folder)) / clean).lexically_normal());
    return found && fs::is_directory(*found, error) ? std::optional(found->string()) : std::nullopt;
}

std::string expectedPath(const std::string& folder, const std::string& name) {
    return absolutePath((fs::path(folder) / cleanFileName(name)).string());
}

std::string absolutePath(const std::string& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    return (error ? fs::path(path) : absolute).lexically_normal().string();
}

std::string lowerExtension(const std::string& file) {
    const std::string extension = lowerCase(fs::path(file).extension().string());
    return extension.empty() ? extension : extension.substr(1);
}

} // namespace prizma
