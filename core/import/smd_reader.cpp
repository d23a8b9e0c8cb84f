#include "core/import/smd_reader.h"

#include "core/import/smd_blocks.h"
#include "core/import/smd_weights.h"

#include <cmath>
#include <optional>
#include <unordered_map>

namespace prizma {
namespace {

/// The material line as a name: all of it, but for a remark set off by two slashes, which no file name has
/// after a space.
std::string_view materialName(std::string_view line) {
    line = trimmed(line);
    for (std::size_t at = 0; (at = line.find("//", at)) != std::string_view::npos; ++at)
        if (at > 0 && (line[at - 1] == ' ' || line[at - 1] == '\t'))
            return trimmed(line.substr(0, at));
    return line;
}

/// Whether `line` begins as that of a vertex does: a whole number and eight numbers.
bool looksLikeVertex(std::string_view line) {
    Fields fields(line);
    if (!fields.integer())
        return false;
    for (int i = 0; i < 8; ++i)
        if (!fields.number())
            return false;
    return true;
}

class SmdReader {
  public:
    SmdReader(std::string_view text, const std::string& file, const ProgressPart& progress)
        : blocks_(text, file, progress) {}

    Result<SmdFile> read() {
        if (auto done = blocks_.readBlocks([this](const std::string& name) { return readBlock(name); });
            !done)
            return std::unexpected(done.error());
        if (!nodesRead_)
            return failure("It is not a whole SMD file: there is no block of nodes.", blocks_.file());
        file_.warnings = blocks_.faults().warnings(blocks_.file());
        return std::move(file_);
    }

  private:
    Result<void> readBlock(const std::string& name) {
        if (name == "nodes")
            return readNodes();
        if (name == "skeleton")
            return readSkeleton();
        if (name == "triangles")
            return readTriangles();
        blocks_.faults().add("The block is not known; it was skipped.", blocks_.number());
        return blocks_.skipBlock();
    }

    Result<void> readNodes() {
        if (nodesRead_)
            return blocks_.error("There is a second block of nodes.");
        if (auto done = blocks_.readNodes(nodes_); !done)
            return done;
        nodesRead_ = true;
        file_.bones = nodes_.order(blocks_.faults());
        return {};
    }

    Result<void> readSkeleton() {
        if (skeletonRead_)
            return blocks_.error("There is a second skeleton block.");
        skeletonRead_ = true;
        return blocks_.readLines([this](std::string_view line) { return readSkeletonLine(line); });
    }

    Result<void> readSkeletonLine(std::string_view line) {
        Fields fields(line);
        if (trimmed(line).starts_with("time")) {
            fields.word();
            const auto time = fields.integer();
            if (!time)
                return blocks_.error("\"time\" needs a whole number.");
            if (file_.frameCount > 0 && *time != lastTime_ + 1LL)
                blocks_.faults().add(
                    "The time numbers skip or repeat; the frames were taken as equally spaced.",
                    blocks_.number());
            lastTime_ = *time;
            ++file_.frameCount;
            return {};
        }
        if (file_.frameCount == 0)
            return blocks_.error("A bone's place must follow a line \"time\".");
        return readKey(fields);
    }

    Result<void> readKey(Fields& fields) {
        const auto id = fields.integer();
        const auto position = readVector(fields);
        const auto angles = readVector(fields);
        if (!id || !position || !angles)
            return blocks_.error("A bone's place needs the bone's number and six finite numbers.");
        if (!fields.atEnd())
            blocks_.faults().add("There is more on the line than a bone's place; it was ignored.",
                                 blocks_.number());
        const auto bone = nodes_.indexOf(*id);
        if (bone)
            file_.keys.push_back(
                {static_cast<std::uint32_t>(file_.frameCount - 1), *bone, *position, *angles});
        else
            blocks_.faults().add("The bone is not among the nodes; its place was ignored.", blocks_.number());
        return {};
    }

    Result<void> readTriangles() {
        if (file_.hasTriangles)
            return blocks_.error("There is a second block of triangles.");
        file_.hasTriangles = true;
        weights_.emplace(nodes_, blocks_.file(), file_.bindings, blocks_.faults());
        for (;;) {
            const auto inside = blocks_.nextLine();
            if (!inside)
                return std::unexpected(inside.error());
            if (!*inside)
                return {};
            // An empty name exists, and so does one that looks like a comment: a vertex follows it.
            if (isBlankOrComment(blocks_.line()) && !looksLikeVertex(blocks_.peek()))
                continue;
            const std::uint32_t material = materialNumber(materialName(blocks_.line()));
            for (int corner = 0; corner < 3; ++corner)
                if (auto done = readCorner(); !done)
                    return done;
            file_.triangleMaterials.push_back(material);
        }
    }

    Result<void> readCorner() {
        do {
            const auto inside = blocks_.nextLine();
            if (!inside)
                return std::unexpected(inside.error());
            if (!*inside)
                return blocks_.error("The triangles end before the last one has its three corners.");
        } while (isBlankOrComment(blocks_.line()));
        Fields fields(blocks_.line());
        const auto bone = fields.integer();
        const auto position = readVector(fields);
        const auto normal = readVector(fields);
        const auto u = fields.number();
        const auto v = fields.number();
        if (!bone || !position || !normal || !u || !v)
            return blocks_.error("A vertex needs a bone's number and eight finite numbers.");
        const glm::vec2 texCoord(*u, *v);
        if (!std::isfinite(texCoord.x) || !std::isfinite(texCoord.y))
            return blocks_.error("The texture coordinates are too large.");
        const auto binding = weights_->read(*bone, fields, blocks_.number());
        if (!binding)
            return std::unexpected(binding.error());
        file_.corners.push_back({*position, *normal, texCoord, *binding});
        return {};
    }

    std::uint32_t materialNumber(std::string_view name) {
        if (!file_.materials.empty() && file_.materials[lastMaterial_] == name)
            return lastMaterial_;
        const auto [found, isNew] =
            materials_.try_emplace(std::string(name), static_cast<std::uint32_t>(file_.materials.size()));
        if (isNew)
            file_.materials.emplace_back(name);
        return lastMaterial_ = found->second;
    }

    SmdBlocks blocks_;
    SmdNodes nodes_;
    SmdFile file_;
    std::optional<SmdWeights> weights_;
    std::unordered_map<std::string, std::uint32_t> materials_;
    std::uint32_t lastMaterial_ = 0;
    int lastTime_ = 0;
    bool nodesRead_ = false, skeletonRead_ = false;
};

} // namespace

Result<SmdFile> readSmd(std::string_view text, const std::string& file, const ProgressPart& progress) {
    return SmdReader(text, file, progress).read();
}

bool isSmdAnimation(std::string_view text) {
    constexpr std::string_view tail = "riangles"; // less common than a t: the search passes most of the text
    for (std::size_t at = 0; (at = text.find(tail, at)) != std::string_view::npos; at += tail.size()) {
        if (at == 0 || (text[at - 1] != 't' && text[at - 1] != 'T'))
            continue;
        std::size_t start = at - 1;
        while (start > 0 && (text[start - 1] == ' ' || text[start - 1] == '\t'))
            --start;
        const bool startsLine = start == 0 || text[start - 1] == '\n' || text[start - 1] == '\r';
        const std::size_t end = at + tail.size();
        const bool isWord = end == text.size() || text[end] == '\n' || text[end] == '\r' ||
                            text[end] == ' ' || text[end] == '\t';
        if (startsLine && isWord)
            return false;
    }
    return true;
}

} // namespace prizma
