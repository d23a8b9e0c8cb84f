#include "app/render/bench_frame.h"

#include "app/render/bench_arguments.h"
#include "app/render/load_scene.h"
#include "app/render/pass_times.h"
#include "core/bench/frame_bench.h"

#include <fmt/format.h>

#include <memory>

namespace prizma {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments : BenchArguments {
    bench::FrameBenchOptions frame;
};

Json toJson(const bench::FrameResult& frame) {
    Json rays = Json::array();
    for (const bench::FrameRays& set : frame.rays)
        rays.push_back({{"rays", set.rays},
                        {"count", set.count},
                        {"packets", set.inPackets},
                        {"milliseconds", set.milliseconds}});
    return {{"shader", frame.shader},
            {"width", frame.width},
            {"height", frame.height},
            {"milliseconds", frame.milliseconds},
            {"framesPerSecond", frame.framesPerSecond()},
            {"pass", toJson(frame.times)},
            {"rays", std::move(rays)},
            {"raysMilliseconds", frame.raysMilliseconds},
            {"ratio", frame.ratio},
            {"nonFinitePixels", frame.nonFinitePixels}};
}

Json toJson(const bench::FrameReport& report) {
    Json frames = Json::array();
    for (const bench::FrameResult& frame : report.frames)
        frames.push_back(toJson(frame));
    return {{"device", report.device}, {"triangles", report.triangles}, {"frames", std::move(frames)}};
}

void print(const bench::FrameReport& report) {
    fmt::print("{}, {} triangles, one point light; medians of a sample a pixel\n", report.device,
               report.triangles);
    for (const bench::FrameResult& frame : report.frames) {
        fmt::print("{}, {} x {}: {:.1f} ms ({:.1f} frames a second), {:.2f} times what its rays cost\n",
                   frame.shader, frame.width, frame.height, frame.milliseconds, frame.framesPerSecond(),
                   frame.ratio);
        fmt::print("    {}\n", describe(frame.times));
        fmt::print("    the rays by themselves {:.1f} ms:", frame.raysMilliseconds);
        for (const bench::FrameRays& set : frame.rays)
            fmt::print(" {} {} in {:.1f} ({}){}", set.count, set.rays, set.milliseconds,
                       set.inPackets ? "packets" : "singly", &set == &frame.rays.back() ? "\n" : ",");
        if (frame.nonFinitePixels > 0)
            fmt::print("    {} pixels that were no numbers\n", frame.nonFinitePixels);
    }
}

} // namespace

void addFrameBench(CLI::App& bench) {
    auto* command = bench.add_subcommand(
        "frame",
        "What a sample of Whitted and of Path (four bounces) takes, and what its rays take by themselves");
    const auto arguments = std::make_shared<Arguments>();
    addCommonOptions(*command, *arguments);
    command->add_option("--device", arguments->frame.deviceId, "OpenCL device, as \"devices\" lists it");
    command->add_option("--width", arguments->frame.width, "Of the picture")->check(CLI::Range(1, 16384));
    command
        ->add_option("--height", arguments->frame.height,
                     "Of the picture; without: 1280 x 720 or, on graphics cards, 1920 x 1080")
        ->check(CLI::Range(1, 16384));
    command->add_option(
        "--export", arguments->frame.exportTo,
        "Write the scene as OBJ, and its camera and light as JSON beside it, for other renderers");
    command->callback([arguments] {
        arguments->frame.repeats = arguments->repeats;
        const auto report = bench::benchFrame(sceneOf(*arguments), arguments->frame);
        if (!report)
            fail(report.error());
        if (arguments->json)
            fmt::print("{}\n", toJson(*report).dump(2));
        else
            print(*report);
    });
}

} // namespace prizma
