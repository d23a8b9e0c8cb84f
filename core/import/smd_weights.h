#pragma once

#include "core/import/fault_tally.h"
#include "core/import/smd_nodes.h"
#include "core/import/text_fields.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace prizma {

/// Turns the bone weights of vertex lines into bindings. A list of weights that sums to less than 1 leaves
/// the rest to the line's first bone, or to the first root where that one does not exist.
class SmdWeights {
  public:
    SmdWeights(const SmdNodes& nodes, std::string file, SmdBindings& bindings, FaultTally& faults)
        : nodes_(nodes), file_(std::move(file)), bindings_(bindings), faults_(faults) {}

    /// The binding of a vertex whose line begins with `firstBone`; `fields` stands behind the texture
    /// coordinates.
    Result<std::uint32_t> read(int firstBone, Fields& fields, int line);

  private:
    Result<void> readLinks(int count, Fields& fields, int line);
    Result<void> complete(int firstBone, int line);
    std::uint32_t binding();

    const SmdNodes& nodes_;
    std::string file_;
    SmdBindings& bindings_;
    FaultTally& faults_;
    std::vector<BoneInfluence> list_; ///< Of the present line.
    std::unordered_map<std::string, std::uint32_t> known_;
    std::string key_; ///< The last list, as it is known.
    std::uint32_t last_ = 0;
};

} // namespace prizma
