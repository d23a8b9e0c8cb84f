#include "core/render/ray_query.h"

#include "core/render/renderer.h"

namespace prizma {
namespace {

Kernel& kernelOf(KernelSet& kernels, RayQueryMode mode) {
    switch (mode) {
    case RayQueryMode::Closest:
        return kernels.traceClosest;
    case RayQueryMode::ClosestPacket:
        return kernels.tracePacket;
    case RayQueryMode::Any:
        return kernels.traceAny;
    case RayQueryMode::AnyPacket:
        break;
    }
    return kernels.traceAnyPacket;
}

} // namespace

struct RayQuery::State {
    std::unique_ptr<Renderer> renderer;
    Buffer<DeviceRay> rays;
    Buffer<DeviceHit> hits;
    std::size_t rayCount = 0;
};

RayQuery::RayQuery(std::unique_ptr<State> state) : state_(std::move(state)) {}
RayQuery::RayQuery(RayQuery&&) noexcept = default;
RayQuery& RayQuery::operator=(RayQuery&&) noexcept = default;
RayQuery::~RayQuery() = default;

Result<RayQuery> RayQuery::create(const Scene& scene, const std::string& deviceId,
                                  std::optional<TreeLayout> layout) {
    RendererOptions options;
    options.deviceId = deviceId;
    options.layout = layout;
    options.renewTrees = false; // nobody would fetch them
    auto renderer = Renderer::create(std::move(options));
    if (!renderer)
        return std::unexpected(renderer.error());
    (*renderer)->waitForTrees(scene);
    const Scene drawn = (*renderer)->drawable(scene);
    if (auto ok = (*renderer)->begin((*renderer)->plan(drawn, 1, 1), drawn, 1, 1); !ok)
        return std::unexpected(ok.error());
    (*renderer)->drop();
    auto state = std::make_unique<State>();
    state->renderer = std::move(*renderer);
    return RayQuery(std::move(state));
}

glm::dvec3 RayQuery::origin() const {
    return state_->renderer->anchor();
}

std::string RayQuery::deviceName() const {
    return state_->renderer->device().name;
}

TreeLayout RayQuery::layout() const {
    return state_->renderer->layout();
}

std::uint64_t RayQuery::deviceBytes() const {
    return state_->renderer->statistics(false).deviceBytes;
}

double RayQuery::treeWear() const {
    return state_->renderer->statistics(false).treeWear;
}

Result<void> RayQuery::setRays(std::span<const DeviceRay> rays) {
    Context& context = state_->renderer->context();
    state_->rayCount = rays.size();
    if (auto ok = state_->hits.reserve(context, rays.size(), "hits"); !ok)
        return ok;
    return state_->rays.assign(context, rays, "rays");
}

Result<double> RayQuery::trace(RayQueryMode mode) {
    Context& context = state_->renderer->context();
    KernelSet& kernels = state_->renderer->kernels();
    Kernel& kernel = kernelOf(kernels, mode);
    const auto count = static_cast<std::uint32_t>(state_->rayCount);
    const bool packets = mode == RayQueryMode::ClosestPacket || mode == RayQueryMode::AnyPacket;
    const std::size_t items = packets ? (count + kernels.raysAPacket - 1) / kernels.raysAPacket : count;
    state_->renderer->deviceScene().setSceneArguments(kernel);
    kernel.addArgument(state_->rays);
    kernel.addArgument(state_->hits);
    kernel.addArgument(0u);
    kernel.addArgument(count);
    const auto launched =
        kernel.launch(context, items, packets ? kernels.packetGroupSize() : kernels.groupSize);
    if (!launched)
        return std::unexpected(launched.error());
    if (auto ok = context.finish(); !ok)
        return std::unexpected(ok.error());
    return milliseconds(*launched);
}

Result<std::vector<DeviceHit>> RayQuery::hits() {
    std::vector<DeviceHit> found(state_->rayCount);
    if (auto ok = state_->hits.read(state_->renderer->context(), found, 0, "hits"); !ok)
        return std::unexpected(ok.error());
    return found;
}

} // namespace prizma
