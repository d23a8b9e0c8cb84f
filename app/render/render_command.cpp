#include "app/render/command.h"

#include "app/render/load_scene.h"
#include "core/import/image_loader.h"
#include "core/render/offline_render.h"
#include "core/scene/properties.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace prizma {
namespace {

struct RenderArguments {
    std::vector<std::string> files;
    std::string output, device, shader, upAxis;
    OfflineOptions options;
    double frame = 0.0;
    bool hasFrame = false;
    std::string frames;
    std::vector<std::string> assignments;
    bool statistics = false, json = false;
};

/// "3-17" as first and last frame.
Result<std::pair<int, int>> parseFrames(const std::string& text) {
    int first = 0;
    int last = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d-%d%c", &first, &last, &rest) != 2 || last < first)
        return failure("--frames wants FIRST-LAST, for example 0-24, not \"" + text + "\"");
    return std::pair(first, last);
}

/// The output's name for one frame: a run of # becomes the frame's number with as many digits.
std::string numbered(const std::string& output, int frame) {
    const auto first = output.find('#');
    const auto last = output.find_last_of('#');
    if (first == std::string::npos)
        return output;
    const auto width = static_cast<int>(last - first + 1);
    return output.substr(0, first) + fmt::format("{:0{}}", frame, width) + output.substr(last + 1);
}

Result<void> savePicture(const OfflinePicture& picture, const std::string& file) {
    if (std::filesystem::path(file).extension() == ".exr")
        return saveExr(file, picture.width, picture.height, picture.radiance);
    return savePng(file, picture.width, picture.height, picture.display);
}

nlohmann::ordered_json toJson(const OfflinePicture& p, const std::string& device, const std::string& file) {
    const OfflineTimes& t = p.times;
    return {
        {"file", file},
        {"device", device},
        {"width", p.width},
        {"height", p.height},
        {"samples", p.samples},
        {"nonFinitePixels", p.nonFinitePixels},
        {"error", p.error},
        {"milliseconds",
         {{"total", t.total},
          {"compile", t.compile},
          {"build", t.build},
          {"upload", t.upload},
          {"refit", t.refit},
          {"trace", t.trace},
          {"shade", t.shade}}},
        {"rays", {{"camera", p.rays.camera}, {"shadow", p.rays.shadow}, {"secondary", p.rays.secondary}}}};
}

void printStatistics(const OfflinePicture& p, const std::string& device) {
    const OfflineTimes& t = p.times;
    const double seconds = (t.trace + t.shade) / 1000.0;
    fmt::print("{}: {} x {} pixels, {} samples, estimated error {:.2g}\n", device, p.width, p.height,
               p.samples, p.error);
    fmt::print(
        "{:.0f} ms: compile {:.0f}, build {:.0f}, upload {:.0f}, refit {:.0f}, trace {:.0f}, shade {:.0f}\n",
        t.total, t.compile, t.build, t.upload, t.refit, t.trace, t.shade);
    fmt::print("{} camera, {} shadow and {} secondary rays: {:.1f} million a second\n", p.rays.camera,
               p.rays.shadow, p.rays.secondary,
               static_cast<double>(p.rays.total()) / std::max(seconds, 1e-9) * 1e-6);
}

Result<Scene> prepareScene(const RenderArguments& arguments) {
    const double aspect = static_cast<double>(arguments.options.width) / arguments.options.height;
    auto scene = loadScene(arguments.files, arguments.upAxis, aspect);
    if (!scene)
        return scene;
    if (!arguments.shader.empty())
        if (auto ok = setProperty(*scene, {EntityKind::Render}, "shader", arguments.shader); !ok)
            return std::unexpected(ok.error());
    for (const std::string& assignment : arguments.assignments)
        if (auto ok = applyAssignment(*scene, assignment); !ok)
            return std::unexpected(ok.error());
    if (arguments.hasFrame)
        scene->timeline.frame = arguments.frame;
    return scene;
}

void renderOne(Renderer& renderer, const Scene& scene, const RenderArguments& arguments,
               const std::string& output, double compileMilliseconds) {
    auto picture = renderOffline(renderer, scene, arguments.options);
    if (!picture)
        fail(picture.error());
    picture->times.compile += compileMilliseconds;
    picture->times.total += compileMilliseconds;
    if (auto ok = savePicture(*picture, output); !ok)
        fail(ok.error());
    if (arguments.json)
        fmt::print("{}\n", toJson(*picture, renderer.device().name, output).dump(2));
    else if (arguments.statistics)
        printStatistics(*picture, renderer.device().name);
}

void run(const RenderArguments& arguments) {
    auto extension = std::filesystem::path(arguments.output).extension().string();
    if (extension != ".png" && extension != ".exr")
        fail({Severity::Error, "the output must end in .png or .exr", arguments.output, 0});
    auto scene = prepareScene(arguments);
    if (!scene)
        fail(scene.error());
    const auto start = std::chrono::steady_clock::now();
    RendererOptions options;
    options.deviceId = arguments.device;
    auto renderer = Renderer::create(std::move(options));
    if (!renderer)
        fail(renderer.error());
    const double compile =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (arguments.frames.empty()) {
        renderOne(**renderer, *scene, arguments, arguments.output, compile);
        return;
    }
    const auto range = parseFrames(arguments.frames);
    if (!range)
        fail(range.error());
    if (range->first != range->second && arguments.output.find('#') == std::string::npos)
        fail({Severity::Error, "several frames need #### in the output's name", arguments.output, 0});
    for (int frame = range->first; frame <= range->second; ++frame) {
        scene->timeline.frame = frame;
        renderOne(**renderer, *scene, arguments, numbered(arguments.output, frame),
                  frame == range->first ? compile : 0.0);
    }
}

} // namespace

void addRenderCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Render a picture of a project or of a bare model");
    auto a = std::make_shared<RenderArguments>();
    command
        ->add_option("files", a->files,
                     "A .prizma project, or a model; animations may follow that belong to it")
        ->required();
    command->add_option("-o,--output", a->output, "Picture to write: .png or .exr")->required();
    command->add_option("--width", a->options.width, "Pixels across")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    command->add_option("--height", a->options.height, "Pixels down")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    command->add_option("--spp", a->options.samples, "Samples a pixel")->check(CLI::Range(1, 1000000));
    command->add_option("--time-limit", a->options.timeLimit, "Stop after this many seconds")
        ->check(CLI::PositiveNumber);
    command->add_option("--max-error", a->options.maxError, "Stop at this estimated error (relMSE)")
        ->check(CLI::PositiveNumber);
    CLI::Option* frame = command->add_option("--frame", a->frame, "Frame of the timeline");
    command
        ->add_option("--frames", a->frames, "Frames FIRST-LAST; #### in the output's name becomes the number")
        ->excludes(frame);
    command->add_option("--shader", a->shader, "whitted, normals, texcoords, depth or cost");
    command->add_option("--device", a->device, "OpenCL device, as \"devices\" lists it");
    command->add_option("--up", a->upAxis, "Up axis of a bare model; without: what is usual for the format")
        ->check(CLI::IsMember({"y", "z"}));
    command->add_option("--set", a->assignments, "Change a property, for example lights.key.intensity=80");
    command->add_flag("--stats", a->statistics, "Print what the picture took");
    command->add_flag("--json", a->json, "Print the statistics as JSON");
    command->callback([a, frame] {
        a->hasFrame = frame->count() > 0;
        run(*a);
    });
}

} // namespace prizma
