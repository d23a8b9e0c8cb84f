#include "core/scene/object.h"

namespace prizma {

DBounds transformed(const Bounds& box, const glm::dmat4& toWorld) {
    DBounds bounds;
    if (box.isEmpty())
        return bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point{(corner & 1) != 0 ? box.high.x : box.low.x,
                               (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z, 1.0};
        bounds.add(glm::dvec3(toWorld * point));
    }
    return bounds;
}

DBounds bindPoseBounds(const Object& object) {
    return object.mesh ? transformed(object.mesh->bounds, object.transform.matrix()) : DBounds();
}

} // namespace prizma
