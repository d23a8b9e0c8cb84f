#include "core/render/kernel_set.h"

#include "core/compute/program.h"

namespace prizma {

namespace {

/// Fewer registers a thread let more threads hide each other's delays: on an H100, 48 make diffuse rays 13 %
/// faster than as many as the compiler likes, camera rays 3 %. Below, spilling costs more.
std::string tracingOptions(const DeviceInfo& device) {
    return device.platform.find("NVIDIA") != std::string::npos ? " -cl-nv-maxrregcount=48" : "";
}

} // namespace

TreeLayout layoutFor(DeviceType type) {
    return type == DeviceType::Gpu ? TreeLayout::Binary2 : TreeLayout::Wide8;
}

Result<void> KernelSet::load(Context& context, const std::string& file, const std::string& options,
                             std::initializer_list<std::pair<Kernel*, const char*>> kernels) {
    if (building_)
        building_();
    const auto program = buildProgram(context, file, options);
    if (!program)
        return std::unexpected(program.error());
    for (const auto& [kernel, name] : kernels) {
        auto made = Kernel::create(*program, name);
        if (!made)
            return std::unexpected(made.error());
        *kernel = std::move(*made);
    }
    return {};
}

Result<KernelSet> KernelSet::create(Context& context, TreeLayout layout, std::function<void()> building,
                                    bool packets) {
    KernelSet set;
    set.packets_ = packets && layout == TreeLayout::Wide8;
    set.building_ = std::move(building);
    set.options_ = layout == TreeLayout::Wide8 ? "-D PRIZMA_WIDE8" : "-D PRIZMA_BINARY2";
    set.raysAPacket = layout == TreeLayout::Wide8 ? 16 : 1;
    set.groupSize = std::min<std::size_t>(set.groupSize, context.info().maxWorkGroupSize);
    Result<void> ok;
    const auto load = [&](const char* file, std::initializer_list<std::pair<Kernel*, const char*>> kernels,
                          const std::string& furtherOptions = {}) {
        if (ok)
            ok = set.load(context, file, set.options_ + furtherOptions, kernels);
    };
    load("vertex_shader.cl", {{&set.vertexShader, "vertexShader"}});
    load("triangle_shader.cl", {{&set.triangleShader, "triangleShader"}});
    load("refit_tree_shader.cl", {{&set.refitTreeShader, "refitTreeShader"},
                                  {&set.refitSmallLevels, "refitSmallLevels"},
                                  {&set.gatherRoots, "gatherRoots"}});
    load("generate_camera_rays.cl", {{&set.generateCameraRays, "generateCameraRays"}});
    load("trace.cl",
         {{&set.traceClosest, "traceClosest"},
          {&set.traceAny, "traceAny"},
          {&set.tracePacket, "tracePacket"},
          {&set.traceAnyPacket, "traceAnyPacket"}},
         tracingOptions(context.info()));
    load("display.cl", {{&set.toneMap, "toneMap"},
                        {&set.toneMapFilmic, "toneMapFilmic"},
                        {&set.toneMapDeep, "toneMapDeep"},
                        {&set.meanRadiance, "meanRadiance"}});
    if (!ok)
        return std::unexpected(ok.error());
    return set;
}

Result<RayShader*> KernelSet::rayShader(Context& context, ShaderType type, bool recording) {
    if (const auto found = rayShaders_.find({type, recording}); found != rayShaders_.end())
        return &found->second;
    if (building_)
        building_();
    // What only looks at the first hit gains nothing from packets.
    const bool packets = packets_ && (type == ShaderType::Whitted || type == ShaderType::Path);
    const auto program =
        buildProgram(context, "ray_shader.cl",
                     options_ + " -D PRIZMA_VIEW=" + std::to_string(static_cast<int>(type)) +
                         (packets ? " -D PRIZMA_PACKETS" : "") + (recording ? " -D PRIZMA_RECORD_RAYS" : ""));
    if (!program)
        return std::unexpected(program.error());
    auto kernel = Kernel::create(*program, packets ? "rayShaderPacket" : "rayShader");
    if (!kernel)
        return std::unexpected(kernel.error());
    return &(rayShaders_[{type, recording}] = {std::move(*kernel), packets});
}

} // namespace prizma
