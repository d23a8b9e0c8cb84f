#include "app/render/bench_animation.h"
#include "app/render/command.h"
#include "app/render/load_scene.h"
#include "core/bench/build_bench.h"
#include "core/bench/procedural_scene.h"
#include "core/bench/refit_bench.h"
#include "core/bench/trace_bench.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace prizma {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string file;
    bool json = false;
    bool instanced = false;
    std::string layout = "wide8";
    int repeats = 5;
    bench::TraceBenchOptions trace;
};

Scene sceneOf(const Arguments& arguments) {
    if (arguments.file.empty())
        return bench::makeProceduralScene(arguments.instanced ? bench::ProceduralForm::Instances
                                                              : bench::ProceduralForm::OneMesh);
    auto scene = loadScene(arguments.file, {}, double(arguments.trace.width) / arguments.trace.height);
    if (!scene)
        fail(scene.error());
    return std::move(*scene);
}

Json toJson(const bench::TraceReport& report) {
    Json results = Json::array();
    for (const bench::TraceResult& result : report.results) {
        Json item{{"rays", result.rays},
                  {"count", result.rayCount},
                  {"mraysPerSecond", result.mraysPerSecond},
                  {"mismatches", result.mismatches},
                  {"wrong", result.wrong}};
        if (result.embree) {
            item["embree"] = {{"single", result.embree->single},
                              {"packet16", result.embree->packet16},
                              {"robustSingle", result.embree->robustSingle},
                              {"robustPacket16", result.embree->robustPacket16}};
            item["ratio"] = result.ratio;
            item["ratioRobust"] = result.ratioRobust;
        }
        results.push_back(std::move(item));
    }
    return {{"device", report.device}, {"triangles", report.triangles}, {"results", std::move(results)}};
}

Json toJson(const bench::BuildReport& report) {
    Json result{{"triangles", report.triangles},
                {"milliseconds", report.milliseconds},
                {"build", report.buildMilliseconds},
                {"layout", report.layoutMilliseconds},
                {"bytesPerTriangle", report.bytesPerTriangle},
                {"sahCost", report.sahCost},
                {"depth", report.depth}};
    if (report.embreeMedium) {
        result["embree"] = {{"medium", *report.embreeMedium}};
        result["ratio"] = report.ratio;
    }
    return result;
}

Json toJson(const bench::RefitReport& report) {
    Json result{{"device", report.device},
                {"triangles", report.triangles},
                {"milliseconds", report.milliseconds},
                {"vertexShader", report.vertexShader},
                {"triangleShader", report.triangleShader},
                {"refitTreeShader", report.refitTreeShader}};
    if (report.embreeRefit) {
        result["embree"] = {{"refit", *report.embreeRefit}};
        result["ratio"] = report.ratio;
    }
    return result;
}

void print(const bench::TraceReport& report) {
    fmt::print("{}, {} triangles; Mrays/s, medians\n", report.device, report.triangles);
    fmt::print("{:<8} {:>8} {:>9} {:>10} {:>6}", "rays", "count", "Mrays/s", "mismatches", "wrong");
    const bool hasEmbree = !report.results.empty() && report.results.front().embree;
    if (hasEmbree)
        fmt::print(" | Embree: {:>7} {:>8} {:>7} {:>8} | {:>6} {:>6}", "single", "packets", "robust",
                   "packets", "ratio", "robust");
    fmt::print("\n");
    for (const bench::TraceResult& result : report.results) {
        fmt::print("{:<8} {:>8} {:>9.2f} {:>10} {:>6}", result.rays, result.rayCount, result.mraysPerSecond,
                   result.mismatches, result.wrong);
        if (result.embree)
            fmt::print(" | {:>15.2f} {:>8.2f} {:>7.2f} {:>8.2f} | {:>6.2f} {:>6.2f}", result.embree->single,
                       result.embree->packet16, result.embree->robustSingle, result.embree->robustPacket16,
                       result.ratio, result.ratioRobust);
        fmt::print("\n");
    }
}

void print(const bench::BuildReport& report) {
    fmt::print(
        "{} triangles: {:.1f} ms (build {:.1f}, layout {:.1f}), {:.1f} bytes a triangle, SAH cost {:.2f}, "
        "depth {}\n",
        report.triangles, report.milliseconds, report.buildMilliseconds, report.layoutMilliseconds,
        report.bytesPerTriangle, report.sahCost, report.depth);
    if (report.embreeMedium)
        fmt::print("Embree, medium quality: {:.1f} ms; ratio {:.2f} (below 1: faster than Embree)\n",
                   *report.embreeMedium, report.ratio);
}

void print(const bench::RefitReport& report) {
    fmt::print(
        "{}, {} triangles: {:.2f} ms (TriangleShader {:.2f}, RefitTreeShader {:.2f}); VertexShader, not in "
        "it, {:.2f} ms\n",
        report.device, report.triangles, report.milliseconds, report.triangleShader, report.refitTreeShader,
        report.vertexShader);
    if (report.embreeRefit)
        fmt::print("Embree, refit quality: {:.2f} ms; ratio {:.2f} (below 1: faster than Embree)\n",
                   *report.embreeRefit, report.ratio);
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

void addCommonOptions(CLI::App& command, Arguments& arguments) {
    command.add_option("file", arguments.file,
                       "A model or a .prizma project; without: a scene of 800,000 triangles");
    command.add_flag("--json", arguments.json, "Print JSON for scripts");
    command.add_flag("--instanced", arguments.instanced,
                     "Without a file: ten objects that share four meshes, instead of one mesh");
    command.add_option("--repeats", arguments.repeats, "Measurements of which the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

void addTraceCommand(CLI::App& bench) {
    auto* command =
        bench.add_subcommand("trace", "How fast camera, diffuse bounce and shadow rays are traced");
    const auto arguments = std::make_shared<Arguments>();
    addCommonOptions(*command, *arguments);
    command->add_option("--device", arguments->trace.deviceId, "OpenCL device, as \"devices\" lists it");
    command->add_option("--width", arguments->trace.width, "Of the picture whose camera rays are traced")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    command->add_option("--height", arguments->trace.height, "Its height")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    command->callback([arguments] {
        arguments->trace.repeats = arguments->repeats;
        show(bench::benchTrace(sceneOf(*arguments), arguments->trace), arguments->json);
    });
}

TreeLayout layoutOf(const std::string& name) {
    return name == "binary2" ? TreeLayout::Binary2 : TreeLayout::Wide8;
}

void addRefitCommand(CLI::App& bench) {
    auto* command = bench.add_subcommand("refit", "How fast the trees follow vertices that move");
    const auto arguments = std::make_shared<Arguments>();
    arguments->layout.clear();
    addCommonOptions(*command, *arguments);
    command->add_option("--device", arguments->trace.deviceId, "OpenCL device, as \"devices\" lists it");
    command->add_option("--layout", arguments->layout, "The trees' layout; without: what suits the device")
        ->check(CLI::IsMember({"wide8", "binary2"}));
    command->callback([arguments] {
        bench::RefitBenchOptions options;
        options.deviceId = arguments->trace.deviceId;
        options.repeats = arguments->repeats;
        if (!arguments->layout.empty())
            options.layout = layoutOf(arguments->layout);
        show(bench::benchRefit(sceneOf(*arguments), options), arguments->json);
    });
}

void addBuildCommand(CLI::App& bench) {
    auto* command = bench.add_subcommand("build", "How fast the bottom-level trees are built");
    const auto arguments = std::make_shared<Arguments>();
    addCommonOptions(*command, *arguments);
    command->add_option("--layout", arguments->layout, "The tree that is laid out: of CPU or of GPU devices")
        ->check(CLI::IsMember({"wide8", "binary2"}))
        ->capture_default_str();
    command->callback([arguments] {
        bench::BuildBenchOptions options;
        options.layout = layoutOf(arguments->layout);
        options.repeats = arguments->repeats;
        show(bench::benchBuild(sceneOf(*arguments), options), arguments->json);
    });
}

} // namespace

void addBenchCommand(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Measurements, beside Embree's where it is built in");
    command->require_subcommand(1);
    addTraceCommand(*command);
    addBuildCommand(*command);
    addRefitCommand(*command);
    addAnimationBenches(*command);
}

} // namespace prizma
