#pragma once

#include "core/scene/properties.h"
#include "core/scene/scene.h"

#include <unordered_map>
#include <vector>

namespace prizma {

/// What hangs under what: a scene's groups, and what they make of their members. Made once, in time
/// proportional to the number of groups, and then asked for as many members as one likes; an edit of the
/// groups leaves it behind.
class Hierarchy {
  public:
    explicit Hierarchy(const Scene& scene);

    /// From the space of a group to world space: the product of its own transform and all its parents'. The
    /// identity for noId and for a group that does not exist. Parents that run in a circle count as none.
    const glm::dmat4& toWorld(Id group) const;

    /// Whether neither the group nor any above it is hidden.
    bool shows(Id group) const;

    /// Whether `group` is `ancestor` or hangs under it, however deep.
    bool isWithin(Id group, Id ancestor) const;

    /// From the object's own space to world space.
    glm::dmat4 worldMatrix(const Object& object) const;

    /// Visible itself and not hidden by a group.
    bool isShown(const Object& object) const { return object.visible && shows(object.parent); }

  private:
    struct Node {
        Id parent = noId;
        glm::dmat4 toWorld{1.0};
        bool shows = true;
    };
    const Node* find(Id group) const;

    std::unordered_map<Id, Node> nodes_;
};

/// For a single object; who asks for many makes a Hierarchy.
glm::dmat4 worldMatrix(const Scene& scene, const Object& object);
bool isShown(const Scene& scene, const Object& object);

/// The light as `toWorld` leaves it. Its place and direction follow exactly. A sphere grows as its volume
/// does; a rectangle keeps its plane and area, so that under a shear, which makes a parallelogram of it, its
/// second edge is turned back to a right angle. Strengths and a spot's angles stay.
Light transformed(Light light, const glm::dmat4& toWorld);

/// The scene's lights as they shine, in its order: in world space and of no group, off where a group hides
/// them or where a light other than they is solo.
std::vector<Light> lightsInWorld(const Scene& scene);

const Group* findGroup(const Scene& scene, Id id);

/// Appends a copy with a new id and a name that no other group has.
Id addGroup(Scene& scene, Group item);

/// The group that an object, a light or a group hangs under; noId for none and for all else.
Id parentOf(const Scene& scene, EntityRef entity);

/// What hangs directly under `group`, or under none if it is noId: groups, objects, lights.
std::vector<EntityRef> membersOf(const Scene& scene, Id group);

} // namespace prizma
