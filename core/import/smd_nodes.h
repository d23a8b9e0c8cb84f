#pragma once

#include "core/import/fault_tally.h"
#include "core/import/smd_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prizma {

/// The nodes block of SMD and VTA files: bones by number, in any order, with gaps.
class SmdNodes {
  public:
    /// Takes in a line: id "name" parent.
    Result<void> addLine(std::string_view line, const std::string& file, int number, FaultTally& faults);

    /// After the last line: the bones, parents before children. A parent that does not exist, or that is the
    /// bone's own descendant, makes it a root.
    std::vector<SmdBone> order(FaultTally& faults);

    /// Index among the ordered bones.
    std::optional<std::uint32_t> indexOf(int id) const;

  private:
    struct Node {
        int id;
        std::string name;
        int parentId;
        int line;
    };

    std::vector<int> parentIndices(FaultTally& faults) const;

    std::vector<Node> nodes_;
    std::vector<std::pair<int, std::uint32_t>> indices_; ///< By id.
};

} // namespace prizma
