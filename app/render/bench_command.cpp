#include "app/render/bench_animation.h"
#include "app/render/bench_arguments.h"
#include "app/render/bench_frame.h"
#include "app/render/command.h"
#include "app/render/load_scene.h"
#include "core/bench/build_bench.h"
#include "core/bench/growth_bench.h"
#include "core/bench/refit_bench.h"
#include "core/bench/ruin_bench.h"
#include "core/bench/trace_bench.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace prizma {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments : BenchArguments {
    std::string layout = "wide8";
    bool ruin = false;
    double distance = 2.0;
    int parts = 200;
    bench::TraceBenchOptions trace;
};

Json toJson(const bench::TraceReport& report) {
    Json results = Json::array();
    for (const bench::TraceResult& result : report.results) {
        Json item{{"rays", result.rays},
                  {"width", result.width},
                  {"height", result.height},
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
    return {{"device", report.device},
            {"triangles", report.triangles},
            {"deviceBytes", report.deviceBytes},
            {"results", std::move(results)}};
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

Json toJson(const bench::RuinReport& report) {
    Json steps = Json::array();
    for (const bench::RuinStep& step : report.steps)
        steps.push_back({{"flown", step.flown},
                         {"wear", step.wear},
                         {"refitted", {{"camera", step.refitted.camera}, {"diffuse", step.refitted.diffuse}}},
                         {"rebuilt", {{"camera", step.rebuilt.camera}, {"diffuse", step.rebuilt.diffuse}}}});
    Json result{{"device", report.device}, {"triangles", report.triangles}, {"steps", std::move(steps)}};
    if (const auto& renewal = report.renewal)
        result["renewal"] = {{"frame", renewal->frame},
                             {"start", renewal->start},
                             {"during", renewal->during},
                             {"swap", renewal->swap},
                             {"build", renewal->build}};
    return result;
}

Json toJson(const bench::GrowthReport& report) {
    Json sizes = Json::array();
    for (const bench::GrowthRow& row : report.rows)
        sizes.push_back({{"triangles", row.build.triangles},
                         {"build", toJson(row.build)},
                         {"refit", toJson(row.refit)},
                         {"trace", toJson(row.trace)}});
    return {{"device", report.device}, {"sizes", std::move(sizes)}};
}

void print(const bench::TraceReport& report) {
    fmt::print("{}, {} triangles; Mrays/s, medians\n", report.device, report.triangles);
    fmt::print("{:<8} {:>9} {:>8} {:>9} {:>10} {:>6}", "rays", "picture", "count", "Mrays/s", "mismatches",
               "wrong");
    const bool hasEmbree = !report.results.empty() && report.results.front().embree;
    if (hasEmbree)
        fmt::print(" | Embree: {:>7} {:>8} {:>7} {:>8} | {:>6} {:>6}", "single", "packets", "robust",
                   "packets", "ratio", "robust");
    fmt::print("\n");
    for (const bench::TraceResult& result : report.results) {
        fmt::print("{:<8} {:>9} {:>8} {:>9.2f} {:>10} {:>6}", result.rays,
                   fmt::format("{}x{}", result.width, result.height), result.rayCount, result.mraysPerSecond,
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

void print(const bench::RuinReport& report) {
    fmt::print("{}, {} triangles in shards that fly apart; Mrays/s, medians\n", report.device,
               report.triangles);
    fmt::print("{:>6} {:>6} | camera: {:>8} {:>8} {:>6} | diffuse: {:>8} {:>8} {:>6}\n", "flown", "wear",
               "refitted", "rebuilt", "share", "refitted", "rebuilt", "share");
    for (const bench::RuinStep& step : report.steps)
        fmt::print("{:>6.3f} {:>6.2f} | {:>16.2f} {:>8.2f} {:>6.2f} | {:>17.2f} {:>8.2f} {:>6.2f}\n",
                   step.flown, step.wear, step.refitted.camera, step.rebuilt.camera,
                   step.refitted.camera / step.rebuilt.camera, step.refitted.diffuse, step.rebuilt.diffuse,
                   step.refitted.diffuse / step.rebuilt.diffuse);
    if (const auto& renewal = report.renewal)
        fmt::print(
            "A new tree in the background: a usual frame's update {:.1f} ms, the one that starts the "
            "build {:.1f}, the slowest meanwhile {:.1f}, the swap {:.1f}; {:.0f} ms from start to swap\n",
            renewal->frame, renewal->start, renewal->during, renewal->swap, renewal->build);
}

/// A time and, where Embree was measured, the ratio to its own.
std::string withRatio(double milliseconds, double ratio) {
    return ratio > 0.0 ? fmt::format("{:.2f} ({:.2f})", milliseconds, ratio)
                       : fmt::format("{:.2f}", milliseconds);
}

void print(const bench::GrowthReport& report) {
    fmt::print("{}; medians; in brackets ours over Embree's: times below 1 and rates above 1 are faster than "
               "Embree\n",
               report.device);
    fmt::print("{:>10} {:>16} {:>16} {:>9} {:>9} {:>16} {:>16} {:>16}\n", "triangles", "build ms", "refit ms",
               "tree B/t", "all B/t", "camera Mrays/s", "diffuse", "shadow");
    for (const bench::GrowthRow& row : report.rows) {
        fmt::print("{:>10} {:>16} {:>16} {:>9.1f} {:>9.1f}", row.build.triangles,
                   withRatio(row.build.milliseconds, row.build.ratio),
                   withRatio(row.refit.milliseconds, row.refit.ratio), row.build.bytesPerTriangle,
                   static_cast<double>(row.trace.deviceBytes) / static_cast<double>(row.trace.triangles));
        for (const bench::TraceResult& result : row.trace.results)
            fmt::print(" {:>16}", withRatio(result.mraysPerSecond, result.ratio));
        fmt::print("\n");
    }
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

void addTraceCommand(CLI::App& bench) {
    auto* command =
        bench.add_subcommand("trace", "How fast camera, diffuse bounce and shadow rays are traced");
    const auto arguments = std::make_shared<Arguments>();
    addCommonOptions(*command, *arguments);
    command->add_option("--device", arguments->trace.deviceId, "OpenCL device, as \"devices\" lists it");
    command->add_option("--width", arguments->trace.width, "Of the picture whose camera rays are traced")
        ->check(CLI::Range(1, 16384));
    command
        ->add_option(
            "--height", arguments->trace.height,
            "Its height; without: what suits the device, 1280 x 720 or, on graphics cards, 1920 x 1080 "
            "and 3840 x 2160")
        ->check(CLI::Range(1, 16384));
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
    command->add_flag(
        "--ruin", arguments->ruin,
        "Instead: how fast rays are while parts fly apart, with the refitted tree and a new one");
    command
        ->add_option("--distance", arguments->distance,
                     "With --ruin: how far they fly, in sizes of their object")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_option("--parts", arguments->parts, "With --ruin: of each object")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->callback([arguments] {
        if (arguments->ruin) {
            const bench::RuinBenchOptions ruin{arguments->trace.deviceId, arguments->parts,
                                               arguments->distance, arguments->repeats};
            show(bench::benchRuin(sceneOf(*arguments), ruin), arguments->json);
            return;
        }
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

void addGrowthCommand(CLI::App& bench) {
    auto* command = bench.add_subcommand(
        "growth", "How build, refit, memory and rays grow from 1,000 to 10,000,000 triangles; takes minutes");
    const auto arguments = std::make_shared<Arguments>();
    const auto options = std::make_shared<bench::GrowthBenchOptions>();
    command->add_flag("--json", arguments->json, "Print JSON for scripts");
    command->add_option("--device", options->deviceId, "OpenCL device, as \"devices\" lists it");
    command->add_option("--most", options->mostTriangles, "Of the largest scene, at most")
        ->check(CLI::Range(std::size_t{1000}, std::size_t{10000000}))
        ->capture_default_str();
    command->add_option("--repeats", options->repeats, "Measurements of which the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->callback([arguments, options] { show(bench::benchGrowth(*options), arguments->json); });
}

} // namespace

void addBenchCommand(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Measurements, beside Embree's where it is built in");
    command->require_subcommand(1);
    addTraceCommand(*command);
    addFrameBench(*command);
    addBuildCommand(*command);
    addRefitCommand(*command);
    addAnimationBenches(*command);
    addGrowthCommand(*command);
}

} // namespace prizma
