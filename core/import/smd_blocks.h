#pragma once

#include "core/import/fault_tally.h"
#include "core/import/smd_nodes.h"
#include "core/import/text_fields.h"
#include "core/progress.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace prizma {

/// What SMD and VTA files have in common: a version, then blocks of lines that begin with a word and close
/// with "end".
class SmdBlocks {
  public:
    SmdBlocks(std::string_view text, std::string file, const ProgressPart& progress)
        : lines_(text), file_(std::move(file)), progress_(progress) {}

    /// Goes to the next block and gives its name in lower case; an empty name at the end of the text. Errors:
    /// the text does not begin as such a file does.
    Result<std::string> nextBlock();

    /// Calls `read` with the name of every block, after going to it. Errors: those of nextBlock and of
    /// `read`.
    Result<void> readBlocks(const std::function<Result<void>(const std::string& name)>& read);

    /// Calls `read` for every line of the block with something on it, but not for its "end". Errors: those of
    /// `read`, no end, cancelled.
    Result<void> readLines(const std::function<Result<void>(std::string_view line)>& read);

    Result<void> skipBlock();

    /// Reads the block of bones.
    Result<void> readNodes(SmdNodes& nodes);

    /// One line on. False where the block's end has been reached. Errors: no end, cancelled.
    Result<bool> nextLine();

    std::string_view line() const { return lines_.line(); }
    std::string_view peek() const { return lines_.peek(); }
    int number() const { return lines_.number(); }

    const std::string& file() const { return file_; }
    FaultTally& faults() { return faults_; }

    std::unexpected<Diagnostic> error(std::string message) const {
        return failure(std::move(message), file_, lines_.number());
    }

  private:
    Result<void> checkVersion(Fields& fields);

    LineReader lines_;
    std::string file_;
    ProgressPart progress_;
    FaultTally faults_;
    std::string block_; ///< The present one's name and line, for the message that it does not end.
    int blockLine_ = 0;
    bool begun_ = false, versionKnown_ = false;
};

/// The next three fields as finite floats.
std::optional<glm::vec3> readVector(Fields& fields);

} // namespace prizma
