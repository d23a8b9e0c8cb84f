#include "core/project/group_links.h"

#include <unordered_map>

namespace prizma {
namespace {

using Parents = std::unordered_map<Id, Id>;

/// Whether `group` is `member` or hangs under it.
bool closesCircle(const Parents& parents, Id member, Id group) {
    while (group != noId) {
        if (group == member)
            return true;
        const auto above = parents.find(group);
        group = above == parents.end() ? noId : above->second;
    }
    return false;
}

template <class T>
void setParents(CowList<T>& list, const Parents& parents) {
    if (list.empty() || parents.empty())
        return;
    for (T& item : list.edit())
        if (const auto parent = parents.find(item.id); parent != parents.end())
            item.parent = parent->second;
}

} // namespace

std::vector<GroupLinks::Fault> GroupLinks::apply(Scene& scene) const {
    std::vector<Fault> faults;
    std::unordered_map<std::string, Id> named;
    for (const Group& group : scene.groups)
        named.emplace(group.name, group.id);
    Parents parents;
    for (const Link& link : wanted_) {
        const auto found = named.find(link.group);
        if (found == named.end())
            faults.push_back({"There is no group \"" + link.group + "\".", link.place});
        else if (closesCircle(parents, link.member.id, found->second))
            faults.push_back(
                {"A group cannot hang under itself; \"" + link.group + "\" is left out as its parent.",
                 link.place});
        else
            parents[link.member.id] = found->second;
    }
    setParents(scene.groups, parents);
    setParents(scene.objects, parents);
    setParents(scene.lights, parents);
    return faults;
}

} // namespace prizma
