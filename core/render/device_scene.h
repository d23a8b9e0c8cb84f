#pragma once

#include "core/bvh/tree_store.h"
#include "core/render/geometry_store.h"
#include "core/render/instance_store.h"
#include "core/render/kernel_set.h"
#include "core/render/light_store.h"
#include "core/render/material_store.h"
#include "core/render/mesh_poser.h"
#include "core/render/render_plan.h"
#include "core/render/tree_refitter.h"
#include "core/render/worn_trees.h"

namespace prizma {

/// A scene on a device: geometry, materials, lights, instances. The part of a plan up to the top level.
class DeviceScene {
  public:
    /// `renewTrees`: whether trees that refitting has worn out are built anew.
    DeviceScene(Context& context, KernelSet& kernels, TreeLayout layout, bool renewTrees)
        : context_(context),
          kernels_(kernels),
          renewTrees_(renewTrees),
          geometry_(layout),
          instances_(layout) {}

    /// Runs one stage of `plan` for `scene`. All trees that Geometry needs are in `trees`, ready.
    Result<void> run(const PlannedStage& stage, const Scene& scene, const glm::dvec3& anchor,
                     TreeStore& trees, DeviceState& state);

    /// Releases the geometry of all other objects.
    void removeAllBut(const std::set<Id>& objects);

    /// Posed objects for which a better tree is ready; `inWork` gets the meshes whose trees the store has to
    /// keep.
    std::set<Id> newTrees(TreeStore& trees, std::vector<MeshPtr>& inWork);

    /// Makes every buffer exist, so that kernels can be launched even for an empty scene.
    Result<void> ensure();

    /// Sets the kernel's first arguments: SCENE_PARAMETERS of kernels/scene.clh.
    void setSceneArguments(Kernel& kernel) const;

    /// A posed object's vertices as VertexShader left them, in object space. Waits for the device. Errors:
    /// the object is not posed on the device.
    Result<std::vector<glm::vec3>> posedPositions(Id object) const;

    /// Any object's vertices as they are on the device, in object space. Waits for it.
    Result<ObjectVertices> vertices(Id object) const;

    /// PosedPlace::wear of the most worn tree; 1 if no object is posed.
    double treeWear() const;

    const InstanceStore& instances() const { return instances_; }
    const MaterialStore& materials() const { return materials_; }
    const LightStore& lights() const { return lights_; }

  private:
    Result<void> uploadGeometry(const PlannedStage& stage, const Scene& scene, TreeStore& trees,
                                DeviceState& state);
    Result<void> updateTopLevel(const Scene& scene, const glm::dvec3& anchor);
    Result<void> refit(const PlannedStage& stage, TreeStore& trees);
    Result<void> replaceTrees(const PlannedStage& stage, TreeStore& trees, DeviceState& state);

    Context& context_;
    KernelSet& kernels_;
    const bool renewTrees_;
    GeometryStore geometry_;
    MaterialStore materials_;
    LightStore lights_;
    InstanceStore instances_;
    MeshPoser poser_;
    TreeRefitter refitter_;
    WornTrees wornTrees_;
};

} // namespace prizma
