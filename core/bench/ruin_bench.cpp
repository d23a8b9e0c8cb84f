#include "core/bench/ruin_bench.h"

#include "core/bench/deforming_scene.h"
#include "core/bench/ray_sets.h"
#include "core/bench/statistics_of.h"
#include "core/render/ray_query.h"
#include "core/render/renderer.h"
#include "core/render/worn_trees.h"
#include "core/scene/hierarchy.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace prizma::bench {
namespace {

constexpr int flightStart =
    500; ///< Frames, of a fiftieth of the clip's each, in which a tree is to wear out.
constexpr int width = 640;
constexpr int height = 360;
/// Of the flight: trees are ruined early.
constexpr double moments[] = {0.0, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1.0};

/// Rates of both queries over the same rays, in turn.
Result<std::pair<double, double>> ratesOf(RayQuery& first, RayQuery& second, std::span<const DeviceRay> rays,
                                          RayQueryMode mode, int repeats) {
    RayQuery* const queries[] = {&first, &second};
    std::vector<double> rates[2];
    for (RayQuery* query : queries)
        if (auto ok = query->setRays(rays); !ok)
            return std::unexpected(ok.error());
    for (int i = 0; i <= repeats; ++i)
        for (int k = 0; k < 2; ++k) {
            const auto milliseconds = queries[k]->trace(mode);
            if (!milliseconds)
                return std::unexpected(milliseconds.error());
            if (i > 0) // the first launch compiles
                rates[k].push_back(static_cast<double>(rays.size()) / std::max(*milliseconds, 1e-6) * 1e-3);
        }
    return std::pair(median(rates[0]), median(rates[1]));
}

Result<RuinStep> measureStep(const Scene& scene, const RuinBenchOptions& options) {
    const Scene still = frozen(scene);
    auto refitted = RayQuery::create(scene, options.deviceId);
    if (!refitted)
        return std::unexpected(refitted.error());
    auto rebuilt = RayQuery::create(still, options.deviceId);
    if (!rebuilt)
        return std::unexpected(rebuilt.error());
    const RaySets sets = makeRaySets(still, reference::Tracer(still), refitted->origin(), width, height);
    const auto camera =
        ratesOf(*refitted, *rebuilt, sets.camera, RayQueryMode::ClosestPacket, options.repeats);
    if (!camera)
        return std::unexpected(camera.error());
    const auto diffuse = ratesOf(*refitted, *rebuilt, sets.diffuse, RayQueryMode::Closest, options.repeats);
    if (!diffuse)
        return std::unexpected(diffuse.error());
    RuinStep step;
    step.wear = refitted->treeWear();
    step.refitted = {camera->first, diffuse->first};
    step.rebuilt = {camera->second, diffuse->second};
    return step;
}

/// Plays the flight slowly, back and forth, until a worn tree has been replaced.
class RenewalBench {
  public:
    RenewalBench(Scene scene, std::unique_ptr<Renderer> renderer)
        : scene_(std::move(scene)), renderer_(std::move(renderer)) {}

    Result<std::optional<RenewalTimes>> run();

  private:
    struct FrameTime {
        double milliseconds = 0.0;
        bool swapped = false;
    };
    Result<FrameTime> next();

    Scene scene_;
    std::unique_ptr<Renderer> renderer_;
    int frames_ = 0;
};

Result<RenewalBench::FrameTime> RenewalBench::next() {
    scene_.timeline.frame = 0.02 * (frames_++ % flightStart);
    FrameTime time;
    Result<void> begun;
    time.milliseconds = measure([&] {
        const Scene drawn = renderer_->drawable(scene_);
        const RenderPlan plan = renderer_->plan(drawn, 1, 1);
        time.swapped = plan.find(Stage::NewTrees) != nullptr;
        begun = renderer_->begin(plan, drawn, 1, 1);
    });
    renderer_->drop();
    if (!begun)
        return std::unexpected(begun.error());
    return time;
}

Result<std::optional<RenewalTimes>> RenewalBench::run() {
    constexpr int mostFrames = 5000; // a build takes few
    renderer_->waitForTrees(scene_);
    RenewalTimes times;
    std::vector<double> usual;
    bool isBuilding = false;
    std::chrono::steady_clock::time_point started;
    for (int i = 0; i < (isBuilding ? mostFrames : flightStart); ++i) {
        const auto time = next();
        if (!time)
            return std::unexpected(time.error());
        if (time->swapped) {
            times.swap = time->milliseconds;
            times.build =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started)
                    .count() -
                time->milliseconds;
            times.frame = median(usual);
            return times;
        }
        if (isBuilding) { // or has just finished
            times.during = std::max(times.during, time->milliseconds);
        } else if (renderer_->statistics(false).treeWear > WornTrees::limit) {
            isBuilding = true;
            started = std::chrono::steady_clock::now();
            times.start = time->milliseconds;
        } else if (i > 2) { // the first ones upload and compile
            usual.push_back(time->milliseconds);
        }
    }
    return std::nullopt;
}

} // namespace

Result<RuinReport> benchRuin(const Scene& scene, const RuinBenchOptions& options) {
    Scene flying = makeFlyingApart(scene, options.parts, options.distance);
    RuinReport report;
    const Hierarchy hierarchy(flying);
    for (const Object& object : flying.objects)
        report.triangles += object.mesh && hierarchy.isShown(object) ? object.mesh->triangles.size() : 0;
    if (report.triangles == 0)
        return failure("There is no mesh in the scene.");
    const auto query = RayQuery::create(flying, options.deviceId);
    if (!query)
        return std::unexpected(query.error());
    report.device = query->deviceName();
    for (const double moment : moments) {
        flying.timeline.frame = moment * (flightFrames - 1);
        auto step = measureStep(flying, options);
        if (!step)
            return std::unexpected(step.error());
        step->flown = moment;
        report.steps.push_back(*step);
    }
    RendererOptions renderer;
    renderer.deviceId = options.deviceId;
    auto made = Renderer::create(std::move(renderer));
    if (!made)
        return std::unexpected(made.error());
    const auto renewal = RenewalBench(std::move(flying), std::move(*made)).run();
    if (!renewal)
        return std::unexpected(renewal.error());
    report.renewal = *renewal;
    return report;
}

} // namespace prizma::bench
