#include "core/bench/frame_bench.h"

#include "core/animation/posed_bounds.h"
#include "core/bench/scene_export.h"
#include "core/bench/statistics_of.h"
#include "core/render/ray_query.h"
#include "core/render/renderer.h"

#include <algorithm>
#include <array>
#include <limits>

namespace prizma::bench {
namespace {

constexpr int pathBounces = 4;

/// One light under the scene's ceiling, where bench trace has it.
void lightByOnePoint(Scene& scene) {
    const DBounds bounds = worldBounds(scene);
    Light light;
    light.position = {bounds.centre().x, bounds.high.y - 0.03 * bounds.extent().y, bounds.centre().z};
    light.intensity = glm::dot(bounds.extent(), bounds.extent());
    scene.lights = {};
    addLight(scene, light);
}

/// Rays of one kind on the device, and the way to trace them that is faster.
class RecordedSet {
  public:
    RecordedSet(RayQuery query, bool anyHit, std::string name) : query_(std::move(query)), anyHit_(anyHit) {
        result_.rays = std::move(name);
    }

    Result<void> set(const std::vector<DeviceRay>& rays);
    Result<void> measureOnce();
    FrameRays result() const;

  private:
    RayQueryMode mode(bool packets) const {
        if (anyHit_)
            return packets ? RayQueryMode::AnyPacket : RayQueryMode::Any;
        return packets ? RayQueryMode::ClosestPacket : RayQueryMode::Closest;
    }

    RayQuery query_;
    bool anyHit_ = false;
    FrameRays result_;
    std::vector<double> times_;
};

Result<void> RecordedSet::set(const std::vector<DeviceRay>& rays) {
    result_.count = static_cast<std::uint64_t>(
        std::count_if(rays.begin(), rays.end(), [](const DeviceRay& ray) { return ray.tMax > ray.tMin; }));
    if (auto ok = query_.setRays(rays); !ok)
        return ok;
    double best = std::numeric_limits<double>::infinity();
    for (const bool packets : {true, false})
        for (int i = 0; i < 3; ++i) { // the first launch compiles the kernel
            const auto time = query_.trace(mode(packets));
            if (!time)
                return std::unexpected(time.error());
            if (i > 0 && *time < best) {
                best = *time;
                result_.inPackets = packets;
            }
        }
    return {};
}

Result<void> RecordedSet::measureOnce() {
    const auto time = query_.trace(mode(result_.inPackets));
    if (!time)
        return std::unexpected(time.error());
    times_.push_back(*time);
    return {};
}

FrameRays RecordedSet::result() const {
    FrameRays result = result_;
    result.milliseconds = median(times_);
    return result;
}

class FrameBench {
  public:
    FrameBench(Renderer& renderer, Scene scene, const FrameBenchOptions& options)
        : renderer_(renderer), scene_(std::move(scene)), options_(options) {}

    Result<FrameResult> run(ShaderType shader, const std::string& name);

  private:
    Result<void> drawSample();
    Result<void> prepareRays();
    Result<void> measureOnce();

    Renderer& renderer_;
    Scene scene_;
    FrameBenchOptions options_;
    std::vector<RecordedSet> sets_;
    std::vector<double> times_;
    FrameResult result_;
};

Result<void> FrameBench::drawSample() {
    const Scene drawn = renderer_.drawable(scene_);
    const RenderPlan plan = renderer_.plan(drawn, options_.width, options_.height);
    if (auto ok = renderer_.begin(plan, drawn, options_.width, options_.height); !ok)
        return ok;
    while (true) {
        const auto done = renderer_.step();
        if (!done)
            return std::unexpected(done.error());
        if (*done)
            return {};
    }
}

Result<void> FrameBench::prepareRays() {
    sets_.clear();
    const auto recorded = renderer_.recordRays();
    if (!recorded)
        return std::unexpected(recorded.error());
    constexpr std::array names{"camera", "shadow packets", "further", "shadow"};
    std::array<std::vector<DeviceRay>, names.size()> rays;
    for (const DeviceRecordedRay& record : *recorded)
        rays.at(record.kind).push_back(record.ray);
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
        if (rays[kind].empty())
            continue;
        auto query = RayQuery::create(scene_, options_.deviceId);
        if (!query)
            return std::unexpected(query.error());
        const bool anyHit = kind == PRIZMA_RECORDED_ANY_PACKET || kind == PRIZMA_RECORDED_ANY;
        RecordedSet set(std::move(*query), anyHit, names[kind]);
        if (auto ok = set.set(rays[kind]); !ok)
            return ok;
        sets_.push_back(std::move(set));
    }
    return {};
}

Result<void> FrameBench::measureOnce() {
    for (RecordedSet& set : sets_)
        if (auto ok = set.measureOnce(); !ok)
            return ok;
    Result<void> drawn;
    times_.push_back(measure([&] { drawn = drawSample(); }));
    if (!drawn)
        return drawn;
    const RenderStatistics statistics = renderer_.statistics(true);
    result_.times.add(statistics.times);
    result_.nonFinitePixels += statistics.nonFinitePixels;
    return {};
}

Result<FrameResult> FrameBench::run(ShaderType shader, const std::string& name) {
    result_ = {};
    times_.clear();
    scene_.render.shader = shader;
    scene_.render.samples = std::numeric_limits<int>::max();
    if (auto ok = drawSample(); !ok) // compiles the kernel
        return std::unexpected(ok.error());
    if (auto ok = prepareRays(); !ok)
        return std::unexpected(ok.error());
    // Sizes the chunks by this shader's speed; the recording shader was slower.
    for (int i = 0; i < 2; ++i)
        if (auto ok = drawSample(); !ok)
            return std::unexpected(ok.error());
    for (int i = 0; i < options_.repeats; ++i)
        if (auto ok = measureOnce(); !ok)
            return std::unexpected(ok.error());
    result_.shader = name;
    result_.width = options_.width;
    result_.height = options_.height;
    result_.milliseconds = median(times_);
    result_.times.scale(1.0 / options_.repeats);
    for (const RecordedSet& set : sets_) {
        result_.rays.push_back(set.result());
        result_.raysMilliseconds += result_.rays.back().milliseconds;
    }
    result_.ratio = result_.milliseconds / std::max(result_.raysMilliseconds, 1e-6);
    return result_;
}

} // namespace

Result<FrameReport> benchFrame(Scene scene, const FrameBenchOptions& given) {
    if (!drawsAnything(scene))
        return failure("There is nothing to draw in the scene.");
    FrameBenchOptions options = given;
    RendererOptions rendererOptions;
    rendererOptions.deviceId = options.deviceId;
    auto renderer = Renderer::create(std::move(rendererOptions));
    if (!renderer)
        return std::unexpected(renderer.error());
    const bool isGpu = (*renderer)->device().type == DeviceType::Gpu;
    if (options.width <= 0)
        options.width = options.height > 0 ? std::max(options.height * 16 / 9, 1) : (isGpu ? 1920 : 1280);
    if (options.height <= 0)
        options.height = std::max(options.width * 9 / 16, 1);
    lightByOnePoint(scene);
    scene.render.maxDepth = pathBounces;
    if (!options.exportTo.empty())
        if (auto ok = exportScene(scene, options.exportTo); !ok)
            return std::unexpected(ok.error());
    (*renderer)->waitForTrees(scene);
    FrameBench bench(**renderer, std::move(scene), options);
    FrameReport report;
    report.device = (*renderer)->device().name;
    for (const auto& [shader, name] :
         {std::pair{ShaderType::Whitted, "whitted"}, {ShaderType::Path, "path"}}) {
        auto result = bench.run(shader, name);
        if (!result)
            return std::unexpected(result.error());
        report.frames.push_back(std::move(*result));
    }
    report.triangles = (*renderer)->statistics(false).triangles;
    return report;
}

} // namespace prizma::bench
