#pragma once

#include "core/render/geometry_store.h"
#include "core/render/kernel_set.h"
#include "core/render/render_plan.h"

#include <vector>

namespace prizma {

/// The stages Poses and VertexShader: evaluates objects' poses on the host and brings their vertices into
/// them on the device. However many objects move, their matrices go up together and one launch does all
/// vertices.
class MeshPoser {
  public:
    /// Poses: uploads the skinning matrices and morph weights of `objects` at the scene's time, and notes in
    /// `poses` what they stand for.
    Result<void> pose(Context& context, const Scene& scene, const std::vector<Id>& objects,
                      std::map<Id, PoseKey>& poses);

    /// VertexShader, for the objects that were posed last. Does not wait.
    Result<void> shadeVertices(Context& context, KernelSet& kernels, const GeometryStore& geometry);

  private:
    /// One object in the tables of this frame.
    struct Part {
        Id object = noId;
        std::uint32_t boneBase = 0;
        std::uint32_t weightBase = PRIZMA_NO_WEIGHTS;

        friend bool operator==(const Part&, const Part&) = default;
    };

    Result<void> loadBlocks(Context& context, const GeometryStore& geometry);

    std::vector<Part> parts_;
    std::vector<glm::mat4> matrices_; ///< Of all parts, one after the other.
    std::vector<float> weights_;
    Buffer<glm::mat4> deviceMatrices_;
    Buffer<float> deviceWeights_;

    /// What is on the device stays there while the parts are the same.
    std::vector<Part> blocksOf_;
    std::uint64_t blocksRevision_ = 0;
    std::size_t blockCount_ = 0;
    Buffer<DeviceVertexBlock> blocks_;
};

} // namespace prizma
