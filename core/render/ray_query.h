#pragma once

#include "core/bvh/device_layout.h"
#include "core/diagnostic.h"
#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace prizma {

enum class RayQueryMode {
    Closest,       ///< One ray a work item.
    ClosestPacket, ///< Sixteen rays a work item, for coherent rays; the same hits.
    Any,           ///< Occlusion: only `Hit::t` counts, below infinity if something is in the way.
    AnyPacket,     ///< Occlusion, sixteen rays a work item.
};

constexpr bool isOcclusion(RayQueryMode mode) {
    return mode == RayQueryMode::Any || mode == RayQueryMode::AnyPacket;
}

/// The tracing kernels by themselves: any rays against a scene, for tests, benchmarks and picking.
/// Rays and hits are in world space relative to `origin()`; Hit::instance is the index of the object among
/// the visible objects that have a mesh.
class RayQuery {
  public:
    /// `layout`: nothing lets the device's kind choose. Errors: no such device, kernels that do not build, no
    /// memory.
    static Result<RayQuery> create(const Scene& scene, const std::string& deviceId = {},
                                   std::optional<TreeLayout> layout = std::nullopt);
    RayQuery(RayQuery&&) noexcept;
    RayQuery& operator=(RayQuery&&) noexcept;
    ~RayQuery();

    /// The world position that rays and hits are relative to.
    glm::dvec3 origin() const;

    std::string deviceName() const;

    TreeLayout layout() const;

    /// What the scene's buffers take on the device.
    std::uint64_t deviceBytes() const;

    /// RenderStatistics::treeWear: how much worse than when built the most worn of the refitted trees is.
    double treeWear() const;

    /// Puts the rays on the device once, so that repeated `trace` calls measure tracing only.
    Result<void> setRays(std::span<const DeviceRay> rays);

    /// Traces all rays; gives the kernel's own time in milliseconds (OpenCL event).
    Result<double> trace(RayQueryMode mode);

    /// Hits of the last `trace`, in the order of the rays.
    Result<std::vector<DeviceHit>> hits();

  private:
    struct State;
    explicit RayQuery(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace prizma
