#pragma once

#include "core/compute/buffer.h"
#include "core/compute/kernel.h"
#include "core/render/emissive_objects.h"
#include "core/render/instance_store.h"
#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <map>

namespace prizma {

/// Lights on the device: their table, the tree over them and the triangles that shine, the background's
/// table, and how often each is chosen.
class LightStore {
  public:
    /// The lights that are on, relative to `anchor`.
    Result<void> updateLights(Context& context, const Scene& scene, const glm::dvec3& anchor);

    /// The tree over the lights of the table and all triangles that shine.
    Result<void> updateTree(Context& context, const Scene& scene, const InstanceStore& instances,
                            const glm::dvec3& anchor);

    /// How the background is sampled. Its table is made anew only for another picture.
    Result<void> updateBackground(Context& context, const Scene& scene);

    /// Tells the triangles that shine which instance they belong to. Due whenever instances have changed;
    /// costs nothing where nothing shines.
    Result<void> updateInstances(Context& context, const InstanceStore& instances);

    /// Adds the arguments of SCENE_PARAMETERS from `lights` on.
    void addArguments(Kernel& kernel) const;

    /// Makes every buffer exist, even without lights.
    Result<void> ensure(Context& context);

    const Buffer<DeviceLight>& lights() const { return lights_; }
    std::uint32_t lightCount() const { return static_cast<std::uint32_t>(table_.size()); }
    std::uint32_t emitterCount() const { return set_.emitterCount; } ///< Triangles that shine.
    std::uint32_t treeSize() const { return set_.nodeCount; }        ///< Nodes of the light tree.

  private:
    double meanOf(const ImagePtr& image);
    Result<void> uploadLeaves(Context& context, const std::vector<std::uint32_t>& leafOf,
                              const std::vector<std::uint32_t>& treeLights, const Emitters& emitters);
    Result<void> updateFarLights(Context& context);

    Buffer<DeviceLight> lights_;
    Buffer<DeviceLightNode> nodes_;
    Buffer<DeviceEmitter> emitters_;
    Buffer<std::uint32_t> emitterIndex_;
    Buffer<std::uint32_t> emitterLeaves_;
    Buffer<DeviceFarLight> farLights_;
    Buffer<float> environment_;
    DeviceLightSet set_{};

    std::vector<DeviceLight> table_;
    std::vector<EmissiveObject> objects_;     ///< Those that shine,
    std::vector<std::uint32_t> leafBases_;    ///< and where their triangles' leaves begin.
    std::vector<std::uint32_t> indexTable_;   ///< What emitterIndex_ holds.
    ImagePtr environmentImage_;               ///< The picture that the table is of.
    double environmentMean_ = 0.0;            ///< Of that picture.
    double backgroundIrradiance_ = 0.0;       ///< About what the background gives; 0: none.
    std::map<ImagePtr, double> textureMeans_; ///< Of the emission textures in use.
};

} // namespace prizma
