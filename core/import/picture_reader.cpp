#include "core/import/picture_reader.h"

#include "core/import/file_finder.h"
#include "core/import/image_loader.h"

#include <algorithm>

namespace prizma {

Texture PictureReader::read(const std::string& name) {
    if (cleanFileName(name).empty())
        return {};
    const auto [found, isNew] = textures_.try_emplace(name);
    if (isNew)
        found->second = load(name);
    return found->second;
}

Texture PictureReader::load(const std::string& name) {
    std::optional<std::string> file;
    for (const std::string& folder : folders_)
        if (!file)
            file = findFile(folder, name);
    if (!file) {
        const std::string expected = expectedPath(folders_.front(), name);
        warn("The texture is missing; a checkerboard stands in for it.", expected);
        return {expected, nullptr};
    }
    const auto image = loadImage(*file);
    if (!image) {
        warn(image.error().message, *file);
        return {*file, nullptr};
    }
    return {*file, *image};
}

Texture PictureReader::embedded(const std::string& name, const std::function<Result<ImagePtr>()>& load) {
    const std::string file = model_ + "#" + name;
    const auto [found, isNew] = textures_.try_emplace("#" + name);
    if (isNew) {
        found->second.file = file;
        if (const auto image = load())
            found->second.image = *image;
        else
            warn(image.error().message, file);
    }
    return found->second;
}

Texture PictureReader::made(const std::string& recipe, const std::function<ImagePtr()>& make) {
    std::string name = cleanFileName(recipe); // as a project file that refers to it is read
    std::ranges::replace(name, '/', ':');
    return embedded(name, [&]() -> Result<ImagePtr> { return make(); });
}

void PictureReader::warn(std::string message, const std::string& file) {
    const Diagnostic warning{Severity::Warning, std::move(message), file, 0};
    if (std::ranges::find(warnings_, warning) == warnings_.end())
        warnings_.push_back(warning);
}

} // namespace prizma
