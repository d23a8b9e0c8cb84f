#pragma once

#include "core/scene/properties.h"
#include "core/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace prizma {

/// Edits of a whole scene that need more than setting one property. Ids that the scene does not have are
/// passed over.

/// Removes objects, lights, materials and groups with all that is in them; whatever else is in `entities`
/// stays. Objects that used a removed
/// material get the material "default", which is made if need be. Gives the number of things removed.
int removeEntities(Scene& scene, std::span<const EntityRef> entities);

/// Copies objects (beside the original), lights, materials, and groups with all that is in them; gives the
/// copies in the order of the originals. What is in a group that is copied too is not copied once more.
std::vector<EntityRef> duplicateEntities(Scene& scene, std::span<const EntityRef> entities);

/// Gives an object, light, material or group a name that is unique among its kind: "bunny" becomes "bunny 2" if
/// another one is called so. Errors: nothing but spaces, or a thing that has no name.
Result<void> renameEntity(Scene& scene, EntityRef entity, const std::string& name);

/// Adds a primitive where the camera looks, standing on the ground, of a size that suits the view.
Id addPrimitive(Scene& scene, PrimitiveType type);

/// Adds a light above the point that the camera looks at, as bright as suits the distance.
Id addLight(Scene& scene, LightType type);

/// Adds a material with default values.
Id addMaterial(Scene& scene);

/// Gives the objects `material` in one slot, or in all slots if `slot` is negative.
void assignMaterial(Scene& scene, std::span<const Id> objects, int slot, Id material);

/// Whether `bounds` can be made out in the camera's picture: its middle is inside and it is neither a speck
/// nor so large that one sees only a part of it. `aspect` is width / height.
bool isWellInView(const Camera& camera, const DBounds& bounds, double aspect);

} // namespace prizma
