#include "app/render/bench_animation.h"

#include "app/render/load_scene.h"
#include "core/animation/posed_bounds.h"
#include "core/bench/animate_bench.h"
#include "core/bench/tentacle_scene.h"
#include "core/scene/starter_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace prizma {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::vector<std::string> files;
    bool json = false;
    int copies = 1;
    bench::AnimateBenchOptions animate;
    bench::PlayBenchOptions play;
};

double aspectOf(const Arguments& arguments) {
    return static_cast<double>(arguments.play.width) / arguments.play.height;
}

/// Copies of every posed object in a square, each with a clip, a phase and a speed of its own; every tenth
/// stands still, so that one sees that only what moves is done again.
Scene crowd(const Scene& scene, int copies, double aspect) {
    Scene result = scene;
    result.objects.edit().clear();
    const int side = static_cast<int>(std::ceil(std::sqrt(copies)));
    for (const Object& original : scene.objects) {
        const glm::dvec3 extent = bindPoseBounds(original).extent(); // in its group's space, as the spacing
        const double spacing = 1.3 * std::max(extent.x, extent.z);
        for (int i = 0; i < copies; ++i) {
            Object copy = original;
            copy.transform.translation += spacing * glm::dvec3(i % side, 0, i / side);
            if (!copy.clips.empty())
                copy.clip = copy.clips[static_cast<std::size_t>(i) % copy.clips.size()]->name;
            copy.playback.offset = 0.37 * i;
            copy.playback.speed = i % 10 == 9 ? 0.0 : 0.8 + 0.05 * (i % 9);
            addObject(result, std::move(copy));
        }
    }
    result.camera = frameBounds(result.camera, worldBounds(result), aspect);
    return result;
}

Scene sceneOf(const Arguments& arguments) {
    Scene scene;
    if (arguments.files.empty()) {
        scene = bench::makeTentacleScene();
        presentModel(scene, aspectOf(arguments));
    } else {
        auto loaded = loadScene(arguments.files, {}, aspectOf(arguments));
        if (!loaded)
            fail(loaded.error());
        scene = std::move(*loaded);
    }
    return arguments.copies > 1 ? crowd(scene, arguments.copies, aspectOf(arguments)) : scene;
}

Json toJson(const bench::AnimateReport& report) {
    Json result{{"device", report.device},
                {"objects", report.objects},
                {"triangles", report.triangles},
                {"vertices", report.vertices},
                {"bones", report.bones},
                {"milliseconds", report.milliseconds},
                {"pose", report.pose},
                {"vertexShader", report.vertexShader},
                {"triangleShader", report.triangleShader},
                {"refitTreeShader", report.refitTreeShader}};
    if (report.embreeRefit) {
        result["embree"] = {{"refit", *report.embreeRefit}};
        result["ratio"] = report.ratio;
    }
    return result;
}

Json toJson(const bench::PlayReport& report) {
    return {{"device", report.device},
            {"objects", report.objects},
            {"triangles", report.triangles},
            {"framesPerSecond", report.framesPerSecond},
            {"medianMilliseconds", report.medianMilliseconds},
            {"slowestMilliseconds", report.slowestMilliseconds},
            {"milliseconds",
             {{"pose", report.pose},
              {"vertexShader", report.vertexShader},
              {"triangleShader", report.triangleShader},
              {"refitTreeShader", report.refitTreeShader},
              {"topLevel", report.topLevel},
              {"trace", report.trace},
              {"shade", report.shade}}},
            {"posedObjects", {{"fewest", report.fewestPosed}, {"most", report.mostPosed}}},
            {"framesThatUploaded", report.uploads}};
}

void print(const bench::AnimateReport& report) {
    fmt::print("{}: {} triangles, {} vertices, {} bones in {} objects; medians\n", report.device,
               report.triangles, report.vertices, report.bones, report.objects);
    fmt::print("{:.2f} ms: pose {:.3f}, VertexShader {:.3f} ({:.1f} ns a vertex), TriangleShader {:.3f}, "
               "RefitTreeShader {:.3f}\n",
               report.milliseconds, report.pose, report.vertexShader,
               report.vertexShader * 1e6 / static_cast<double>(report.vertices), report.triangleShader,
               report.refitTreeShader);
    if (report.embreeRefit)
        fmt::print("Embree, refit alone: {:.2f} ms; ratio {:.2f}\n", *report.embreeRefit, report.ratio);
}

void print(const bench::PlayReport& report) {
    fmt::print("{}: {} objects, {} triangles: {:.1f} frames/s (median {:.1f} ms, slowest {:.1f} ms)\n",
               report.device, report.objects, report.triangles, report.framesPerSecond,
               report.medianMilliseconds, report.slowestMilliseconds);
    fmt::print(
        "means in ms: pose {:.2f}, VertexShader {:.2f}, TriangleShader {:.2f}, RefitTreeShader {:.2f}, "
        "top level {:.2f}, trace {:.2f}, shade {:.2f}\n",
        report.pose, report.vertexShader, report.triangleShader, report.refitTreeShader, report.topLevel,
        report.trace, report.shade);
    fmt::print("{} to {} objects were posed, skinned and refitted a frame; {} frames uploaded geometry\n",
               report.fewestPosed, report.mostPosed, report.uploads);
}

template <class Report>
void show(const Result<Report>& report, bool json) {
    if (!report)
        fail(report.error());
    if (json)
        fmt::print("{}\n", toJson(*report).dump(2));
    else
        print(*report);
}

void addCommonOptions(CLI::App& command, const std::shared_ptr<Arguments>& arguments) {
    command.add_option("files", arguments->files,
                       "A project, or a model and its animations; without: 100,000 triangles on 60 bones");
    command.add_flag("--json", arguments->json, "Print JSON for scripts");
    command
        .add_option("--copies", arguments->copies,
                    "This many of each object, with clips, phases and speeds of their own; every tenth still")
        ->check(CLI::Range(1, 10000));
}

} // namespace

void addAnimationBenches(CLI::App& bench) {
    const auto arguments = std::make_shared<Arguments>();
    auto* animate = bench.add_subcommand("animate", "What it costs to pose, skin and refit");
    addCommonOptions(*animate, arguments);
    animate->add_option("--device", arguments->animate.deviceId, "OpenCL device, as \"devices\" lists it");
    animate->add_option("--repeats", arguments->animate.repeats, "Measurements of which the median counts")
        ->check(CLI::Range(5, 1000))
        ->capture_default_str();
    animate->callback(
        [arguments] { show(bench::benchAnimate(sceneOf(*arguments), arguments->animate), arguments->json); });

    auto* play = bench.add_subcommand("play", "How many frames a second an animated scene plays with");
    addCommonOptions(*play, arguments);
    play->add_option("--device", arguments->play.deviceId, "OpenCL device, as \"devices\" lists it");
    play->add_option("--width", arguments->play.width, "Of the picture")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    play->add_option("--height", arguments->play.height, "Its height")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    play->add_option("--frames", arguments->play.frames, "How many are drawn")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    play->callback(
        [arguments] { show(bench::benchPlay(sceneOf(*arguments), arguments->play), arguments->json); });
}

} // namespace prizma
