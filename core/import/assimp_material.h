#pragma once

#include "core/diagnostic.h"
#include "core/scene/material.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

namespace prizma {

/// Turns the materials of one model file into ours, and reads each of their pictures once.
class MaterialReader {
  public:
    /// `file` is the model's absolute path; pictures are looked for in `folders`, and what is amiss with one
    /// is added to `warnings`.
    MaterialReader(const aiScene& scene, std::string file, std::vector<std::string> folders,
                   Diagnostics& warnings);

    Material read(const aiMaterial& source);

  private:
    Texture readTexture(const aiMaterial& source, aiTextureType type);
    Texture loadTexture(const std::string& name);
    Texture loadEmbedded(const aiTexture& source, const std::string& name);
    void readTextures(const aiMaterial& source, Material& material);

    const aiScene& scene_;
    std::string file_;
    std::vector<std::string> folders_;
    Diagnostics& warnings_;
    std::map<std::string, Texture> textures_;
};

} // namespace prizma
