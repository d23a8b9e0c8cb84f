#include "core/import/animation_importer.h"

#include "core/import/assimp_importer.h"
#include "core/import/clip_pairing.h"
#include "core/import/file_finder.h"
#include "core/import/qc_importer.h"
#include "core/import/smd_importer.h"
#include "core/import/smd_reader.h"
#include "core/import/text_file.h"

#include <algorithm>
#include <filesystem>

namespace prizma {
namespace {

/// Clips and the bones they were made for.
struct Motion {
    Skeleton skeleton;
    std::vector<ClipPtr> clips;
    Diagnostics warnings;
};

Result<Motion> readSmdMotion(const std::string& file, const MeshSource& source, Progress& progress) {
    SmdSpace space{source.upAxis, source.unitScale};
    if (lowerExtension(source.file) == "qc")
        space.scale *= spaceOfQc(source.file).scale;
    auto animation = importSmdAnimation(file, space, ProgressPart(progress));
    if (!animation)
        return std::unexpected(animation.error());
    return Motion{std::move(animation->skeleton),
                  {std::make_shared<Clip>(std::move(animation->clip))},
                  std::move(animation->warnings)};
}

Result<Motion> readMotion(const std::string& file, const MeshSource& source, Progress& progress) {
    const std::string extension = lowerExtension(file);
    const ImportOptions options{source.upAxis, source.unitScale};
    if (extension == "smd")
        return readSmdMotion(file, source, progress);
    if (extension == "qc") {
        auto model = importQcClips(file, options, progress);
        if (!model)
            return std::unexpected(model.error());
        return Motion{*model->mesh->skeleton, std::move(model->clips), std::move(model->warnings)};
    }
    auto animations = importAnimationsWithAssimp(file, options, progress);
    if (!animations)
        return std::unexpected(animations.error());
    return Motion{std::move(animations->skeleton), std::move(animations->clips), {}};
}

Result<void> checkFile(const std::string& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        return failure("There is no such file.", file);
    if (!std::filesystem::is_regular_file(status))
        return failure("It is no plain file.", file);
    const auto extensions = animationExtensions();
    if (std::ranges::find(extensions, lowerExtension(file)) == extensions.end())
        return failure("\"" + lowerExtension(file) + "\" is not a format of animations that can be read.",
                       file);
    return {};
}

} // namespace

Result<ImportedAnimation> importAnimation(const std::string& file, const Skeleton& skeleton,
                                          const MeshSource& source, Progress& progress) try {
    ImportedAnimation result;
    result.file = absolutePath(file);
    if (auto checked = checkFile(result.file); !checked)
        return std::unexpected(checked.error());
    auto motion = readMotion(result.file, source, progress);
    if (!motion)
        return std::unexpected(motion.error());
    if (motion->clips.empty())
        return failure("There is no animation in it.", result.file);
    const BonePairing pairing(motion->skeleton, skeleton);
    if (pairing.isEmpty())
        return failure("It has no bone in common with the model: it belongs to another one.", result.file);
    result.warnings = std::move(motion->warnings);
    std::ranges::move(pairing.warnings(result.file), std::back_inserter(result.warnings));
    for (const ClipPtr& clip : motion->clips)
        result.clips.push_back(std::make_shared<Clip>(pairing.apply(*clip)));
    progress.set(1.0);
    return result;
} catch (const std::bad_alloc&) {
    return failure("The animation does not fit into memory.", file);
}

void addAnimation(Object& object, const ImportedAnimation& animation) {
    const auto stemOf = [](const std::string& file) { return std::filesystem::path(file).stem(); };
    const bool again = std::ranges::find(object.clipFiles, animation.file) != object.clipFiles.end();
    // Of two files of one name nobody knows which clip came from which.
    const bool replaces = again && std::ranges::count(object.clipFiles, stemOf(animation.file), stemOf) == 1;
    if (!again)
        object.clipFiles.push_back(animation.file);
    std::string first;
    for (const ClipPtr& clip : animation.clips) {
        Clip named = *clip;
        const auto same = std::ranges::find_if(
            object.clips, [&](const ClipPtr& other) { return other->name == clip->name; });
        if (replaces && same != object.clips.end()) {
            *same = clip;
        } else {
            named.name = freeClipName(object.clips, clip->name);
            object.clips.push_back(std::make_shared<Clip>(named));
        }
        if (first.empty())
            first = named.name;
    }
    if (object.clip.empty())
        object.clip = first;
    object.dynamic = true;
}

bool isAnimationFile(const std::string& file) {
    const std::string extension = lowerExtension(file);
    if (extension != "smd")
        return extension == "md5anim";
    const auto text = readTextFile(file, mostModelBytes);
    return text && isSmdAnimation(*text);
}

std::vector<std::string> animationExtensions() {
    return {"smd", "qc", "md5anim", "gltf", "glb", "fbx", "dae", "md5mesh", "blend", "x", "b3d", "ms3d"};
}

} // namespace prizma
