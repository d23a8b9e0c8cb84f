#include "app/render/command.h"

#include "app/render/load_scene.h"
#include "core/animation/clip_time.h"
#include "core/animation/pose_key.h"
#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/file_space.h"
#include "core/render/posed_mesh.h"
#include "core/scene/properties.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace prizma {
namespace {

struct PoseArguments {
    std::vector<std::string> files, animations;
    std::string clip, output, object, device, upAxis;
    std::vector<std::string> assignments;
    double frame = 0.0;
    bool json = false;
};

/// The object that was asked for: by its name, or else the first one that has the clip, or else the first
/// one.
Result<Id> chooseObject(const Scene& scene, const PoseArguments& arguments) {
    const auto find = [&](auto&& suits) -> const Object* {
        const auto found = std::ranges::find_if(
            scene.objects, [&](const Object& object) { return object.mesh && suits(object); });
        return found == scene.objects.end() ? nullptr : &*found;
    };
    const Object* chosen = nullptr;
    if (!arguments.object.empty()) {
        chosen = find([&](const Object& object) { return object.name == arguments.object; });
        if (!chosen)
            return failure("There is no object \"" + arguments.object + "\" with a mesh.");
        return chosen->id;
    }
    chosen = find([&](const Object& object) { return findClip(object, arguments.clip) != nullptr; });
    if (!chosen)
        chosen = find([](const Object&) { return true; });
    if (!chosen)
        return failure("There is no object with a mesh.");
    return chosen->id;
}

Result<Scene> prepareScene(const PoseArguments& arguments, Id& chosen) {
    std::vector<std::string> files = arguments.files;
    files.insert(files.end(), arguments.animations.begin(), arguments.animations.end());
    auto scene = loadScene(files, arguments.upAxis, 1.0);
    if (!scene)
        return scene;
    for (const std::string& assignment : arguments.assignments)
        if (auto ok = applyAssignment(*scene, assignment); !ok)
            return std::unexpected(ok.error());
    const auto id = chooseObject(*scene, arguments);
    if (!id)
        return std::unexpected(id.error());
    chosen = *id;
    for (Object& object : scene->objects.edit()) {
        object.visible = object.id == chosen;
        if (!object.visible)
            continue;
        object.parent = noId; // out of the reach of a hidden group; poses are in object space
        auto held = holdFrame(object, arguments.clip, arguments.frame);
        if (!held)
            return std::unexpected(held.error());
        object = std::move(*held);
        object.dynamic = true;
    }
    return scene;
}

nlohmann::ordered_json toJson(const PosedMesh& posed, const Object& object, const PoseArguments& arguments,
                              const std::string& device) {
    Bounds bounds;
    for (const glm::vec3& position : posed.positions)
        bounds.add(position);
    return {{"file", arguments.output},
            {"device", device},
            {"object", object.name},
            {"clip", arguments.clip},
            {"frame", arguments.frame},
            {"vertices", posed.positions.size()},
            {"triangles", posed.mesh->triangles.size()},
            {"bounds",
             {{"low", {bounds.low.x, bounds.low.y, bounds.low.z}},
              {"high", {bounds.high.x, bounds.high.y, bounds.high.z}}}}};
}

void run(const PoseArguments& arguments) {
    const std::string extension = lowerExtension(arguments.output);
    if (extension != "csv" && extension != "obj")
        fail({Severity::Error, "the output must end in .obj or .csv", arguments.output, 0});
    Id id = noId;
    const auto scene = prepareScene(arguments, id);
    if (!scene)
        fail(scene.error());
    RendererOptions options;
    options.deviceId = arguments.device;
    const auto renderer = Renderer::create(std::move(options));
    if (!renderer)
        fail(renderer.error());
    const auto posed = computePosedMesh(**renderer, *scene, id);
    if (!posed)
        fail(posed.error());
    const Object& object = *scene->findObject(id);
    const glm::dmat4 toFile = glm::inverse(fileToObject(object.source.upAxis, object.source.unitScale));
    const std::string text = extension == "csv" ? formatCsv(*posed, toFile) : formatObj(*posed, object.name);
    if (auto ok = replaceFile(absolutePath(arguments.output), text); !ok)
        fail(ok.error());
    if (arguments.json)
        fmt::print("{}\n", toJson(*posed, object, arguments, (*renderer)->device().name).dump(2));
}

} // namespace

void addPoseCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("pose", "The mesh of an object in a pose, as the device computed it");
    const auto a = std::make_shared<PoseArguments>();
    command
        ->add_option("files", a->files,
                     "A .prizma project, or a model; animations may follow that belong to it")
        ->required();
    command->add_option("--animation", a->animations, "Animation files that belong to the model");
    command->add_option("--clip", a->clip, "Name of the clip; without: the bind pose");
    command->add_option("--frame", a->frame, "Frame of the clip, from 0; may lie between two")
        ->capture_default_str();
    command
        ->add_option(
            "-o,--output", a->output,
            "File to write: .csv (a line x,y,z a triangle corner, in the space and order of the model's "
            "file) or .obj (Y up)")
        ->required();
    command->add_option("--object", a->object, "Which object; without: the first that has the clip");
    command->add_option("--device", a->device, "OpenCL device, as \"devices\" lists it");
    command->add_option("--up", a->upAxis, "Up axis of a bare model; without: what is usual for its format")
        ->check(CLI::IsMember({"y", "z"}));
    command->add_option("--set", a->assignments,
                        "Change a property, for example objects.face.morph:smile=0.5");
    command->add_flag("--json", a->json, "Print what was written as JSON");
    command->callback([a] { run(*a); });
}

} // namespace prizma
