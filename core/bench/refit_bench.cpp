#include "core/bench/refit_bench.h"

#include "core/bench/deforming_scene.h"
#include "core/bench/embree_refit.h"
#include "core/bench/statistics_of.h"
#include "core/render/renderer.h"

#include <algorithm>

namespace prizma::bench {
namespace {

/// Milliseconds of a stage of the renderer's last plan.
double timeOf(Renderer& renderer, Stage stage) {
    for (const StageStatistics& entry : renderer.statistics(false).stages)
        if (entry.stage == describe(stage))
            return entry.milliseconds;
    return 0.0;
}

/// Brings the device to a frame of the scene's timeline, but draws nothing.
Result<void> show(Renderer& renderer, Scene& scene, int frame) {
    scene.timeline.frame = frame;
    const Scene drawn = renderer.drawable(scene);
    if (auto ok = renderer.begin(renderer.plan(drawn, 1, 1), drawn, 1, 1); !ok)
        return ok;
    renderer.drop();
    return {};
}

class RefitBench {
  public:
    RefitBench(Scene scene, std::unique_ptr<Renderer> renderer)
        : scene_(std::move(scene)), renderer_(std::move(renderer)) {
        const Hierarchy hierarchy(scene_);
        std::vector<MeshPtr> meshes;
        for (const Object& object : scene_.objects)
            if (isDrawn(hierarchy, object)) {
                objects_.push_back(object.id);
                meshes.push_back(object.mesh);
            }
        embree_ = EmbreeRefit::create(meshes);
    }

    Result<RefitReport> run(int repeats);

  private:
    struct Times {
        double vertices = 0.0, triangles = 0.0, trees = 0.0;
        std::optional<double> embree;
    };
    Result<Times> measureFrame(int frame);

    Scene scene_;
    std::unique_ptr<Renderer> renderer_;
    std::vector<Id> objects_;
    std::unique_ptr<EmbreeRefit> embree_;
};

Result<RefitBench::Times> RefitBench::measureFrame(int frame) {
    if (auto ok = show(*renderer_, scene_, frame); !ok)
        return std::unexpected(ok.error());
    Times times{timeOf(*renderer_, Stage::VertexShader), timeOf(*renderer_, Stage::TriangleShader),
                timeOf(*renderer_, Stage::RefitTreeShader), std::nullopt};
    if (!embree_)
        return times;
    std::vector<std::vector<glm::vec3>> positions;
    for (const Id id : objects_) {
        auto posed = renderer_->deviceScene().posedPositions(id);
        if (!posed)
            return std::unexpected(posed.error());
        positions.push_back(std::move(*posed));
    }
    times.embree = embree_->refit(positions);
    return times;
}

Result<RefitReport> RefitBench::run(int repeats) {
    RefitReport report;
    report.device = renderer_->device().name;
    for (const Id id : objects_)
        report.triangles += scene_.findObject(id)->mesh->triangles.size();
    renderer_->waitForTrees(scene_);
    for (int frame = 0; frame < 2; ++frame) // the first launch of a kernel compiles it
        if (auto times = measureFrame(frame); !times)
            return std::unexpected(times.error());
    std::vector<double> sum, vertices, triangles, trees, embree;
    for (int i = 0; i < repeats; ++i) {
        const auto times = measureFrame(2 + i);
        if (!times)
            return std::unexpected(times.error());
        sum.push_back(times->triangles + times->trees);
        vertices.push_back(times->vertices);
        triangles.push_back(times->triangles);
        trees.push_back(times->trees);
        if (times->embree)
            embree.push_back(*times->embree);
    }
    report.milliseconds = median(sum);
    report.vertexShader = median(vertices);
    report.triangleShader = median(triangles);
    report.refitTreeShader = median(trees);
    if (!embree.empty()) {
        report.embreeRefit = median(embree);
        report.ratio = report.milliseconds / std::max(*report.embreeRefit, 1e-6);
    }
    return report;
}

} // namespace

Result<RefitReport> benchRefit(const Scene& scene, const RefitBenchOptions& options) {
    if (!drawsAnything(scene))
        return failure("There is no mesh in the scene.");
    RendererOptions renderer;
    renderer.deviceId = options.deviceId;
    renderer.layout = options.layout;
    auto made = Renderer::create(std::move(renderer));
    if (!made)
        return std::unexpected(made.error());
    return RefitBench(makeBending(scene), std::move(*made)).run(options.repeats);
}

} // namespace prizma::bench
