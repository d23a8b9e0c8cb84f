#pragma once

#include "core/scene/scene.h"
#include "kernels/device_types.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace prizma::bench {

/// How a set of rays is given to Embree.
struct EmbreeCall {
    bool anyHit = false;
    bool packets = false;  ///< Sixteen rays a call instead of one.
    bool coherent = false; ///< Tells Embree so.
};

/// Embree over the same triangles, to compare with. All cores, through TBB.
class EmbreePeer {
  public:
    /// The visible objects, relative to `origin`, in single precision, as the device has them. Null if this
    /// program was built without Embree.
    static std::unique_ptr<EmbreePeer> create(const Scene& scene, const glm::dvec3& origin, bool robust);

    virtual ~EmbreePeer() = default;

    /// Traces the rays and gives the milliseconds that takes: rays are in Embree's form before, hits after.
    virtual double trace(std::span<const DeviceRay> rays, const EmbreeCall& call) = 0;

    /// Of the last `trace`. Of an occluded ray `t` is 0, as the kernels say it.
    virtual const std::vector<DeviceHit>& hits() const = 0;
};

/// Milliseconds of Embree's medium-quality build of a mesh; nothing if this program was built without Embree.
std::optional<double> embreeBuildMilliseconds(const Mesh& mesh);

} // namespace prizma::bench
