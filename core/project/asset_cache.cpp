#include "core/project/asset_cache.h"

#include "core/import/image_loader.h"
#include "core/scene/primitives.h"

namespace prizma {

const Result<ImportedModel>& AssetCache::model(const MeshSource& source) {
    const auto key = std::tuple(source.file, source.upAxis, source.unitScale);
    const auto found = models_.find(key);
    if (found != models_.end())
        return found->second;
    const auto& model =
        models_.emplace(key, importModel(source.file, {source.upAxis, source.unitScale}, progress_))
            .first->second;
    if (model)
        for (const Material& material : model->materials)
            for (const Texture& texture : texturesOf(material))
                if (texture.isSet())
                    images_.emplace(texture.file, texture.image);
    return model;
}

const Result<ImportedAnimation>& AssetCache::animation(const std::string& file, const Object& object) {
    const auto key = std::pair(file, object.mesh.get());
    if (const auto found = animations_.find(key); found != animations_.end())
        return found->second;
    auto animation = object.mesh->skeleton
                         ? importAnimation(file, *object.mesh->skeleton, object.source, progress_)
                         : failure("It was left out: the model that it is for has no bones.", file);
    return animations_.emplace(key, std::move(animation)).first->second;
}

MeshPtr AssetCache::primitive(PrimitiveType type, double size) {
    auto& mesh = primitives_[{type, size}];
    if (!mesh)
        mesh = makePrimitive(type, size);
    return mesh;
}

void AssetCache::loadTexture(Texture& texture, Diagnostics& warnings) {
    if (texture.file.empty() || texture.image)
        return;
    const auto [found, isNew] = images_.try_emplace(texture.file);
    if (isNew) {
        if (const auto image = loadImage(texture.file))
            found->second = *image;
        else
            warnings.push_back({Severity::Warning, image.error().message, texture.file, 0});
    }
    texture.image = found->second;
}

} // namespace prizma
