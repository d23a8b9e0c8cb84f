#include "core/import/smd_nodes.h"

#include "core/import/text_fields.h"

#include <algorithm>

namespace prizma {

Result<void> SmdNodes::addLine(std::string_view line, const std::string& file, int number,
                               FaultTally& faults) {
    Fields fields(line);
    const auto id = fields.integer();
    const auto name = fields.word();
    const auto parent = fields.integer();
    if (!id || !name || !parent)
        return failure("A bone needs a number, a name in quotes and its parent's number.", file, number);
    if (!fields.atEnd())
        faults.add("There is more on the bone's line than was expected; it was ignored.", number);
    nodes_.push_back({*id, std::string(*name), *parent, number});
    return {};
}

/// The parent of each node as an index of `nodes_`, which is sorted by id here.
std::vector<int> SmdNodes::parentIndices(FaultTally& faults) const {
    std::vector<int> parents(nodes_.size(), -1);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].parentId == -1)
            continue;
        const auto found = std::ranges::lower_bound(nodes_, nodes_[i].parentId, {}, &Node::id);
        if (found != nodes_.end() && found->id == nodes_[i].parentId)
            parents[i] = static_cast<int>(found - nodes_.begin());
        else
            faults.add("The bone's parent does not exist; the bone was made a root.", nodes_[i].line);
    }
    return parents;
}

std::vector<SmdBone> SmdNodes::order(FaultTally& faults) {
    std::ranges::stable_sort(nodes_, {}, &Node::id);
    const auto repeated = [&](const Node& node) {
        const bool again = &node != nodes_.data() && (&node - 1)->id == node.id;
        if (again)
            faults.add("The bone's number was given before; this bone was ignored.", node.line);
        return again;
    };
    std::vector<Node> unique;
    for (const Node& node : nodes_)
        if (!repeated(node))
            unique.push_back(node);
    nodes_ = std::move(unique);

    enum class State : std::uint8_t { Unseen, Open, Done };
    std::vector<int> parents = parentIndices(faults);
    std::vector<State> states(nodes_.size(), State::Unseen);
    std::vector<int> places(nodes_.size(), -1);
    std::vector<SmdBone> bones;
    std::vector<std::size_t> branch; // from a bone up to the first ancestor that has its place
    for (std::size_t start = 0; start < nodes_.size(); ++start) {
        for (int at = static_cast<int>(start);
             at >= 0 && states[static_cast<std::size_t>(at)] != State::Done;) {
            const auto node = static_cast<std::size_t>(at);
            if (states[node] == State::Open) {
                faults.add("The bone is its own ancestor; it was made a root.", nodes_[branch.back()].line);
                parents[branch.back()] = -1;
                break;
            }
            states[node] = State::Open;
            branch.push_back(node);
            at = parents[node];
        }
        for (; !branch.empty(); branch.pop_back()) {
            const std::size_t node = branch.back();
            states[node] = State::Done;
            places[node] = static_cast<int>(bones.size());
            indices_.emplace_back(nodes_[node].id, static_cast<std::uint32_t>(bones.size()));
            const int parent = parents[node];
            bones.push_back(
                {std::move(nodes_[node].name), parent < 0 ? -1 : places[static_cast<std::size_t>(parent)]});
        }
    }
    std::ranges::sort(indices_);
    return bones;
}

std::optional<std::uint32_t> SmdNodes::indexOf(int id) const {
    const auto found = std::ranges::lower_bound(indices_, id, {}, &std::pair<int, std::uint32_t>::first);
    if (found == indices_.end() || found->first != id)
        return std::nullopt;
    return found->second;
}

} // namespace prizma
