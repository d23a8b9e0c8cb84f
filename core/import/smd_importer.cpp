#include "core/import/smd_importer.h"

#include "core/import/file_finder.h"
#include "core/import/smd_model_builder.h"
#include "core/import/smd_reader.h"
#include "core/import/text_file.h"

#include <filesystem>

namespace prizma {
namespace {

namespace fs = std::filesystem;

std::string stemOf(const std::string& file) {
    return fs::path(file).stem().string();
}

std::string folderOf(const std::string& file) {
    return fs::path(file).parent_path().string();
}

Result<SmdFile> readSmdFile(const std::string& file, const ProgressPart& progress) {
    const auto text = readTextFile(file, mostModelBytes);
    if (!text)
        return std::unexpected(text.error());
    return readSmd(*text, file, progress);
}

/// A reference with several frames moves by itself.
Result<void> addOwnClip(SmdModelBuilder& builder, const SmdFile& smd, const SmdSpace& space,
                        const std::string& file) {
    Diagnostics told; // with the body already
    const auto skeleton = makeSmdSkeleton(smd, space, file, told);
    if (!skeleton)
        return std::unexpected(skeleton.error());
    auto clip = makeSmdClip(smd, space, file, builder.warnings());
    if (!clip)
        return std::unexpected(clip.error());
    clip->name = stemOf(file);
    builder.addClip(std::move(*clip), skeleton->skeleton, file);
    return {};
}

Result<void> addBody(SmdModelBuilder& builder, const SmdFile& smd, const ImportOptions& options,
                     const std::string& file) {
    if (!smd.hasTriangles)
        return failure(std::string(animationIsNoModel), file);
    if (smd.corners.empty())
        return failure("There are no triangles in it.", file);
    const SmdSpace space{options.upAxis, options.unitScale};
    if (smd.frameCount == 0)
        builder.warnings().push_back(
            {Severity::Warning, "The skeleton has no frame, so that the bones have no places of their own.",
             file, 0});
    if (auto done = builder.addBody(smd, space, file); !done)
        return done;
    builder.buildMesh();
    return smd.frameCount > 1 ? addOwnClip(builder, smd, space, file) : Result<void>();
}

void addFlexesBeside(SmdModelBuilder& builder, const std::string& file, const ProgressPart& progress) {
    const auto vtaFile = findFile(folderOf(file), stemOf(file) + ".vta");
    if (!vtaFile)
        return;
    const auto text = readTextFile(*vtaFile, mostModelBytes);
    const auto vta = text ? readVta(*text, *vtaFile, progress) : std::unexpected(text.error());
    if (vta)
        builder.addFlexes(0, *vta, {}, *vtaFile);
    else
        builder.warnings().push_back({Severity::Warning, "The flexes were left out: " + vta.error().message,
                                      *vtaFile, vta.error().line});
}

} // namespace

Result<ImportedModel> buildSmdModel(const SmdFile& smd, const std::string& file,
                                    const ImportOptions& options) {
    SmdModelBuilder builder;
    if (auto done = addBody(builder, smd, options, file); !done)
        return std::unexpected(done.error());
    return builder.finish(nullptr);
}

Result<ImportedModel> importSmd(const std::string& file, const ImportOptions& options, Progress& progress) {
    const ProgressPart whole(progress);
    const auto smd = readSmdFile(file, whole.part(0.0, 0.6));
    if (!smd)
        return std::unexpected(smd.error());
    SmdModelBuilder builder;
    if (auto done = addBody(builder, *smd, options, file); !done)
        return std::unexpected(done.error());
    addFlexesBeside(builder, file, whole.part(0.8, 0.9));
    if (progress.isCancelled())
        return failure("The import was cancelled.", file);
    TextureFinder textures({folderOf(file)});
    return builder.finish(&textures);
}

Result<SmdAnimation> importSmdAnimation(const std::string& file, const SmdSpace& space,
                                        const ProgressPart& progress) {
    auto smd = readSmdFile(file, progress);
    if (!smd)
        return std::unexpected(smd.error());
    SmdAnimation animation;
    animation.warnings = std::move(smd->warnings);
    auto skeleton = makeSmdSkeleton(*smd, space, file, animation.warnings);
    if (!skeleton)
        return std::unexpected(skeleton.error());
    animation.skeleton = std::move(skeleton->skeleton);
    auto clip = makeSmdClip(*smd, space, file, animation.warnings);
    if (!clip)
        return std::unexpected(clip.error());
    animation.clip = std::move(*clip);
    animation.clip.name = stemOf(file);
    return animation;
}

} // namespace prizma
