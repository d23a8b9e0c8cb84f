#pragma once

#include "core/bvh/device_layout.h"
#include "core/render/geometry_store.h"
#include "core/render/material_store.h"
#include "core/scene/scene.h"

namespace prizma {

/// The drawn objects as instances, relative to an anchor, and the top-level tree over them.
class InstanceStore {
  public:
    explicit InstanceStore(TreeLayout layout) : layout_(layout) {}

    /// Takes all drawn objects whose geometry is on the device. Objects that are squashed flat (a scale of
    /// zero) or whose transform is no number are left out.
    Result<void> update(Context& context, const Scene& scene, const GeometryStore& geometry,
                        const MaterialStore& materials, const glm::dvec3& anchor);

    std::uint32_t count() const { return static_cast<std::uint32_t>(objects_.size()); }
    Id objectOf(std::uint32_t instance) const { return objects_[instance]; }
    std::uint64_t triangleCount() const { return triangleCount_; }
    double radius() const { return radius_; } ///< Of a ball about everything; 1 if there is nothing.

    const Buffer<DeviceInstance>& instances() const { return instances_; }
    const Buffer<std::uint32_t>& slots() const { return slots_; }
    cl_mem topNodes() const;

  private:
    void append(const Object& object, const glm::dmat4& toWorld, const ObjectPlace& place,
                const MaterialStore& materials, const glm::dvec3& anchor);
    Result<void> buildTop(Context& context);

    const TreeLayout layout_;
    Buffer<DeviceInstance> instances_;
    Buffer<std::uint32_t> slots_;
    Buffer<WideNode> wideNodes_;
    Buffer<BinaryNode> binaryNodes_;
    std::vector<Id> objects_;
    std::uint64_t triangleCount_ = 0;
    double radius_ = 1.0;

    // Filled while updating.
    std::vector<DeviceInstance> instanceTable_;
    std::vector<std::uint32_t> slotTable_;
    std::vector<Bounds> boxes_;
};

} // namespace prizma
