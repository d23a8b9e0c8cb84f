#include "core/import/import_batch.h"

#include "core/import/file_finder.h"
#include "core/import/qc_importer.h"

#include <filesystem>
#include <optional>
#include <set>

namespace prizma {
namespace {

/// Reads an animation for whichever of the models it suits: the fewer warnings, the better.
Result<void> addToBestModel(const std::string& file, std::vector<BatchModel>& models, Progress& progress) {
    std::optional<ImportedAnimation> best;
    BatchModel* bestModel = nullptr;
    Diagnostic fault{
        Severity::Error,
        "There is no model with bones that the animation could be for: import one together with it, "
        "or select it first.",
        file, 0};
    for (BatchModel& model : models) {
        if (!model.model.mesh->skeleton)
            continue;
        auto animation = importAnimation(file, *model.model.mesh->skeleton, model.source, progress);
        if (!animation) {
            fault = animation.error();
        } else if (!best || animation->warnings.size() < best->warnings.size()) {
            best = std::move(*animation);
            bestModel = &model;
        }
    }
    if (!best)
        return std::unexpected(fault);
    bestModel->animations.push_back(std::move(*best));
    return {};
}

std::string withoutExtension(const std::string& file) {
    return std::filesystem::path(absolutePath(file)).replace_extension().string();
}

} // namespace

BatchFiles sortFiles(const std::vector<std::string>& files) {
    std::set<std::string> included; // they come with another file
    for (const std::string& file : files) {
        const std::string extension = lowerExtension(file);
        if (extension == "smd")
            included.insert(withoutExtension(file) + ".vta");
        else if (extension == "qc")
            included.merge(filesOfQc(absolutePath(file)));
    }
    BatchFiles sorted;
    for (const std::string& file : files)
        if (!included.contains(absolutePath(file)))
            (isAnimationFile(file) ? sorted.animations : sorted.models).push_back(file);
    return sorted;
}

ImportBatch importBatch(const BatchFiles& files, const std::vector<ImportOptions>& options,
                        Progress& progress) {
    ImportBatch batch;
    const auto count = static_cast<double>(files.models.size() + files.animations.size());
    double done = 0.0;
    const auto nextPart = [&] {
        progress.beginPart(done / count, (done + 1.0) / count);
        done += 1.0;
    };
    for (std::size_t i = 0; i < files.models.size(); ++i) {
        nextPart();
        auto model = importModel(files.models[i], options[i], progress);
        if (!model) {
            batch.faults.push_back(model.error());
            continue;
        }
        MeshSource source;
        source.file = absolutePath(files.models[i]);
        source.upAxis = options[i].upAxis;
        source.unitScale = options[i].unitScale;
        batch.models.push_back({source, std::move(*model), {}});
    }
    if (!files.models.empty() && batch.models.empty())
        return batch; // the models' faults say it all
    for (const std::string& file : files.animations) {
        nextPart();
        if (auto added = addToBestModel(file, batch.models, progress); !added)
            batch.faults.push_back(added.error());
    }
    return batch;
}

Id addModel(Scene& scene, const BatchModel& model) {
    const Id id = addModel(scene, model.model, model.source);
    for (Object& object : scene.objects.edit())
        if (object.id == id)
            for (const ImportedAnimation& animation : model.animations)
                addAnimation(object, animation);
    return id;
}

Diagnostics warningsOf(const BatchModel& model) {
    Diagnostics warnings = model.model.warnings;
    for (const ImportedAnimation& animation : model.animations)
        warnings.insert(warnings.end(), animation.warnings.begin(), animation.warnings.end());
    return warnings;
}

} // namespace prizma
