#include "app/render/command.h"

#include "app/render/load_scene.h"
#include "app/render/pass_times.h"
#include "core/import/file_finder.h"
#include "core/render/picture_sequence.h"
#include "core/render/video_encoder.h"
#include "core/scene/properties.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
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
    std::string video;
    int depth = 8;
    bool overwrite = false, statistics = false, json = false;
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
          {"shade", t.shade},
          {"pass", toJson(p.passTimes)}}},
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
    fmt::print("{}\n", describe(p.passTimes));
    fmt::print("{} pixels that were no numbers\n", p.nonFinitePixels);
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

void report(const OfflinePicture& picture, const RenderArguments& arguments, const std::string& device,
            const std::string& file) {
    if (arguments.json)
        fmt::print("{}\n", toJson(picture, device, file).dump(2));
    else if (arguments.statistics)
        printStatistics(picture, device);
}

void renderPicture(Renderer& renderer, const Scene& scene, const RenderArguments& arguments,
                   double compileMilliseconds) {
    auto picture = renderOffline(renderer, scene, arguments.options);
    if (!picture)
        fail(picture.error());
    picture->times.compile += compileMilliseconds;
    picture->times.total += compileMilliseconds;
    if (auto ok = savePicture(*picture, arguments.output); !ok)
        fail(ok.error());
    report(*picture, arguments, renderer.device().name, arguments.output);
}

void makeVideo(const SequenceOptions& frames, const RenderArguments& arguments, double fps) {
    VideoOptions options;
    for (int frame = frames.first; frame <= frames.last; ++frame)
        options.pictures.push_back(frameFile(frames.output, frame));
    options.fps = fps;
    options.output = arguments.video;
    Progress progress;
    if (auto ok = encodeVideo(options, progress); !ok)
        fail(ok.error());
}

/// What can be known to be wrong before hours of rendering.
std::string findVideoFault(const SequenceOptions& frames, const RenderArguments& arguments, double fps) {
    if (arguments.video.empty())
        return {};
    return findFault(VideoOptions{{frameFile(frames.output, frames.first)}, fps, arguments.video});
}

void renderFrames(Renderer& renderer, const Scene& scene, const RenderArguments& arguments) {
    const auto range = parseFrames(arguments.frames);
    if (!range)
        fail(range.error());
    SequenceOptions options{arguments.options, range->first, range->second, arguments.output,
                            arguments.overwrite};
    const double fps = scene.timeline.fps;
    if (const std::string fault = findVideoFault(options, arguments, fps); !fault.empty())
        fail({Severity::Error, fault, arguments.video, 0});
    if (!arguments.video.empty() && !isVideoEncoderInstalled()) // not after hours of rendering
        fail(missingVideoEncoder());
    const int count = options.last - options.first + 1;
    Progress progress;
    const auto summary = renderSequence(renderer, scene, options, progress, [&](const SequenceFrame& done) {
        if (done.picture)
            report(*done.picture, arguments, renderer.device().name, done.file);
        fmt::print(stderr, "{} of {}: {}{}\n", done.frame - options.first + 1, count, done.file,
                   done.picture ? "" : " is there already");
    });
    if (!summary)
        fail(summary.error());
    if (!arguments.video.empty())
        makeVideo(options, arguments, fps);
}

void run(RenderArguments& arguments) {
    const std::string extension = lowerExtension(arguments.output);
    if (extension != "png" && extension != "exr")
        fail({Severity::Error, "the output must end in .png or .exr", arguments.output, 0});
    if (arguments.depth == 16 && extension == "exr")
        fail({Severity::Error, "--depth is for PNG: an EXR file has 32 bits a channel", arguments.output, 0});
    arguments.options.deep = arguments.depth == 16;
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
    if (arguments.frames.empty())
        renderPicture(**renderer, *scene, arguments, compile);
    else
        renderFrames(**renderer, *scene, arguments);
}

} // namespace

void addRenderCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Render a picture of a project or of a bare model");
    auto a = std::make_shared<RenderArguments>();
    command
        ->add_option("files", a->files,
                     "A .prizma project, or a model; animations may follow that belong to it")
        ->required();
    command
        ->add_option("-o,--output", a->output,
                     "Picture to write: .png (exposure and view transform applied, sRGB) or .exr (linear)")
        ->required();
    command->add_option("--depth", a->depth, "Bits a channel of a PNG file: 8 or 16")
        ->check(CLI::IsMember({8, 16}))
        ->capture_default_str();
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
    CLI::Option* frames =
        command
            ->add_option(
                "--frames", a->frames,
                "Frames FIRST-LAST; #### in the output's name becomes the number. Frames whose file is "
                "there are left out")
            ->excludes(frame);
    command->add_flag("--overwrite", a->overwrite, "Render frames whose file is there, too")->needs(frames);
    command->add_option("--video", a->video, "Then make a video of the frames with ffmpeg: .mp4 or .webm")
        ->needs(frames);
    command->add_option("--shader", a->shader,
                        "whitted, path, normals, texcoords, depth, material, object or cost");
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
