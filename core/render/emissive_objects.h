#pragma once

#include "core/render/light_bounds.h"
#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <functional>
#include <vector>

namespace prizma {

/// A drawn object with a material that shines, and all that its emitters depend on.
struct EmissiveObject {
    /// What a material slot's triangles give. 0 radiance: nothing.
    struct Slot {
        glm::dvec3 radiance{0.0};
        ImagePtr texture;      ///< Multiplies it.
        bool bothSides = true; ///< As surfaceAt in kernels/surface.clh has it.

        bool shines() const { return glm::dot(radiance, glm::dvec3(1.0)) > 0.0; }
        friend bool operator==(const Slot&, const Slot&) = default;
    };

    Id id = noId;
    MeshPtr mesh;
    glm::dmat4 toWorld{1.0};
    bool posed = false; ///< Its vertices are where the device's kernels put them.
    std::vector<Slot> slots;

    friend bool operator==(const EmissiveObject&, const EmissiveObject&) = default;
};

/// The drawn objects that shine, in the scene's order. Equal lists have equal emitters. Costs next to nothing
/// for a scene whose materials do not shine.
std::vector<EmissiveObject> emissiveObjects(const Scene& scene);

/// Triangles of `objects` that shine, and how the light tree sees each; `objects` is indexed by
/// DeviceEmitter::object.
struct Emitters {
    std::vector<DeviceEmitter> triangles;
    std::vector<LightBounds> bounds;
};

/// Relative to `anchor`. `meanOf` gives a picture's mean factor. Importance is taken from the bind pose;
/// triangles without an area that can get none are left out.
Emitters collectEmitters(const std::vector<EmissiveObject>& objects, const glm::dvec3& anchor,
                         const std::function<double(const ImagePtr&)>& meanOf);

} // namespace prizma
