#pragma once

#include "core/import/animation_importer.h"
#include "core/import/model_importer.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace prizma {

/// What a project refers to, each read once however many objects and materials use it.
class AssetCache {
  public:
    explicit AssetCache(Progress& progress) : progress_(progress) {}

    const Result<ImportedModel>& model(const MeshSource& source);
    /// An animation for the object's mesh.
    const Result<ImportedAnimation>& animation(const std::string& file, const Object& object);

    MeshPtr primitive(PrimitiveType type, double size);

    /// Fills in `texture.image`; a fault is added to `warnings` the first time.
    void loadTexture(Texture& texture, Diagnostics& warnings);

  private:
    Progress& progress_;
    std::map<std::tuple<std::string, UpAxis, double>, Result<ImportedModel>> models_;
    std::map<std::pair<std::string, const Mesh*>, Result<ImportedAnimation>> animations_;
    std::map<std::pair<PrimitiveType, double>, MeshPtr> primitives_;
    std::map<std::string, ImagePtr> images_;
};

} // namespace prizma
