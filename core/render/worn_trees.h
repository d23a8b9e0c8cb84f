#pragma once

#include "core/bvh/tree_store.h"
#include "core/render/geometry_store.h"

#include <chrono>
#include <map>
#include <set>
#include <vector>

namespace prizma {

/// Refitting keeps a tree right but not good: when parts of a mesh fly apart, boxes that held neighbours grow
/// and overlap. This has the trees of posed objects that have worn out so built anew, in the background, for
/// the pose they are in. Until a new one is ready the old one serves.
class WornTrees {
  public:
    /// A tree that costs more than this many times what it cost when built is worn out.
    static constexpr double limit = 1.5;

    /// Called after `objects` were refitted; starts builds. Reads back the vertices of those it starts one
    /// for.
    Result<void> watch(Context& context, const GeometryStore& geometry, const std::vector<Id>& objects,
                       TreeStore& trees);

    /// Objects whose new tree is ready. Forgets those that have gone or changed meanwhile.
    std::set<Id> ready(const GeometryStore& geometry, TreeStore& trees);

    /// The posed meshes whose trees are being built or wait: the tree store has to keep them.
    std::vector<MeshPtr> meshes() const;

    /// Puts an object's new tree in place of the old one. If the device has no room for it, the old one
    /// stays.
    Result<void> replace(Context& context, GeometryStore& geometry, Id object, TreeStore& trees);

  private:
    using Clock = std::chrono::steady_clock;

    struct Renewal {
        MeshPtr posed;      ///< Null between two builds.
        DeviceTreePtr worn; ///< The tree that it is to replace.
        Clock::time_point started;
        Clock::time_point pausedUntil; ///< An object in wild motion shall not keep all cores building.
    };

    std::map<Id, Renewal> renewals_;
};

} // namespace prizma
