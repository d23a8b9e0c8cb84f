#pragma once

#include "core/scene/properties.h"

#include <string>
#include <utility>
#include <vector>

namespace prizma {

/// What a project file says about who hangs under which group, by name. Names may refer to groups that come
/// later in the file, so that links are made once everything is read.
class GroupLinks {
  public:
    /// `place`: where in the file it says so.
    void want(EntityRef member, std::string group, std::string place) {
        wanted_.push_back({member, std::move(group), std::move(place)});
    }

    struct Fault {
        std::string message;
        std::string place;
    };

    /// Gives objects, lights and groups their parents. A name that no group has, and a link that would close
    /// a circle, are left out and told.
    std::vector<Fault> apply(Scene& scene) const;

  private:
    struct Link {
        EntityRef member;
        std::string group;
        std::string place;
    };
    std::vector<Link> wanted_;
};

} // namespace prizma
