#pragma once

#include "core/import/gltf_extras.h"
#include "core/import/mtl_reader.h"
#include "core/import/picture_reader.h"
#include "core/scene/material.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

namespace prizma {

/// What a model's files say about its materials beyond what assimp passes on.
struct MaterialSources {
    std::map<std::string, MtlMaterial> mtl; ///< OBJ: its MTL files' materials by name.
    std::vector<GltfExtras> gltf;           ///< glTF: one a material.
};

/// Turns the materials of one model file into ours, and reads each of their pictures once.
class MaterialReader {
  public:
    /// `file` is the model's absolute path; pictures are looked for in `folders`, and what is amiss with one
    /// is added to `warnings`. Distances are in units of `unitScale` scene units.
    MaterialReader(const aiScene& scene, std::string file, std::vector<std::string> folders,
                   MaterialSources sources, double unitScale, Diagnostics& warnings);

    /// The material at `index` of the scene's.
    Material read(unsigned index);

  private:
    Material readPhong(const aiMaterial& source);
    Material readPhysical(const aiMaterial& source);
    void readGltf(const aiMaterial& source, unsigned index, Material& material);
    Texture specularTexture(const GltfExtras& extras);
    Texture readTexture(const aiMaterial& source, aiTextureType type);
    Texture readNamed(const std::string& name);
    Texture baseColorTexture(const aiMaterial& source);
    void readTextures(const aiMaterial& source, Material& material);
    void readMetallicRoughness(const aiMaterial& source, Material& material);
    void readNormals(const aiMaterial& source, Material& material);

    const aiScene& scene_;
    std::string file_;
    MaterialSources sources_;
    double unitScale_;
    PictureReader pictures_;
};

} // namespace prizma
