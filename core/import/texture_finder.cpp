#include "core/import/texture_finder.h"

#include "core/import/file_finder.h"
#include "core/import/image_loader.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace prizma {
namespace {

namespace fs = std::filesystem;

constexpr std::array pictureExtensions{"bmp", "tga", "png", "jpg", "jpeg"};

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

bool isPictureName(const std::string& name) {
    return std::ranges::find(pictureExtensions, lowerExtension(name)) != pictureExtensions.end();
}

/// What the file may be called in its folder, the likeliest first, in lower case.
std::vector<std::string> candidates(const std::string& name) {
    const fs::path file = fs::path(lowerCase(name)).filename();
    std::vector<std::string> list{file.string()};
    const std::string stem = isPictureName(name) ? file.stem().string() : file.string();
    for (const char* extension : pictureExtensions)
        list.push_back(stem + "." + extension);
    return list;
}

} // namespace

const TextureFinder::Listing& TextureFinder::listingOf(const std::string& folder) {
    const auto [found, isNew] = listings_.try_emplace(folder);
    if (!isNew)
        return found->second;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!isPictureName(name) || !entry->is_regular_file(error))
            continue;
        // Of several that differ in case only always the same one is taken.
        std::string& kept = found->second[lowerCase(name)];
        kept = kept.empty() ? name : std::min(kept, name);
    }
    return found->second;
}

std::optional<std::string> TextureFinder::find(const std::string& materialName) {
    const std::string name = cleanFileName(materialName);
    constexpr std::size_t longestName = 4096;
    if (name.empty() || name.size() > longestName)
        return std::nullopt;
    if (name.find('/') != std::string::npos && isPictureName(name))
        for (const std::string& folder : folders_)
            if (auto file = findFile(folder, name))
                return file;
    const auto names = candidates(name);
    for (const std::string& folder : folders_) {
        const Listing& listing = listingOf(folder);
        for (const std::string& candidate : names)
            if (const auto found = listing.find(candidate); found != listing.end())
                return absolutePath((fs::path(folder) / found->second).string());
    }
    return std::nullopt;
}

Texture TextureFinder::read(const std::string& materialName, Diagnostics& warnings) {
    const auto file = find(materialName);
    if (!file && !isPictureName(cleanFileName(materialName)))
        return {};
    if (!file) {
        const std::string expected = expectedPath(folders_.front(), materialName);
        warnings.push_back(
            {Severity::Warning, "The texture is missing; a checkerboard stands in for it.", expected, 0});
        return {expected, nullptr};
    }
    const auto [known, isNew] = textures_.try_emplace(*file);
    if (isNew) {
        known->second.file = *file;
        if (const auto image = loadImage(*file))
            known->second.image = *image;
        else
            warnings.push_back({Severity::Warning, image.error().message, *file, 0});
    }
    return known->second;
}

} // namespace prizma
