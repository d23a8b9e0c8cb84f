#include "core/import/text_file.h"

#include "core/import/atomic_file.h"
#include "core/import/text_encoding.h"

#include <filesystem>

namespace prizma {

Result<std::string> readTextFile(const std::string& file, std::size_t mostBytes) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        return failure("There is no such file.", file);
    if (!std::filesystem::is_regular_file(status))
        return failure("It is no plain file.", file);
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size > mostBytes)
        return failure("The file is larger than the " + std::to_string(mostBytes >> 20) +
                           " MiB that are read of its kind.",
                       file);
    auto content = readFile(file);
    if (!content)
        return std::unexpected(content.error());
    if (content->empty())
        return failure("The file is empty.", file);
    auto text = toUtf8(std::move(*content));
    if (!text)
        return failure("It is not a text file.", file);
    return std::move(*text);
}

} // namespace prizma
