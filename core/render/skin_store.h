#pragma once

#include "core/compute/arena.h"
#include "core/scene/mesh.h"
#include "kernels/device_types.h"

namespace prizma {

/// Where what VertexShader needs of a mesh lies in the device's buffers.
struct SkinPlace {
    std::uint32_t vertexBase = 0, quadBase = 0, offsetBase = 0;
    std::size_t vertices = 0, quads = 0, offsets = 0; ///< How many; vertices with the one that ends the list.
};

/// Bind poses, bone weights and morph targets of all meshes that can be posed.
class SkinStore {
  public:
    /// `mesh` deforms.
    Result<SkinPlace> add(Context& context, const Mesh& mesh);
    void release(const SkinPlace& place);

    /// Buffers exist even without meshes.
    Result<void> ensure(Context& context);

    const Buffer<DeviceSkinVertex>& vertices() const { return vertices_.buffer(); }
    const Buffer<DeviceInfluenceQuad>& quads() const { return quads_.buffer(); }
    const Buffer<DeviceMorphOffset>& offsets() const { return offsets_.buffer(); }

  private:
    Arena<DeviceSkinVertex> vertices_{"bind pose"};
    Arena<DeviceInfluenceQuad> quads_{"bone weights"};
    Arena<DeviceMorphOffset> offsets_{"morph targets"};
};

} // namespace prizma
