#pragma once

#include "core/bvh/device_layout.h"
#include "core/compute/kernel.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace prizma {

/// A RayShader kernel.
struct RayShader {
    Kernel kernel;
    bool makesRays = false; ///< Makes and traces its camera rays itself, a packet a work item.
};

/// All kernels for one device and tree layout. RayShader is built when a shader is first used.
class KernelSet {
  public:
    /// `building` is told before something is compiled that may take seconds. `packets`: whether RayShader
    /// may work on packets of pixels where the layout allows it.
    static Result<KernelSet> create(Context& context, TreeLayout layout, std::function<void()> building = {},
                                    bool packets = true);

    Kernel vertexShader, triangleShader, refitTreeShader, refitSmallLevels, gatherRoots;
    Kernel generateCameraRays, traceClosest, traceAny, tracePacket, traceAnyPacket;
    Kernel toneMap, toneMapFilmic, toneMapDeep, meanRadiance;

    /// The RayShader kernel for `type`, built on first use.
    /// `recording`: it takes three more arguments and writes down the rays that it traces (record_rays.clh).
    Result<RayShader*> rayShader(Context& context, ShaderType type, bool recording = false);

    std::size_t groupSize = 64;   ///< Work items a group for kernels that run once a pixel or ray.
    std::size_t raysAPacket = 16; ///< Rays a work item of tracePacket; GPUs make packets of threads instead.

    /// Work items a group for tracePacket.
    std::size_t packetGroupSize() const { return std::max<std::size_t>(groupSize / raysAPacket, 1); }

  private:
    Result<void> load(Context& context, const std::string& file, const std::string& options,
                      std::initializer_list<std::pair<Kernel*, const char*>> kernels);

    std::string options_;
    std::function<void()> building_;
    bool packets_ = true;
    std::map<std::pair<ShaderType, bool>, RayShader> rayShaders_; ///< By type, and whether they record.
};

/// The layout that suits a kind of device.
TreeLayout layoutFor(DeviceType type);

} // namespace prizma
