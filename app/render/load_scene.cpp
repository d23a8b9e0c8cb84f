#include "app/render/load_scene.h"

#include "core/import/file_finder.h"
#include "core/import/import_batch.h"
#include "core/project/project_file.h"
#include "core/scene/starter_scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace prizma {
namespace {

bool isProject(const std::string& file) {
    return lowerExtension(file) == "prizma";
}

Result<LoadedFiles> loadOneProject(const std::string& file) {
    Progress progress;
    auto project = loadProject(absolutePath(file), progress);
    if (!project)
        return std::unexpected(project.error());
    return LoadedFiles{std::move(project->scene), std::move(project->warnings), true};
}

Result<LoadedFiles> loadModels(const std::vector<std::string>& files, const std::string& upAxis) {
    const BatchFiles sorted = sortFiles(files);
    if (sorted.models.empty())
        return failure("It is an animation, not a model: name the model that it belongs to as well.",
                       files.front());
    std::vector<ImportOptions> options;
    for (const std::string& file : sorted.models)
        options.push_back({upAxis.empty() ? usualUpAxis(file) : upAxis == "z" ? UpAxis::Z : UpAxis::Y, 1.0});
    Progress progress;
    const ImportBatch batch = importBatch(sorted, options, progress);
    if (!batch.faults.empty())
        return std::unexpected(batch.faults.front());
    LoadedFiles loaded;
    for (const BatchModel& model : batch.models) {
        addModel(loaded.scene, model);
        std::ranges::move(warningsOf(model), std::back_inserter(loaded.warnings));
    }
    return loaded;
}

} // namespace

void fail(const Diagnostic& error) {
    fmt::print(stderr, "prizma-render: {}\n", describe(error));
    throw CLI::RuntimeError(1);
}

Result<LoadedFiles> loadFiles(const std::vector<std::string>& files, const std::string& upAxis) {
    if (files.size() == 1 && isProject(files.front()))
        return loadOneProject(files.front());
    if (const auto project = std::ranges::find_if(files, isProject); project != files.end())
        return failure("A project stands alone; what else is named with it belongs into it.", *project);
    return loadModels(files, upAxis);
}

Result<Scene> loadScene(const std::vector<std::string>& files, const std::string& upAxis, double aspect) {
    auto loaded = loadFiles(files, upAxis);
    if (!loaded)
        return std::unexpected(loaded.error());
    for (const Diagnostic& warning : loaded->warnings)
        fmt::print(stderr, "prizma-render: warning: {}\n", describe(warning));
    if (!loaded->isProject)
        presentModel(loaded->scene, aspect);
    return std::move(loaded->scene);
}

Result<Scene> loadScene(const std::string& file, const std::string& upAxis, double aspect) {
    return loadScene(std::vector{file}, upAxis, aspect);
}

} // namespace prizma
