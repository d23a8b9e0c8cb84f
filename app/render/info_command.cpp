#include "app/render/command.h"
#include "app/render/load_scene.h"
#include "core/animation/posed_bounds.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <set>

namespace prizma {
namespace {

using Json = nlohmann::ordered_json;

std::size_t mostWeights(const Mesh& mesh) {
    std::size_t most = 0;
    for (std::size_t i = 0; i + 1 < mesh.firstInfluence.size(); ++i)
        most = std::max<std::size_t>(most, mesh.firstInfluence[i + 1] - mesh.firstInfluence[i]);
    return most;
}

Json texturesOf(const Scene& scene) {
    std::map<std::string, bool> found;
    const auto add = [&found](const Texture& texture) {
        if (texture.isSet())
            found[texture.file] = texture.image != nullptr;
    };
    for (const Material& material : scene.materials) {
        add(material.baseColorTexture);
        add(material.normalTexture);
    }
    add(scene.background.image);
    Json list = Json::array();
    for (const auto& [file, isFound] : found)
        list.push_back({{"file", file}, {"found", isFound}});
    return list;
}

/// Sums over the objects; a mesh that several objects share counts for each of them, as it is seen.
void addGeometry(const Scene& scene, Json& info) {
    std::size_t triangles = 0;
    std::size_t vertices = 0;
    std::size_t bones = 0;
    std::size_t weights = 0;
    Json clips = Json::array();
    std::set<const Clip*> listed;
    for (const Object& object : scene.objects) {
        for (const ClipPtr& clip : object.clips)
            if (listed.insert(clip.get()).second)
                clips.push_back({{"name", clip->name}, {"frames", clip->frameCount}, {"fps", clip->fps}});
        if (!object.mesh)
            continue;
        triangles += object.mesh->triangles.size();
        vertices += object.mesh->positions.size();
        bones += object.mesh->skeleton ? object.mesh->skeleton->bones.size() : 0;
        weights = std::max(weights, mostWeights(*object.mesh));
    }
    info["triangles"] = triangles;
    info["vertices"] = vertices;
    info["bones"] = bones;
    info["maxWeights"] = weights;
    info["clips"] = clips;
}

template <class List>
Json namesOf(const List& list) {
    Json names = Json::array();
    for (const auto& item : list)
        names.push_back(item.name);
    return names;
}

Json describeContents(const std::vector<std::string>& files, const LoadedFiles& contents) {
    const Scene& scene = contents.scene;
    Json info{{"file", files.front()}, {"kind", contents.isProject ? "project" : "model"}};
    addGeometry(scene, info);
    info["materials"] = namesOf(scene.materials);
    info["textures"] = texturesOf(scene);
    info["lights"] = scene.lights.size();
    info["objects"] = namesOf(scene.objects);
    if (const DBounds bounds = worldBounds(scene); !bounds.isEmpty())
        info["bounds"] = {{"low", {bounds.low.x, bounds.low.y, bounds.low.z}},
                          {"high", {bounds.high.x, bounds.high.y, bounds.high.z}}};
    info["warnings"] = Json::array();
    for (const Diagnostic& warning : contents.warnings)
        info["warnings"].push_back(describe(warning));
    return info;
}

void printNames(const char* title, const Json& names) {
    std::cout << title << names.size();
    for (std::size_t i = 0; i < names.size(); ++i)
        std::cout << (i == 0 ? ": " : ", ") << names[i].get<std::string>();
    std::cout << '\n';
}

void printForPeople(const Json& info) {
    std::cout << info["file"].get<std::string>() << " (" << info["kind"].get<std::string>() << ")\n"
              << "triangles  " << info["triangles"] << "\nvertices   " << info["vertices"] << '\n';
    if (info.contains("bounds")) {
        const auto& low = info["bounds"]["low"];
        const auto& high = info["bounds"]["high"];
        std::printf("size       %g × %g × %g\n", high[0].get<double>() - low[0].get<double>(),
                    high[1].get<double>() - low[1].get<double>(),
                    high[2].get<double>() - low[2].get<double>());
        std::fflush(stdout);
    }
    printNames("objects    ", info["objects"]);
    printNames("materials  ", info["materials"]);
    std::cout << "lights     " << info["lights"] << '\n';
    if (info["bones"] > 0)
        std::cout << "bones      " << info["bones"] << ", up to " << info["maxWeights"] << " a vertex\n";
    for (const Json& clip : info["clips"])
        std::cout << "clip       " << clip["name"].get<std::string>() << ": " << clip["frames"]
                  << " frames at " << clip["fps"] << " a second\n";
    for (const Json& texture : info["textures"])
        std::cout << "texture    " << texture["file"].get<std::string>()
                  << (texture["found"].get<bool>() ? "" : " (missing)") << '\n';
    for (const Json& warning : info["warnings"])
        std::cout << "warning    " << warning.get<std::string>() << '\n';
}

struct Options {
    std::vector<std::string> files;
    bool json = false;
};

void runInfo(const Options& options) {
    const auto contents = loadFiles(options.files);
    if (!contents)
        fail(contents.error());
    const Json info = describeContents(options.files, *contents);
    if (options.json)
        std::cout << info.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        printForPeople(info);
}

} // namespace

void addInfoCommand(CLI::App& app) {
    auto* command = app.add_subcommand("info", "What a model or project holds, and its warnings");
    const auto options = std::make_shared<Options>();
    command
        ->add_option("files", options->files,
                     "A .prizma project, or a model; animations may follow that belong to it")
        ->required();
    command->add_flag("--json", options->json, "Print JSON for scripts");
    command->callback([options] { runInfo(*options); });
}

} // namespace prizma
