#include "core/render/offline_render.h"

#include <bit>
#include <cmath>

namespace prizma {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void addTimes(const RenderStatistics& statistics, OfflineTimes& times) {
    for (const StageStatistics& stage : statistics.stages) {
        const bool refits =
            stage.stage == describe(Stage::Poses) || stage.stage == describe(Stage::VertexShader) ||
            stage.stage == describe(Stage::TriangleShader) || stage.stage == describe(Stage::RefitTreeShader);
        double& part = stage.stage == describe(Stage::GenerateCameraRays) ? times.trace
                       : stage.stage == describe(Stage::RayShader)        ? times.shade
                       : refits                                           ? times.refit
                                                                          : times.upload;
        part += stage.milliseconds;
    }
}

std::uint64_t countNonFinite(const std::vector<float>& radiance) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i + 3 < radiance.size(); i += 4)
        if (!std::isfinite(radiance[i]) || !std::isfinite(radiance[i + 1]) || !std::isfinite(radiance[i + 2]))
            ++count;
    return count;
}

Result<void> renderPass(Renderer& renderer, const RenderPlan& plan, const Scene& scene,
                        const OfflineOptions& options, const Progress* cancel) {
    if (auto ok = renderer.begin(plan, scene, options.width, options.height); !ok)
        return ok;
    while (true) {
        const auto done = renderer.step();
        if (!done)
            return std::unexpected(done.error());
        if (*done)
            return {};
        if (cancel && cancel->isCancelled()) {
            renderer.drop();
            return failure("Rendering was cancelled.");
        }
    }
}

} // namespace

double relativeMeanSquaredError(const std::vector<float>& picture, const std::vector<float>& reference) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.size() && i < reference.size(); ++i) {
        if (i % 4 == 3)
            continue;
        const double truth = reference[i];
        const double difference = picture[i] - truth;
        sum += difference * difference / (truth * truth + 0.01);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

Result<OfflinePicture> renderOffline(Renderer& renderer, const Scene& scene, const OfflineOptions& options,
                                     const Progress* cancel) {
    const auto start = Clock::now();
    OfflinePicture picture;
    if (const auto shader = renderer.kernels().rayShader(renderer.context(), scene.render.shader); !shader)
        return std::unexpected(shader.error());
    picture.times.compile = since(start);
    const auto builds = Clock::now();
    renderer.waitForTrees(scene);
    picture.times.build = since(builds);

    Scene drawn = renderer.drawable(scene);
    if (options.samples > 0)
        drawn.render.samples = options.samples;
    std::vector<float> half;
    while (true) {
        if (cancel && cancel->isCancelled())
            return failure("Rendering was cancelled.");
        const RenderPlan plan = renderer.plan(drawn, options.width, options.height);
        if (!plan.find(Stage::RayShader))
            break;
        if (auto ok = renderPass(renderer, plan, drawn, options, cancel); !ok)
            return std::unexpected(ok.error());
        const RenderStatistics statistics = renderer.statistics(true);
        addTimes(statistics, picture.times);
        picture.passTimes.add(statistics.times);
        picture.nonFinitePixels += statistics.nonFinitePixels;
        picture.rays.camera += statistics.rays.camera;
        picture.rays.shadow += statistics.rays.shadow;
        picture.rays.secondary += statistics.rays.secondary;
        const int samples = renderer.samples();
        if (std::has_single_bit(static_cast<unsigned>(samples)) || samples == drawn.render.samples) {
            auto mean = renderer.mean();
            if (!mean)
                return std::unexpected(mean.error());
            if (!half.empty())
                picture.error = relativeMeanSquaredError(half, *mean);
            half = std::move(*mean);
            if (samples > 1 && picture.error < options.maxError)
                break;
        }
        if (options.timeLimit > 0.0 && since(start) > options.timeLimit * 1000.0)
            break;
    }
    auto rendered = options.deep
                        ? renderer.picture({PictureFormat::Png8, PictureFormat::Png16, PictureFormat::Exr})
                        : renderer.picture({PictureFormat::Png8, PictureFormat::Exr});
    if (!rendered)
        return std::unexpected(rendered.error());
    static_cast<Picture&>(picture) = std::move(*rendered);
    picture.nonFinitePixels += countNonFinite(picture.radiance);
    picture.times.total = since(start);
    return picture;
}

} // namespace prizma
