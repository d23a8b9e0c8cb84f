#include "core/bench/animate_bench.h"

#include "core/animation/pose_key.h"
#include "core/bench/embree_refit.h"
#include "core/bench/statistics_of.h"
#include "core/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>

namespace prizma::bench {
namespace {

std::vector<const Object*> posedObjects(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    std::vector<const Object*> posed;
    for (const Object& object : scene.objects)
        if (isDrawn(hierarchy, object) && isPosed(object))
            posed.push_back(&object);
    return posed;
}

/// Milliseconds of each stage of the renderer's last plan; `drawn`: with its pass.
std::map<std::string, double> stageTimes(Renderer& renderer, bool drawn) {
    std::map<std::string, double> times;
    for (const StageStatistics& entry : renderer.statistics(drawn).stages)
        times[entry.stage] = entry.milliseconds;
    return times;
}

Result<std::unique_ptr<Renderer>> makeRenderer(const std::string& deviceId) {
    RendererOptions options;
    options.deviceId = deviceId;
    return Renderer::create(std::move(options));
}

/// Brings the device to `seconds`, but draws nothing.
Result<void> bringTo(Renderer& renderer, Scene& scene, double seconds) {
    scene.timeline.frame = seconds * scene.timeline.fps;
    const Scene drawn = renderer.drawable(scene);
    if (auto ok = renderer.begin(renderer.plan(drawn, 1, 1), drawn, 1, 1); !ok)
        return ok;
    renderer.drop();
    return {};
}

Result<double> refitWithEmbree(Renderer& renderer, EmbreeRefit& embree,
                               const std::vector<const Object*>& objects) {
    std::vector<std::vector<glm::vec3>> positions;
    for (const Object* object : objects) {
        auto posed = renderer.deviceScene().posedPositions(object->id);
        if (!posed)
            return std::unexpected(posed.error());
        positions.push_back(std::move(*posed));
    }
    embree.refit(positions); // not timed, as ours
    return embree.refit(positions);
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           std::max<double>(1.0, static_cast<double>(values.size()));
}

/// One frame of a player: the whole picture with one sample.
Result<void> drawFrame(Renderer& renderer, const Scene& scene, const PlayBenchOptions& options,
                       RenderPlan& plan) {
    plan = renderer.plan(scene, options.width, options.height);
    if (auto ok = renderer.begin(plan, scene, options.width, options.height); !ok)
        return ok;
    for (bool done = false; !done;) {
        const auto stepped = renderer.step();
        if (!stepped)
            return std::unexpected(stepped.error());
        done = *stepped;
    }
    const auto pixels = renderer.display();
    return pixels ? Result<void>{} : std::unexpected(pixels.error());
}

} // namespace

Result<AnimateReport> benchAnimate(const Scene& measured, const AnimateBenchOptions& options) {
    Scene scene = measured;
    const auto objects = posedObjects(scene);
    if (objects.empty())
        return failure("Nothing in the scene is posed: an object must be Dynamic and have bones or morph "
                       "targets.");
    AnimateReport report;
    std::vector<MeshPtr> meshes;
    for (const Object* object : objects) {
        meshes.push_back(object->mesh);
        report.triangles += object->mesh->triangles.size();
        report.vertices += object->mesh->positions.size();
        report.bones += object->mesh->skeleton ? object->mesh->skeleton->bones.size() : 0;
    }
    report.objects = objects.size();
    const auto renderer = makeRenderer(options.deviceId);
    if (!renderer)
        return std::unexpected(renderer.error());
    report.device = (*renderer)->device().name;
    (*renderer)->waitForTrees(scene);
    const auto embree = EmbreeRefit::create(meshes);
    std::map<std::string, std::vector<double>> samples;
    std::vector<double> totals, embreeTimes;
    constexpr int warmUp = 3; // the first launches of a kernel compile it
    for (int i = 0; i < warmUp + options.repeats; ++i) {
        // Each side's first run after the other's is not timed: workers of the other still look for more work
        // then.
        for (const double seconds : {0.11 * i - 0.05, 0.11 * i})
            if (auto ok = bringTo(**renderer, scene, seconds); !ok)
                return std::unexpected(ok.error());
        const auto times = stageTimes(**renderer, false);
        double embreeTime = 0.0;
        if (embree) {
            const auto refitted = refitWithEmbree(**renderer, *embree, objects);
            if (!refitted)
                return std::unexpected(refitted.error());
            embreeTime = *refitted;
        }
        if (i < warmUp)
            continue;
        double total = 0.0;
        for (const Stage stage :
             {Stage::Poses, Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader}) {
            const auto found = times.find(describe(stage));
            const double time = found == times.end() ? 0.0 : found->second;
            samples[describe(stage)].push_back(time);
            total += time;
        }
        totals.push_back(total);
        embreeTimes.push_back(embreeTime);
    }
    report.pose = median(samples[describe(Stage::Poses)]);
    report.vertexShader = median(samples[describe(Stage::VertexShader)]);
    report.triangleShader = median(samples[describe(Stage::TriangleShader)]);
    report.refitTreeShader = median(samples[describe(Stage::RefitTreeShader)]);
    report.milliseconds = median(totals);
    if (embree) {
        report.embreeRefit = median(embreeTimes);
        report.ratio = report.milliseconds / std::max(*report.embreeRefit, 1e-6);
    }
    return report;
}

Result<PlayReport> benchPlay(const Scene& played, const PlayBenchOptions& options) {
    Scene scene = played;
    scene.timeline.fps = options.fps;
    scene.render.samples = 1;
    const auto renderer = makeRenderer(options.deviceId);
    if (!renderer)
        return std::unexpected(renderer.error());
    (*renderer)->waitForTrees(scene);
    PlayReport report;
    report.device = (*renderer)->device().name;
    report.fewestPosed = scene.objects.size();
    std::vector<double> times;
    std::map<std::string, std::vector<double>> samples;
    constexpr int warmUp = 2;
    for (int i = 0; i < warmUp + options.frames; ++i) {
        scene.timeline.frame = i;
        RenderPlan plan;
        Result<void> drawn;
        const double time =
            measure([&] { drawn = drawFrame(**renderer, (*renderer)->drawable(scene), options, plan); });
        if (!drawn)
            return std::unexpected(drawn.error());
        if (i < warmUp)
            continue;
        times.push_back(time);
        for (const auto& [stage, milliseconds] : stageTimes(**renderer, true))
            samples[stage].push_back(milliseconds);
        const PlannedStage* posed = plan.find(Stage::VertexShader);
        const std::size_t count = posed ? posed->objects.size() : 0;
        report.fewestPosed = std::min(report.fewestPosed, count);
        report.mostPosed = std::max(report.mostPosed, count);
        report.uploads += plan.find(Stage::Geometry) ? 1 : 0;
    }
    report.objects = scene.objects.size();
    report.triangles = (*renderer)->statistics(false).triangles;
    report.framesPerSecond = 1000.0 / std::max(mean(times), 1e-6);
    report.medianMilliseconds = median(times);
    report.slowestMilliseconds = *std::max_element(times.begin(), times.end());
    const auto meanOf = [&](Stage stage) {
        const auto& list = samples[describe(stage)];
        return std::accumulate(list.begin(), list.end(), 0.0) / options.frames;
    };
    report.pose = meanOf(Stage::Poses);
    report.vertexShader = meanOf(Stage::VertexShader);
    report.triangleShader = meanOf(Stage::TriangleShader);
    report.refitTreeShader = meanOf(Stage::RefitTreeShader);
    report.topLevel = meanOf(Stage::TopLevel);
    report.trace = meanOf(Stage::GenerateCameraRays);
    report.shade = meanOf(Stage::RayShader);
    return report;
}

} // namespace prizma::bench
