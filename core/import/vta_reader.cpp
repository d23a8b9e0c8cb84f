#include "core/import/vta_reader.h"

#include "core/import/smd_blocks.h"

#include <algorithm>
#include <map>

namespace prizma {
namespace {

class VtaReader {
  public:
    VtaReader(std::string_view text, const std::string& file, const ProgressPart& progress)
        : blocks_(text, file, progress) {}

    Result<VtaFile> read() {
        if (auto done = blocks_.readBlocks([this](const std::string& name) { return readBlock(name); });
            !done)
            return std::unexpected(done.error());
        if (file_.frames.empty())
            return failure("It is not a VTA file: there is no vertex animation in it.", blocks_.file());
        for (VtaFrame& frame : file_.frames)
            finish(frame);
        file_.warnings = blocks_.faults().warnings(blocks_.file());
        return std::move(file_);
    }

  private:
    Result<void> readBlock(const std::string& name) {
        if (name == "skeleton")
            return readSkeleton();
        if (name == "vertexanimation")
            return readVertices();
        return blocks_.skipBlock();
    }

    /// The number behind "time"; `fields` stands behind the word.
    Result<int> readTime(Fields& fields) {
        const auto time = fields.integer();
        if (!time)
            return blocks_.error("\"time\" needs a whole number.");
        return *time;
    }

    /// Exporters name the shapes in remarks: time 3 # smile.
    Result<void> readSkeleton() {
        return blocks_.readLines([this](std::string_view line) -> Result<void> {
            Fields fields(line);
            if (fields.word() != "time")
                return {};
            const auto time = readTime(fields);
            if (!time)
                return std::unexpected(time.error());
            std::string_view remark = fields.rest();
            while (!remark.empty() &&
                   std::string_view("#;/ \t").find(remark.front()) != std::string_view::npos)
                remark.remove_prefix(1);
            if (!remark.empty())
                names_.try_emplace(*time, remark);
            return {};
        });
    }

    Result<void> readVertices() {
        return blocks_.readLines([this](std::string_view line) -> Result<void> {
            Fields fields(line);
            if (trimmed(line).starts_with("time")) {
                fields.word();
                const auto time = readTime(fields);
                if (!time)
                    return std::unexpected(time.error());
                file_.frames.push_back({{}, *time, {}});
                return {};
            }
            if (file_.frames.empty())
                return blocks_.error("A vertex must follow a line \"time\".");
            const auto id = fields.integer();
            const auto position = readVector(fields);
            const auto normal = readVector(fields);
            if (!id || !position || !normal)
                return blocks_.error("A vertex needs a number and six finite numbers.");
            file_.frames.back().vertices.push_back({*id, *position, *normal});
            return {};
        });
    }

    void finish(VtaFrame& frame) const {
        if (const auto name = names_.find(frame.time); name != names_.end())
            frame.name = name->second;
        std::ranges::stable_sort(frame.vertices, {}, &VtaVertex::id);
        const auto sameId = [](const VtaVertex& a, const VtaVertex& b) { return a.id == b.id; };
        frame.vertices.erase(std::unique(frame.vertices.begin(), frame.vertices.end(), sameId),
                             frame.vertices.end());
    }

    SmdBlocks blocks_;
    VtaFile file_;
    std::map<int, std::string> names_;
};

} // namespace

Result<VtaFile> readVta(std::string_view text, const std::string& file, const ProgressPart& progress) {
    return VtaReader(text, file, progress).read();
}

} // namespace prizma
