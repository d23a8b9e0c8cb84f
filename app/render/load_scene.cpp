#include "app/render/load_scene.h"

#include "core/import/model_importer.h"
#include "core/project/project_file.h"
#include "core/scene/starter_scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>

namespace prizma {
namespace {

void warn(const Diagnostics& warnings) {
    for (const Diagnostic& warning : warnings)
        fmt::print(stderr, "prizma-render: warning: {}\n", describe(warning));
}

} // namespace

void fail(const Diagnostic& error) {
    fmt::print(stderr, "prizma-render: {}\n", describe(error));
    throw CLI::RuntimeError(1);
}

Result<Scene> loadScene(const std::string& file, const std::string& upAxis, double aspect) {
    const std::string path = std::filesystem::absolute(file).string();
    Progress progress;
    if (std::filesystem::path(file).extension() == ".prizma") {
        auto project = loadProject(path, progress);
        if (!project)
            return std::unexpected(project.error());
        warn(project->warnings);
        return std::move(project->scene);
    }
    ImportOptions options;
    options.upAxis = upAxis == "z" ? UpAxis::Z : UpAxis::Y;
    const auto model = importModel(path, options, progress);
    if (!model)
        return std::unexpected(model.error());
    warn(model->warnings);
    Scene scene;
    MeshSource source;
    source.file = path;
    source.upAxis = options.upAxis;
    addModel(scene, *model, source);
    presentModel(scene, aspect);
    return scene;
}

} // namespace prizma
