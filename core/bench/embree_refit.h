#pragma once

#include "core/scene/mesh.h"

#include <memory>
#include <span>
#include <vector>

namespace prizma::bench {

/// Embree's trees over deforming meshes, to compare with: a dynamic scene of geometries of refit quality.
class EmbreeRefit {
  public:
    /// Builds the trees. Null if this program was built without Embree.
    static std::unique_ptr<EmbreeRefit> create(const std::vector<MeshPtr>& meshes);

    virtual ~EmbreeRefit() = default;

    /// Gives each mesh new vertices, then refits all trees. Milliseconds of the refit: marking the buffers
    /// as changed and committing; putting the vertices into the buffers, which Embree shares, is not in it.
    virtual double refit(std::span<const std::vector<glm::vec3>> positions) = 0;
};

} // namespace prizma::bench
