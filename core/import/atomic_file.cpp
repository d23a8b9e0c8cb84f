#include "core/import/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace prizma {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// What `file` stands for: a symbolic link stays one, its target is replaced.
std::string linkTarget(const std::string& file) {
    std::error_code error;
    if (!fs::is_symlink(file, error))
        return file;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target.string();
}

/// Creates an empty file next to `file` that has its permissions; the path, or an error.
Result<std::string> makeTemporary(const std::string& file) {
    std::string name = file + ".XXXXXX";
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0)
        return failure("The file could not be written: " + reason(errno) + ".", file);
    struct stat old {};
    mode_t mode = 0644;
    if (::stat(file.c_str(), &old) == 0)
        mode = old.st_mode & 07777;
    ::fchmod(descriptor, mode);
    ::close(descriptor);
    return name;
}

/// Waits until what was written is on the disk.
Result<void> flushToDisk(const std::string& path, const std::string& file) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool flushed = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0)
        ::close(descriptor);
    if (!flushed)
        return failure("The file could not be written: " + reason(error) + ".", file);
    return {};
}

Result<void> fillAndRename(const std::string& temporary, const std::string& target, const std::string& file,
                           const std::function<Result<void>(const std::string&)>& write) {
    if (auto written = write(temporary); !written) {
        written.error().file = file;
        return written;
    }
    if (auto flushed = flushToDisk(temporary, file); !flushed)
        return flushed;
    if (std::rename(temporary.c_str(), target.c_str()) != 0)
        return failure("The file could not be replaced: " + reason(errno) + ".", file);
    return {};
}

} // namespace

Result<void> replaceFile(const std::string& file,
                         const std::function<Result<void>(const std::string&)>& write) {
    const std::string target = linkTarget(file);
    std::error_code ignored;
    if (fs::is_directory(target, ignored))
        return failure("The file could not be written: it is a directory.", file);
    const auto temporary = makeTemporary(target);
    if (!temporary)
        return failure(temporary.error().message, file);
    auto result = fillAndRename(*temporary, target, file, write);
    if (!result)
        fs::remove(*temporary, ignored);
    return result;
}

Result<void> replaceFile(const std::string& file, std::string_view content) {
    return replaceFile(file, [content](const std::string& path) -> Result<void> {
        std::ofstream stream(path, std::ios::binary | std::ios::trunc);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.close();
        if (!stream)
            return failure("The file could not be written: the disk may be full.");
        return {};
    });
}

Result<std::string> readFile(const std::string& file) {
    std::error_code error;
    const auto status = fs::status(file, error);
    if (!fs::exists(status))
        return failure("There is no such file.", file);
    if (fs::is_directory(status))
        return failure("It is a directory, not a file.", file);
    if (!fs::is_regular_file(status))
        return failure("It is not a regular file.", file);
    std::ifstream stream(file, std::ios::binary);
    const auto size = fs::file_size(file, error);
    if (!stream || error)
        return failure("The file could not be opened: " + reason(error ? error.value() : errno) + ".", file);
    std::string content(size, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(size));
    if (stream.bad())
        return failure("The file could not be read.", file);
    content.resize(static_cast<std::size_t>(stream.gcount()));
    return content;
}

} // namespace prizma
