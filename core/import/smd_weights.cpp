#include "core/import/smd_weights.h"

#include <algorithm>

namespace prizma {
namespace {

/// Written weights are rounded: so much may be missing without being meant for another bone.
constexpr double roundingOfWeights = 1.5e-3;

} // namespace

Result<std::uint32_t> SmdWeights::read(int firstBone, Fields& fields, int line) {
    list_.clear();
    if (!fields.atEnd()) {
        const auto count = fields.integer();
        if (!count || *count < 0)
            return failure("The number of bone weights must be a whole number from 0 up.", file_, line);
        if (auto done = readLinks(*count, fields, line); !done)
            return std::unexpected(done.error());
        if (!fields.atEnd())
            faults_.add("There is more on the vertex's line than was expected; it was ignored.", line);
    }
    if (auto done = complete(firstBone, line); !done)
        return std::unexpected(done.error());
    return binding();
}

Result<void> SmdWeights::readLinks(int count, Fields& fields, int line) {
    for (int i = 0; i < count; ++i) {
        if (fields.atEnd())
            return failure("The vertex announces " + std::to_string(count) + " bone weights, but only " +
                               std::to_string(i) + " follow.",
                           file_, line);
        const auto bone = fields.integer();
        const auto weight = fields.number();
        if (!bone || !weight)
            return failure("A bone weight needs a bone's number and a finite number.", file_, line);
        const auto index = nodes_.indexOf(*bone);
        if (!index)
            return failure("The vertex is bound to bone " + std::to_string(*bone) +
                               ", which is not among the nodes.",
                           file_, line);
        if (*weight < 0.0)
            faults_.add("A bone weight is negative; it was ignored.", line);
        if (*weight > 0.0)
            list_.push_back({*index, static_cast<float>(std::min(*weight, 1e6))});
    }
    return {};
}

/// Adds what is missing and normalises.
Result<void> SmdWeights::complete(int firstBone, int line) {
    double sum = 0.0;
    for (const BoneInfluence& influence : list_)
        sum += influence.weight;
    if (sum < 1.0 - roundingOfWeights) {
        auto rest = nodes_.indexOf(firstBone);
        if (!rest && list_.empty())
            return failure("The vertex is bound to bone " + std::to_string(firstBone) +
                               ", which is not among the nodes.",
                           file_, line);
        if (!rest) {
            faults_.add("The weights sum to less than 1 and the bone for the rest does not exist; "
                        "the root took it.",
                        line);
            rest = 0;
        }
        list_.push_back({*rest, static_cast<float>(1.0 - sum)});
        sum = 1.0;
    } else if (sum > 1.0 + roundingOfWeights) {
        faults_.add("The weights sum to more than 1; they were scaled down.", line);
    }
    std::ranges::sort(list_, {}, &BoneInfluence::bone);
    std::size_t kept = 0;
    for (const BoneInfluence& influence : list_) { // kept never overtakes it
        const BoneInfluence part{influence.bone, static_cast<float>(influence.weight / sum)};
        if (kept > 0 && list_[kept - 1].bone == part.bone)
            list_[kept - 1].weight += part.weight;
        else
            list_[kept++] = part;
    }
    list_.resize(kept);
    return {};
}

std::uint32_t SmdWeights::binding() {
    const std::string_view bytes(reinterpret_cast<const char*>(list_.data()),
                                 list_.size() * sizeof(BoneInfluence));
    if (bindings_.size() > 0 && bytes == key_) // neighbours often have the same
        return last_;
    key_ = bytes;
    const auto [found, isNew] = known_.try_emplace(key_, static_cast<std::uint32_t>(bindings_.size()));
    if (isNew)
        bindings_.add(list_);
    last_ = found->second;
    return last_;
}

} // namespace prizma
