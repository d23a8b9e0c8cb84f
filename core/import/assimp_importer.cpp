#include "core/import/assimp_importer.h"

#include "core/import/assimp_io.h"
#include "core/import/assimp_material.h"
#include "core/import/assimp_skin.h"
#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/file_space.h"
#include "core/import/mesh_builder.h"
#include "core/import/text_file.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace prizma {
namespace {

constexpr double creaseDegrees = 40.0;
constexpr double readingShare = 0.6; ///< Of the whole import's time, roughly.

std::unexpected<Diagnostic> cancelled(const std::string& file) {
    return failure("The import was cancelled.", file);
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Gathers a scene's triangles and materials.
class ModelBuilder {
  public:
    ModelBuilder(const aiScene& scene, const std::string& file, const std::vector<std::string>& folders,
                 MaterialSources sources, const ImportOptions& options)
        : scene_(scene),
          toObject_(fileToObject(options.upAxis, options.unitScale)),
          materials_(scene, file, folders, std::move(sources), options.unitScale, model_.warnings),
          slotOfMaterial_(scene.mNumMaterials) {
        if (AssimpSkin::isNeeded(scene))
            skin_.emplace(scene, toObject_);
    }

    void addNodes() {
        std::size_t triangles = 0;
        for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
            triangles += scene_.mMeshes[m]->mNumFaces;
        soup_.reserve(triangles);
        std::vector<std::pair<const aiNode*, glm::dmat4>> open{{scene_.mRootNode, toObject_}};
        while (!open.empty()) {
            const auto [node, parent] = open.back();
            open.pop_back();
            const glm::dmat4 toObject = parent * toGlm(node->mTransformation);
            for (unsigned m = 0; m < node->mNumMeshes; ++m)
                addMesh(*scene_.mMeshes[node->mMeshes[m]], *node, toObject);
            for (unsigned child = node->mNumChildren; child-- > 0;)
                open.emplace_back(node->mChildren[child], toObject);
        }
    }

    ImportedModel finish() {
        if (notFinite_ > 0)
            model_.warnings.push_back(
                {Severity::Warning,
                 std::to_string(notFinite_) +
                     " triangles were left out because their corners are not finite numbers.",
                 {},
                 0});
        BuiltMesh built = buildMesh(soup_, creaseDegrees);
        soup_ = {};
        for (const Material& material : model_.materials)
            built.mesh.slots.push_back(material.name);
        if (skin_) {
            skin_->apply(built);
            model_.clips = skin_->clips(scene_);
        }
        model_.mesh = std::make_shared<Mesh>(std::move(built.mesh));
        return std::move(model_);
    }

  private:
    void addMesh(const aiMesh& mesh, const aiNode& node, glm::dmat4 toObject) {
        std::uint32_t firstSource = noSourceVertex;
        if (skin_) {
            const auto binding = skin_->bind(mesh, node);
            toObject = binding.toObject;
            firstSource = binding.firstSourceVertex;
        }
        // A mirroring transform turns triangles inside out.
        const bool mirrored = glm::determinant(glm::dmat3(toObject)) < 0.0;
        const glm::dmat3 normalMatrix = cofactors(glm::dmat3(toObject)) * (mirrored ? -1.0 : 1.0);
        std::optional<std::uint32_t> slot;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (!isTriangle(face, mesh))
                continue;
            if (!slot)
                slot = slotOf(mesh.mMaterialIndex);
            for (unsigned corner = 0; corner < 3; ++corner)
                addCorner(mesh, face.mIndices[mirrored ? 2 - corner : corner], toObject, normalMatrix,
                          firstSource);
            soup_.slots.push_back(*slot);
            dropIfNotFinite();
        }
    }

    /// The inverse transpose up to its scale, which flat transforms have too.
    static glm::dmat3 cofactors(const glm::dmat3& m) {
        return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
    }

    static bool isTriangle(const aiFace& face, const aiMesh& mesh) {
        return face.mNumIndices == 3 && std::all_of(face.mIndices, face.mIndices + 3, [&](unsigned index) {
                   return index < mesh.mNumVertices;
               });
    }

    void addCorner(const aiMesh& mesh, unsigned vertex, const glm::dmat4& toObject,
                   const glm::dmat3& normalMatrix, std::uint32_t firstSource) {
        const aiVector3D& p = mesh.mVertices[vertex];
        soup_.positions.emplace_back(glm::dvec3(toObject * glm::dvec4(p.x, p.y, p.z, 1.0)));
        glm::dvec3 normal(0.0);
        if (mesh.mNormals) {
            const aiVector3D& n = mesh.mNormals[vertex];
            normal = normalMatrix * glm::dvec3(n.x, n.y, n.z);
            const double length = glm::length(normal);
            normal = std::isfinite(length) && length > 0.0 ? normal / length : glm::dvec3(0.0);
        }
        soup_.normals.emplace_back(normal);
        glm::vec2 texCoord(0.0F);
        if (mesh.mTextureCoords[0]) {
            soup_.hasTexCoords = true;
            const aiVector3D& t = mesh.mTextureCoords[0][vertex];
            if (std::isfinite(t.x) && std::isfinite(t.y))
                texCoord = {t.x, t.y};
        }
        soup_.texCoords.push_back(texCoord);
        soup_.sourceVertices.push_back(firstSource == noSourceVertex ? noSourceVertex : firstSource + vertex);
    }

    void dropIfNotFinite() {
        const std::size_t kept = soup_.positions.size() - 3;
        if (std::all_of(soup_.positions.begin() + static_cast<std::ptrdiff_t>(kept), soup_.positions.end(),
                        isFinite))
            return;
        ++notFinite_;
        soup_.positions.resize(kept);
        soup_.normals.resize(kept);
        soup_.texCoords.resize(kept);
        soup_.sourceVertices.resize(kept);
        soup_.slots.pop_back();
    }

    std::uint32_t slotOf(unsigned materialIndex) {
        auto& slot = slotOfMaterial_[materialIndex];
        if (!slot) {
            slot = static_cast<std::uint32_t>(model_.materials.size());
            Material material = materials_.read(materialIndex);
            material.name = freeName(material.name);
            model_.materials.push_back(std::move(material));
        }
        return *slot;
    }

    /// Slots are told apart by name, so two materials of one name in a file get different ones.
    std::string freeName(const std::string& wanted) const {
        std::string name = wanted;
        const auto taken = [&](const Material& material) { return material.name == name; };
        for (int number = 2; std::any_of(model_.materials.begin(), model_.materials.end(), taken); ++number)
            name = wanted + " " + std::to_string(number);
        return name;
    }

    const aiScene& scene_;
    ImportedModel model_;
    glm::dmat4 toObject_;
    MaterialReader materials_;
    std::vector<std::optional<std::uint32_t>> slotOfMaterial_;
    std::optional<AssimpSkin> skin_;
    TriangleSoup soup_;
    std::size_t notFinite_ = 0;
};

/// assimp falls back to a material file of the model's own name, which is missing only if it was asked for,
/// and looks for MD5 animations on the off chance.
void warnOfMissingFiles(const AssimpFiles& files, const std::string& model, Diagnostics& warnings) {
    const std::string fallback = std::filesystem::path(model).replace_extension("mtl").string();
    const bool another = files.missing().size() > 1;
    for (const std::string& file : files.missing())
        if ((file != fallback || !another) && !file.ends_with(".md5anim"))
            warnings.push_back(
                {Severity::Warning, "The file is missing; the model was read without it.", file, 0});
}

std::string sentence(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text.empty() ? "the file is damaged" : text;
}

/// A file as assimp reads it.
class AssimpFile {
  public:
    AssimpFile(const std::string& file, Progress& progress)
        : file_(file), progress_(progress), files_(file), handler_(progress, readingShare) {
        importer_.SetIOHandler(&files_);
        importer_.SetProgressHandler(&handler_);
        // Otherwise FBX bones fall apart into helper nodes, others in a file of animation than in its model.
        importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    }
    AssimpFile(const AssimpFile&) = delete;
    AssimpFile& operator=(const AssimpFile&) = delete;
    ~AssimpFile() { // the importer would delete its handlers
        importer_.SetIOHandler(nullptr);
        importer_.SetProgressHandler(nullptr);
    }

    Result<const aiScene*> read() {
        const aiScene* scene = importer_.ReadFile(file_, aiProcess_Triangulate);
        if (progress_.isCancelled())
            return cancelled(file_);
        if (!scene || !scene->mRootNode)
            return failure("The file could not be read: " + sentence(importer_.GetErrorString()) + ".",
                           file_);
        return scene;
    }

    const AssimpFiles& files() const { return files_; }

  private:
    std::string file_;
    Progress& progress_;
    AssimpFiles files_;
    AssimpProgress handler_;
    Assimp::Importer importer_;
};

MaterialSources readMaterialSources(const std::string& file, const AssimpFiles& files) {
    MaterialSources sources;
    const std::string extension = lowerExtension(file);
    if (extension == "obj")
        for (const std::string& companion : files.companions())
            if (const auto text = readTextFile(companion, mostModelBytes))
                sources.mtl.merge(readMtl(*text));
    if (extension == "gltf" || extension == "glb")
        if (const auto content = readFile(file))
            sources.gltf = readGltfExtras(*content);
    return sources;
}

Result<ImportedModel> readModel(const std::string& file, const ImportOptions& options, Progress& progress) {
    AssimpFile source(file, progress);
    const auto scene = source.read();
    if (!scene)
        return std::unexpected(scene.error());
    ModelBuilder builder(**scene, file, source.files().folders(), readMaterialSources(file, source.files()),
                         options);
    builder.addNodes();
    progress.set(0.8);
    if (progress.isCancelled())
        return cancelled(file);
    ImportedModel model = builder.finish();
    warnOfMissingFiles(source.files(), file, model.warnings);
    for (Diagnostic& warning : model.warnings)
        if (warning.file.empty())
            warning.file = file;
    return model;
}

Result<AssimpAnimations> readAnimations(const std::string& file, const ImportOptions& options,
                                        Progress& progress) {
    AssimpFile source(file, progress);
    const auto scene = source.read();
    if (!scene)
        return std::unexpected(scene.error());
    const AssimpSkin skin(**scene, fileToObject(options.upAxis, options.unitScale));
    AssimpAnimations animations{skin.skeleton(), skin.clips(**scene)};
    if (animations.clips.size() == 1 && (*scene)->mAnimations[0]->mName.length == 0) {
        Clip clip = *animations.clips[0];
        clip.name = std::filesystem::path(file).stem().string();
        animations.clips[0] = std::make_shared<Clip>(std::move(clip));
    }
    return animations;
}

/// Calls `read` and turns what assimp throws into errors.
template <class Read>
auto guarded(const std::string& file, Progress& progress, const Read& read) -> decltype(read()) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        return failure("The file does not fit into memory.", file);
    } catch (const std::exception& error) {
        if (progress.isCancelled())
            return cancelled(file);
        return failure("The file could not be read: " + sentence(error.what()) + ".", file);
    }
}

} // namespace

Result<ImportedModel> importWithAssimp(const std::string& file, const ImportOptions& options,
                                       Progress& progress) {
    return guarded(file, progress, [&] { return readModel(file, options, progress); });
}

Result<AssimpAnimations> importAnimationsWithAssimp(const std::string& file, const ImportOptions& options,
                                                    Progress& progress) {
    return guarded(file, progress, [&] { return readAnimations(file, options, progress); });
}

} // namespace prizma
