#include "core/import/model_importer.h"

#include "core/import/assimp_importer.h"
#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/qc_importer.h"
#include "core/import/smd_importer.h"
#include "core/import/text_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace prizma {
namespace {

constexpr std::array pictureExtensions{"png", "jpg", "jpeg", "bmp", "tga", "gif",
                                       "psd", "hdr", "exr",  "tif", "tiff"};

template <class List>
bool contains(const List& list, const std::string& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
}

/// Why `file` cannot be a model, judged by its name and, for OBJ, a look at its bytes.
Result<void> checkFile(const std::string& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        return failure("There is no such file.", file);
    if (std::filesystem::is_directory(status))
        return failure("It is a directory, not a model file.", file);
    const std::string extension = lowerExtension(file);
    if (extension == "vta")
        return failure("It holds flexes, not a model: import the SMD of the same name beside it, which takes "
                       "them in.",
                       file);
    if (extension == "md5anim")
        return failure(std::string(animationIsNoModel), file);
    if (extension == "prizma")
        return failure("It is a project, not a model: open it instead.", file);
    if (contains(pictureExtensions, extension))
        return failure("It is a picture, not a model.", file);
    if (!contains(modelExtensions(), extension))
        return failure("\"" + extension + "\" is not a model format that can be read.", file);
    if (isValveFormat(file)) // checked where it is read
        return {};
    auto content = readFile(file);
    if (!content)
        return std::unexpected(content.error());
    if (content->empty())
        return failure("The file is empty.", file);
    if (extension == "obj" && !toUtf8(std::move(*content)))
        return failure("It is not a text file, so it cannot be an OBJ model.", file);
    return {};
}

Result<ImportedModel> readModel(const std::string& path, const ImportOptions& options, Progress& progress) {
    const std::string extension = lowerExtension(path);
    try {
        if (extension == "smd")
            return importSmd(path, options, progress);
        if (extension == "qc")
            return importQc(path, options, progress);
    } catch (const std::bad_alloc&) {
        return failure("The model does not fit into memory.", path);
    }
    return importWithAssimp(path, options, progress);
}

} // namespace

Result<ImportedModel> importModel(const std::string& file, const ImportOptions& options, Progress& progress) {
    const std::string path = absolutePath(file);
    if (const auto checked = checkFile(path); !checked)
        return std::unexpected(checked.error());
    if (!std::isfinite(options.unitScale) || options.unitScale <= 0.0)
        return failure("The unit scale must be a number above 0.", path);
    auto model = readModel(path, options, progress);
    if (!model)
        return model;
    for (Diagnostic& warning : model->warnings)
        if (warning.file.empty())
            warning.file = path;
    if (const std::string fault = findFault(*model->mesh); !fault.empty())
        return failure("The model cannot be used: " + fault + ".", path);
    progress.set(1.0);
    return model;
}

std::vector<std::string> modelExtensions() {
    return {"obj", "smd", "qc",  "gltf", "glb", "fbx", "dae", "3ds", "ply", "stl",     "blend",
            "x",   "lwo", "off", "ac",   "ase", "dxf", "b3d", "md2", "md3", "md5mesh", "ms3d"};
}

bool isValveFormat(const std::string& file) {
    const std::string extension = lowerExtension(file);
    return extension == "smd" || extension == "qc";
}

UpAxis usualUpAxis(const std::string& file) {
    const std::string extension = lowerExtension(file);
    if (extension == "qc")
        return spaceOfQc(absolutePath(file)).upAxis;
    return extension == "smd" || extension == "stl" ? UpAxis::Z : UpAxis::Y;
}

Id addModel(Scene& scene, const ImportedModel& model, const MeshSource& source) {
    Object object;
    object.name = std::filesystem::path(source.file).stem().string();
    object.source = source;
    object.mesh = model.mesh;
    object.clips = model.clips;
    object.dynamic = model.mesh && model.mesh->isSkinned();
    for (const Material& material : model.materials)
        object.materials.push_back(addMaterial(scene, material));
    return addObject(scene, std::move(object));
}

} // namespace prizma
