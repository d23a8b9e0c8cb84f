#include "core/project/version.h"

#include <array>

namespace prizma {
namespace {

/// Turns a project of version `from` into one of version `from` + 1.
struct Migration {
    int from;
    void (*apply)(Json& root);
};

/// One entry for each version that there was; version 1 is the first.
constexpr std::array<Migration, projectVersion - 1> migrations{};

} // namespace

Result<void> migrateProject(JsonText& text, const std::string& file) {
    const int line = text.lineOf("/prizma");
    const auto version = text.root.find("prizma");
    if (version == text.root.end())
        return failure("It is not a Prizma project: the version (\"prizma\": 1) is missing.", file, line);
    if (!version->is_number_integer() || version->get<std::int64_t>() < 1)
        return failure("\"prizma\" must be the version, a whole number from 1.", file, line);
    if (version->get<std::int64_t>() > projectVersion)
        return failure("The project was written by a newer version of Prizma.", file, line);
    for (const Migration& migration : migrations)
        if (text.root["prizma"] == migration.from) {
            migration.apply(text.root);
            text.root["prizma"] = migration.from + 1;
        }
    return {};
}

} // namespace prizma
