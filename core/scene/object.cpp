#include "core/scene/object.h"

namespace prizma {

DBounds worldBounds(const Object& object) {
    DBounds bounds;
    if (!object.mesh || object.mesh->bounds.isEmpty())
        return bounds;
    const glm::dmat4 toWorld = object.transform.matrix();
    const Bounds& box = object.mesh->bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point{(corner & 1) != 0 ? box.high.x : box.low.x,
                               (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z, 1.0};
        bounds.add(glm::dvec3(toWorld * point));
    }
    return bounds;
}

} // namespace prizma
