#pragma once

#include <optional>
#include <string>

namespace prizma {

/// What a model or project file means by `name`: quotes and outer spaces dropped, backslashes as slashes.
std::string cleanFileName(const std::string& name);

/// The absolute path of the file that `name`, as found in a file in `folder`, means: as written, or else
/// regardless of case, or else (paths of another machine) a file of that name in `folder` itself.
std::optional<std::string> findFile(const std::string& folder, const std::string& name);

/// The absolute path of the folder that `name`, as found in a file in `folder`, means, regardless of case.
std::optional<std::string> findFolder(const std::string& folder, const std::string& name);

/// Where `name` would be if it existed: what a missing file is called in messages and stored as.
std::string expectedPath(const std::string& folder, const std::string& name);

/// The absolute form of a path, without "." and "..".
std::string absolutePath(const std::string& path);

/// The file's extension in lower case, without the dot.
std::string lowerExtension(const std::string& file);

} // namespace prizma
