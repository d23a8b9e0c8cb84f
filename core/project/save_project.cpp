#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/model_importer.h"
#include "core/project/project_file.h"
#include "core/project/property_json.h"
#include "core/project/unknown_keys.h"
#include "core/project/version.h"
#include "core/scene/hierarchy.h"
#include "core/scene/property_tables.h"

#include <algorithm>
#include <filesystem>

namespace prizma {
namespace {

class Writer {
  public:
    Writer(const Scene& scene, const UnknownKeys& unknown, std::string folder)
        : scene_(scene), unknown_(unknown), folder_(std::move(folder)) {}

    Json write() const {
        Json root = Json::object();
        root["prizma"] = projectVersion;
        addSection(root, "camera", EntityKind::Camera);
        addSection(root, "timeline", EntityKind::Timeline);
        addSection(root, "background", EntityKind::Background);
        addSection(root, "render", EntityKind::Render);
        root["materials"] = writeItems(scene_.materials, EntityKind::Material);
        if (!scene_.groups.empty())
            root["groups"] = writeItems(scene_.groups, EntityKind::Group);
        root["objects"] = writeItems(scene_.objects, EntityKind::Object);
        root["lights"] = writeItems(scene_.lights, EntityKind::Light);
        addUnknown(root, unknown_.top);
        return root;
    }

  private:
    static void addUnknown(Json& json, const Json& unknown) {
        for (const auto& [key, value] : unknown.items())
            if (!json.contains(key))
                json[key] = value;
    }

    /// All properties that differ from their defaults.
    void addProperties(Json& json, EntityRef entity) const {
        for (const PropertyInfo& info : properties(scene_, entity))
            if (isWritten(info, entity))
                json[std::string(info.key)] = toJson(info.value, folder_);
    }

    /// An object of a skinned model is dynamic by default; what it really is must be said.
    bool isWritten(const PropertyInfo& info, EntityRef entity) const {
        if (entity.kind == EntityKind::Object && info.key == "dynamic") {
            const Object* object = scene_.findObject(entity.id);
            if (object->mesh && object->mesh->isSkinned())
                return true;
        }
        const auto* texture = std::get_if<Texture>(&info.value);
        return texture ? !texture->file.empty() : info.value != info.defaultValue;
    }

    void addSection(Json& root, const std::string& key, EntityKind kind) const {
        Json section = Json::object();
        addProperties(section, {kind, noId});
        if (const auto found = unknown_.sections.find(key); found != unknown_.sections.end())
            addUnknown(section, found->second);
        if (!section.empty())
            root[key] = std::move(section);
    }

    template <class T>
    Json writeItems(const CowList<T>& list, EntityKind kind) const {
        Json items = Json::array();
        for (const T& item : list) {
            Json json = Json::object();
            json["name"] = item.name;
            if constexpr (std::is_same_v<T, Object>)
                addSource(json, item);
            if constexpr (requires { item.parent; })
                if (const Group* parent = findGroup(scene_, item.parent))
                    json["parent"] = parent->name;
            addProperties(json, {kind, item.id});
            if (const auto found = unknown_.items.find(item.id); found != unknown_.items.end())
                addUnknown(json, found->second);
            items.push_back(std::move(json));
        }
        return items;
    }

    void addSource(Json& json, const Object& object) const {
        const MeshSource& source = object.source;
        if (source.isPrimitive()) {
            json["primitive"] = choicesOf<PrimitiveType>()[static_cast<std::size_t>(source.primitive)].key;
            json["size"] = toJson(source.size, folder_);
        } else {
            json["model"] = relativePath(source.file, folder_);
            if (source.upAxis != UpAxis::Y || isValveFormat(source.file)) // whose usual axis is another
                json["upAxis"] = choicesOf<UpAxis>()[static_cast<std::size_t>(source.upAxis)].key;
            if (source.unitScale != 1.0)
                json["unitScale"] = toJson(source.unitScale, folder_);
        }
        addMaterials(json, object);
        if (!object.clipFiles.empty()) {
            Json clips = Json::array();
            for (const std::string& file : object.clipFiles)
                clips.push_back(relativePath(file, folder_));
            json["clips"] = std::move(clips);
        }
    }

    void addMaterials(Json& json, const Object& object) const {
        if (const auto lost = unknown_.materialsOfLost.find(object.id);
            !object.mesh && lost != unknown_.materialsOfLost.end()) {
            addUnknown(json, lost->second);
            return;
        }
        const auto nameOf = [this](Id id) {
            const Material* material = scene_.findMaterial(id);
            return material ? material->name : std::string();
        };
        const auto& ids = object.materials;
        const bool known =
            std::any_of(ids.begin(), ids.end(), [&](Id id) { return scene_.findMaterial(id); });
        if (!known)
            return;
        const bool same = std::all_of(ids.begin(), ids.end(), [&](Id id) { return id == ids.front(); });
        if (same || !object.mesh) {
            json["material"] = nameOf(ids.front());
            return;
        }
        Json slots = Json::object();
        for (std::size_t i = 0; i < std::min(ids.size(), object.mesh->slots.size()); ++i)
            if (scene_.findMaterial(ids[i]))
                slots[object.mesh->slots[i]] = nameOf(ids[i]);
        json["materials"] = std::move(slots);
    }

    const Scene& scene_;
    const UnknownKeys& unknown_;
    std::string folder_;
};

} // namespace

Result<void> saveProject(const std::string& file, const Scene& scene, const UnknownKeysPtr& unknownKeys) {
    const std::string path = absolutePath(file);
    const UnknownKeys none;
    const Writer writer(scene, unknownKeys ? *unknownKeys : none,
                        std::filesystem::path(path).parent_path().string());
    return replaceFile(path, formatJson(writer.write()));
}

} // namespace prizma
