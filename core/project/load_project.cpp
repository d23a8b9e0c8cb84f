#include "core/import/atomic_file.h"
#include "core/import/file_finder.h"
#include "core/import/text_encoding.h"
#include "core/project/asset_cache.h"
#include "core/project/group_links.h"
#include "core/project/property_json.h"
#include "core/project/unknown_keys.h"
#include "core/project/version.h"
#include "core/scene/hierarchy.h"
#include "core/scene/property_tables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

namespace prizma {
namespace {

using Keys = std::set<std::string, std::less<>>;

class Reader {
  public:
    Reader(JsonText text, std::string file, Progress& progress)
        : text_(std::move(text)),
          file_(std::move(file)),
          folder_(std::filesystem::path(file_).parent_path().string()),
          progress_(progress),
          assets_(progress) {}

    Result<Project> read() {
        const Json& root = text_.root;
        for (const auto& [key, kind] : {std::pair{"camera", EntityKind::Camera},
                                        {"timeline", EntityKind::Timeline},
                                        {"background", EntityKind::Background},
                                        {"render", EntityKind::Render}})
            if (auto done = readSection(key, kind); !done)
                return std::unexpected(done.error());
        if (auto done = readList("materials", [this](auto&&... a) { return readMaterial(a...); }); !done)
            return std::unexpected(done.error());
        if (auto done = readList("groups", [this](auto&&... a) { return readGroup(a...); }); !done)
            return std::unexpected(done.error());
        if (auto done = readList("objects", [this](auto&&... a) { return readObject(a...); }); !done)
            return std::unexpected(done.error());
        if (auto done = readList("lights", [this](auto&&... a) { return readLight(a...); }); !done)
            return std::unexpected(done.error());
        keepUnknown(root,
                    {"prizma", "camera", "timeline", "background", "render", "materials", "groups", "objects",
                     "lights"},
                    unknown_.top);
        for (const GroupLinks::Fault& fault : groupLinks_.apply(project_.scene))
            warn(fault.message, fault.place);
        loadTextures();
        if (progress_.isCancelled())
            return failure("Opening the project was cancelled.", file_);
        progress_.set(1.0);
        project_.unknownKeys = std::make_shared<UnknownKeys>(std::move(unknown_));
        return std::move(project_);
    }

  private:
    std::unexpected<Diagnostic> error(const std::string& message, const std::string& path) const {
        return failure(message, file_, text_.lineOf(path));
    }

    void warn(const std::string& message, const std::string& path) {
        project_.warnings.push_back({Severity::Warning, message, file_, text_.lineOf(path)});
    }

    static void keepUnknown(const Json& json, const Keys& known, Json& unknown) {
        for (const auto& [key, value] : json.items())
            if (!known.contains(key))
                unknown[key] = value;
    }

    /// Sets all properties of `entity` that `json` has; `known` gets their keys.
    Result<void> readProperties(Scene& scene, EntityRef entity, const Json& json, const std::string& path,
                                Keys& known) const {
        for (const PropertyInfo& info : properties(scene, entity)) {
            const std::string key(info.key);
            known.insert(key);
            const auto found = json.find(key);
            if (found == json.end())
                continue;
            const auto value = fromJson(*found, info.kind, folder_);
            if (!value)
                return error("\"" + key + "\" " + value.error().message + ".", path + "/" + key);
            if (const auto set = setProperty(scene, entity, key, *value); !set)
                return error(sentence(set.error().message), path + "/" + key);
        }
        return {};
    }

    static std::string sentence(std::string text) {
        if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
            text.front() = static_cast<char>(text.front() - 'a' + 'A');
        return text + ".";
    }

    Result<void> readSection(const std::string& key, EntityKind kind) {
        const auto found = text_.root.find(key);
        if (found == text_.root.end())
            return {};
        if (!found->is_object())
            return error("\"" + key + "\" must be an object in braces.", "/" + key);
        Keys known;
        if (auto done = readProperties(project_.scene, {kind, noId}, *found, "/" + key, known); !done)
            return done;
        keepUnknown(*found, known, unknown_.sections[key]);
        return {};
    }

    template <class ReadItem>
    Result<void> readList(const std::string& key, const ReadItem& readItem) {
        const auto found = text_.root.find(key);
        if (found == text_.root.end())
            return {};
        if (!found->is_array())
            return error("\"" + key + "\" must be a list in brackets.", "/" + key);
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string path = "/" + key + "/" + std::to_string(i);
            if (progress_.isCancelled())
                return failure("Opening the project was cancelled.", file_);
            if (!(*found)[i].is_object())
                return error("Each of the \"" + key + "\" must be an object in braces.", path);
            if (auto done = readItem((*found)[i], path); !done)
                return done;
        }
        return {};
    }

    /// A light, material or object with the properties that `json` has. A scene of its own keeps each step as
    /// fast as if there were no other items.
    template <class T>
    Result<T> readItem(T item, CowList<T> Scene::*list, EntityKind kind, const Json& json,
                       const std::string& path, Keys& known) const {
        Scene scratch;
        item.id = scratch.newId();
        (scratch.*list).edit().push_back(std::move(item));
        if (auto done = readProperties(scratch, {kind, scratch.lastId}, json, path, known); !done)
            return std::unexpected(done.error());
        return (scratch.*list)[0];
    }

    void warnOfRenaming(const std::string& wanted, const std::string& given, const std::string& path) {
        if (wanted != given)
            warn("The name \"" + wanted + "\" is used twice; this one was renamed to \"" + given + "\".",
                 path);
    }

    Result<void> readMaterial(const Json& json, const std::string& path) {
        Keys known;
        const auto item = readItem(Material{}, &Scene::materials, EntityKind::Material, json, path, known);
        if (!item)
            return std::unexpected(item.error());
        const Id id = addMaterial(project_.scene, *item);
        warnOfRenaming(item->name, project_.scene.materials.back().name, path);
        keepUnknown(json, known, unknown_.items[id]);
        return {};
    }

    /// Whom `json` hangs under, as a name; empty for none. `known` gets the key.
    Result<std::string> readParent(const Json& json, const std::string& path, Keys& known) const {
        known.insert("parent");
        const auto found = json.find("parent");
        if (found == json.end() || found->is_null())
            return std::string();
        if (!found->is_string())
            return error("\"parent\" must be a group's name in quotes.", path + "/parent");
        return found->get<std::string>();
    }

    void hang(EntityRef member, const std::string& parent, const std::string& path) {
        if (!parent.empty())
            groupLinks_.want(member, parent, path + "/parent");
    }

    Result<void> readGroup(const Json& json, const std::string& path) {
        Keys known;
        const auto parent = readParent(json, path, known);
        if (!parent)
            return std::unexpected(parent.error());
        const auto item = readItem(Group{}, &Scene::groups, EntityKind::Group, json, path, known);
        if (!item)
            return std::unexpected(item.error());
        const Id id = addGroup(project_.scene, *item);
        warnOfRenaming(item->name, project_.scene.groups.back().name, path);
        keepUnknown(json, known, unknown_.items[id]);
        hang({EntityKind::Group, id}, *parent, path);
        return {};
    }

    Result<void> readLight(const Json& json, const std::string& path) {
        Keys known;
        const auto parent = readParent(json, path, known);
        if (!parent)
            return std::unexpected(parent.error());
        const auto item = readItem(Light{}, &Scene::lights, EntityKind::Light, json, path, known);
        if (!item)
            return std::unexpected(item.error());
        const Id id = addLight(project_.scene, *item);
        warnOfRenaming(item->name, project_.scene.lights.back().name, path);
        keepUnknown(json, known, unknown_.items[id]);
        hang({EntityKind::Light, id}, *parent, path);
        return {};
    }

    Result<void> readObject(const Json& json, const std::string& path) {
        Object object;
        if (auto done = readSource(json, path, object); !done)
            return done;
        if (auto done = readClips(json, path, object); !done)
            return done;
        if (auto done = checkMaterials(json, path); !done)
            return done;
        const ImportedModel* model = loadMesh(object);
        loadClips(object);
        object.dynamic = object.mesh && object.mesh->isSkinned();
        Keys known{"model", "primitive", "size", "upAxis", "unitScale", "clips", "material", "materials"};
        const auto parent = readParent(json, path, known);
        if (!parent)
            return std::unexpected(parent.error());
        auto item = readItem(std::move(object), &Scene::objects, EntityKind::Object, json, path, known);
        if (!item)
            return std::unexpected(item.error());
        assignMaterials(json, path, model, *item);
        const bool lost = !item->mesh;
        const std::string wanted = item->name;
        const Id id = addObject(project_.scene, std::move(*item));
        warnOfRenaming(wanted, project_.scene.objects.back().name, path);
        keepUnknown(json, known, unknown_.items[id]);
        hang({EntityKind::Object, id}, *parent, path);
        if (lost)
            for (const char* key : {"material", "materials"})
                if (json.contains(key))
                    unknown_.materialsOfLost[id][key] = json[key];
        return {};
    }

    /// `json[key]` as a choice of `Enum`; `otherwise` if there is none.
    template <class Enum>
    Result<Enum> readChoice(const Json& json, const std::string& path, const std::string& key,
                            Enum otherwise) const {
        const auto found = json.find(key);
        if (found == json.end())
            return otherwise;
        const auto choices = choicesOf<Enum>();
        std::string all;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (found->is_string() && found->template get<std::string>() == choices[i].key)
                return static_cast<Enum>(i);
            all += (i > 0 ? ", " : "") + std::string(choices[i].key);
        }
        return error("\"" + key + "\" must be one of: " + all + ".", path + "/" + key);
    }

    Result<double> readPositive(const Json& json, const std::string& path, const std::string& key) const {
        const auto found = json.find(key);
        if (found == json.end())
            return 1.0;
        const double number = found->is_number() ? found->get<double>() : 0.0;
        if (!std::isfinite(number) || number <= 0.0)
            return error("\"" + key + "\" must be a number above 0.", path + "/" + key);
        return number;
    }

    /// What is up in a model if the project does not say: for SMD and QC what is usual, Y for all others.
    UpAxis usualAxis(const Json& json) const {
        const auto model = json.find("model");
        if (model == json.end() || !model->is_string() || !isValveFormat(model->get<std::string>()))
            return UpAxis::Y;
        return usualUpAxis(resolve(model->get<std::string>()));
    }

    Result<void> readSource(const Json& json, const std::string& path, Object& object) const {
        if (json.contains("model") == json.contains("primitive"))
            return error("An object needs either a \"model\" or a \"primitive\".", path);
        const auto primitive = readChoice(json, path, "primitive", object.source.primitive);
        const auto upAxis = readChoice(json, path, "upAxis", usualAxis(json));
        const auto size = readPositive(json, path, "size");
        const auto unitScale = readPositive(json, path, "unitScale");
        if (!primitive)
            return std::unexpected(primitive.error());
        if (!upAxis)
            return std::unexpected(upAxis.error());
        for (const auto* number : {&size, &unitScale})
            if (!*number)
                return std::unexpected(number->error());
        object.source.primitive = *primitive;
        object.source.upAxis = *upAxis;
        object.source.size = *size;
        object.source.unitScale = *unitScale;
        if (const auto model = json.find("model"); model != json.end()) {
            if (!model->is_string() || cleanFileName(model->get<std::string>()).empty())
                return error("\"model\" must be the path of a model file, in quotes.", path + "/model");
            object.source.file = resolve(model->get<std::string>());
        }
        return {};
    }

    std::string resolve(const std::string& name) const {
        return findFile(folder_, name).value_or(expectedPath(folder_, name));
    }

    Result<void> readClips(const Json& json, const std::string& path, Object& object) {
        const auto clips = json.find("clips");
        if (clips == json.end())
            return {};
        const bool texts = clips->is_array() && std::all_of(clips->begin(), clips->end(),
                                                            [](const Json& c) { return c.is_string(); });
        if (!texts)
            return error("\"clips\" must be a list of paths in quotes.", path + "/clips");
        for (const Json& clip : *clips)
            object.clipFiles.push_back(resolve(clip.get<std::string>()));
        return {};
    }

    /// Animations that are missing or do not suit the model stay in the project's list.
    void loadClips(Object& object) {
        if (object.clipFiles.empty() || !object.mesh)
            return;
        const auto warnOf = [this](Diagnostic fault) {
            fault.severity = Severity::Warning;
            project_.warnings.push_back(std::move(fault));
        };
        const std::string chosen = object.clip;
        for (const std::string& file : std::exchange(object.clipFiles, {})) {
            const auto& animation = assets_.animation(file, object);
            if (!animation) {
                warnOf(animation.error());
                object.clipFiles.push_back(file);
                continue;
            }
            if (reported_.insert(file).second)
                std::ranges::for_each(animation->warnings, warnOf);
            addAnimation(object, *animation);
        }
        object.clip = chosen; // which one plays is for the project to say
    }

    /// The model, or null for a primitive and for a model that could not be loaded.
    const ImportedModel* loadMesh(Object& object) {
        if (object.source.isPrimitive()) {
            object.mesh = assets_.primitive(object.source.primitive, object.source.size);
            return nullptr;
        }
        const auto& model = assets_.model(object.source);
        const bool isNew = reported_.insert(object.source.file).second;
        if (!model) {
            if (isNew)
                project_.warnings.push_back(
                    {Severity::Warning, model.error().message, model.error().file, model.error().line});
            return nullptr;
        }
        if (isNew)
            project_.warnings.insert(project_.warnings.end(), model->warnings.begin(), model->warnings.end());
        object.mesh = model->mesh;
        object.clips = model->clips;
        return &*model;
    }

    Result<void> checkMaterials(const Json& json, const std::string& path) const {
        if (const auto one = json.find("material"); one != json.end() && !one->is_string())
            return error("\"material\" must be a material's name in quotes.", path + "/material");
        const auto slots = json.find("materials");
        if (slots == json.end())
            return {};
        const bool texts =
            slots->is_object() &&
            std::all_of(slots->begin(), slots->end(), [](const Json& name) { return name.is_string(); });
        if (!texts)
            return error("\"materials\" must name a material for each slot.", path + "/materials");
        return {};
    }

    /// The material that the object asks for in a slot; noId if it asks for none, or for one that is not
    /// there.
    Id wantedMaterial(const Json& json, const std::string& path, const std::string& slot) {
        const auto all = json.find("material");
        const auto slots = json.find("materials");
        const Json* name = nullptr;
        if (slots != json.end() && slots->contains(slot))
            name = &(*slots)[slot];
        else if (all != json.end())
            name = &*all;
        if (!name)
            return noId;
        if (const Material* material = project_.scene.findMaterial(name->get<std::string>()))
            return material->id;
        warn("There is no material \"" + name->get<std::string>() + "\".", path);
        return noId;
    }

    void assignMaterials(const Json& json, const std::string& path, const ImportedModel* model,
                         Object& object) {
        if (!object.mesh)
            return;
        const auto& slots = object.mesh->slots;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            Id id = wantedMaterial(json, path, slots[i]);
            if (id == noId && model)
                id = importedMaterial(object, *model, i);
            if (id == noId)
                id = defaultMaterial();
            object.materials.push_back(id);
        }
    }

    /// Objects of one model share the materials that came with it.
    Id importedMaterial(const Object& object, const ImportedModel& model, std::size_t slot) {
        Id& id = imported_[{object.mesh.get(), slot}];
        if (id == noId)
            id = addMaterial(project_.scene, model.materials[slot]);
        return id;
    }

    Id defaultMaterial() {
        if (defaultMaterial_ == noId) {
            Material material;
            material.name = "default";
            defaultMaterial_ = addMaterial(project_.scene, material);
        }
        return defaultMaterial_;
    }

    /// After the objects: pictures that models brought along are not read again.
    void loadTextures() {
        assets_.loadTexture(project_.scene.background.image, project_.warnings);
        if (project_.scene.materials.empty())
            return;
        for (Material& material : project_.scene.materials.edit()) {
            for (Texture* texture :
                 {&material.baseColorTexture, &material.specularTexture, &material.metallicRoughnessTexture,
                  &material.transmissionTexture, &material.emissionTexture, &material.normalTexture})
                assets_.loadTexture(*texture, project_.warnings);
        }
    }

    JsonText text_;
    std::string file_, folder_;
    Progress& progress_;
    AssetCache assets_;
    Project project_;
    UnknownKeys unknown_;
    GroupLinks groupLinks_;
    std::set<std::string> reported_; ///< Models whose warnings were passed on.
    std::map<std::pair<const Mesh*, std::size_t>, Id> imported_;
    Id defaultMaterial_ = noId;
};

} // namespace

Result<Project> loadProject(const std::string& file, Progress& progress) {
    const std::string path = absolutePath(file);
    auto content = readFile(path);
    if (!content)
        return std::unexpected(content.error());
    const auto text = toUtf8(std::move(*content));
    if (!text)
        return failure("It is not a text file, so it cannot be a project.", path);
    if (text->find_first_not_of(" \t\r\n") == std::string::npos)
        return failure("The file is empty.", path);
    auto json = parseJson(*text, path);
    if (!json)
        return std::unexpected(json.error());
    if (!json->root.is_object())
        return failure("It is not a Prizma project.", path, 1);
    if (const auto migrated = migrateProject(*json, path); !migrated)
        return std::unexpected(migrated.error());
    return Reader(std::move(*json), path, progress).read();
}

} // namespace prizma
