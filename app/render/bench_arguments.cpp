#include "app/render/bench_arguments.h"

#include "app/render/load_scene.h"

namespace prizma {

void addCommonOptions(CLI::App& command, BenchArguments& arguments) {
    command.add_option("file", arguments.file,
                       "A model or a .prizma project; without: a scene of 800,000 triangles");
    command.add_flag("--json", arguments.json, "Print JSON for scripts");
    command.add_flag("--instanced", arguments.instanced,
                     "Without a file: ten objects that share four meshes, instead of one mesh");
    command.add_option("--triangles", arguments.triangles, "Without a file: about how many the scene has")
        ->check(CLI::Range(std::size_t{1000}, std::size_t{10000000}))
        ->capture_default_str();
    command.add_option("--repeats", arguments.repeats, "Measurements of which the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

Scene sceneOf(const BenchArguments& arguments) {
    if (arguments.file.empty())
        return bench::makeProceduralScene(arguments.instanced ? bench::ProceduralForm::Instances
                                                              : bench::ProceduralForm::OneMesh,
                                          arguments.triangles);
    auto scene = loadScene(arguments.file, {}, 16.0 / 9.0);
    if (!scene)
        fail(scene.error());
    return std::move(*scene);
}

} // namespace prizma
