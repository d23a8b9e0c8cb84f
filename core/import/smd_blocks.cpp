#include "core/import/smd_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prizma {
namespace {

constexpr int linesBetweenLooks = 4096; ///< How often progress is told and asked.

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

bool isKnownBlock(std::string_view name) {
    constexpr std::array known{"nodes", "skeleton", "triangles", "vertexanimation"};
    return std::ranges::find(known, name) != known.end();
}

} // namespace

Result<std::string> SmdBlocks::nextBlock() {
    while (lines_.next()) {
        Fields fields(lines_.line());
        const auto word = fields.word();
        if (!word)
            continue;
        block_ = lowerCase(*word);
        blockLine_ = lines_.number();
        if (block_ == "version") {
            if (auto done = checkVersion(fields); !done)
                return std::unexpected(done.error());
            continue;
        }
        if (!begun_ && !isKnownBlock(block_))
            return error("It is not an SMD file: it begins neither with \"version 1\" nor with a block.");
        if (!versionKnown_) {
            faults_.add("The line \"version 1\" is missing; the file was read all the same.", blockLine_);
            versionKnown_ = true;
        }
        begun_ = true;
        return block_;
    }
    return std::string();
}

Result<void> SmdBlocks::checkVersion(Fields& fields) {
    const auto version = fields.integer();
    if (!version)
        return error("The version must be a whole number.");
    if (*version != 1)
        faults_.add("Only version 1 of the format is known; the file was read as if it were that.",
                    lines_.number());
    begun_ = true;
    versionKnown_ = true;
    return {};
}

Result<bool> SmdBlocks::nextLine() {
    if (!lines_.next())
        return failure("The file ends within the block \"" + block_ + "\": it seems to be cut off.", file_,
                       blockLine_);
    if (lines_.number() % linesBetweenLooks == 0) {
        progress_.set(lines_.fraction());
        if (progress_.isCancelled())
            return failure("The import was cancelled.", file_);
    }
    const std::string_view line = trimmed(lines_.line());
    if (line.size() < 3 || (line[0] != 'e' && line[0] != 'E') || lowerCase(line.substr(0, 3)) != "end")
        return true;
    return line.size() > 3 && !isBlankOrComment(line.substr(3));
}

Result<void> SmdBlocks::readBlocks(const std::function<Result<void>(const std::string& name)>& read) {
    for (;;) {
        const auto block = nextBlock();
        if (!block)
            return std::unexpected(block.error());
        if (block->empty())
            return {};
        if (auto done = read(*block); !done)
            return done;
    }
}

Result<void> SmdBlocks::readLines(const std::function<Result<void>(std::string_view)>& read) {
    for (;;) {
        const auto inside = nextLine();
        if (!inside)
            return std::unexpected(inside.error());
        if (!*inside)
            return {};
        if (isBlankOrComment(line()))
            continue;
        if (auto done = read(line()); !done)
            return done;
    }
}

Result<void> SmdBlocks::skipBlock() {
    return readLines([](std::string_view) -> Result<void> { return {}; });
}

Result<void> SmdBlocks::readNodes(SmdNodes& nodes) {
    return readLines([&](std::string_view line) { return nodes.addLine(line, file_, number(), faults_); });
}

std::optional<glm::vec3> readVector(Fields& fields) {
    glm::vec3 vector(0.0F);
    for (int i = 0; i < 3; ++i) {
        const auto number = fields.number();
        if (!number)
            return std::nullopt;
        vector[i] = static_cast<float>(*number);
        if (!std::isfinite(vector[i]))
            return std::nullopt;
    }
    return vector;
}

} // namespace prizma
