#include "ui/document/edits.h"

#include "core/scene/edits.h"
#include "core/scene/property_tables.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"

#include <algorithm>

namespace prizma {
namespace {

bool isRemovable(EntityRef entity) {
    return entity.kind == EntityKind::Object || entity.kind == EntityKind::Light ||
           entity.kind == EntityKind::Material;
}

std::vector<EntityRef> removableSelection(const Document& document) {
    std::vector<EntityRef> removable;
    std::copy_if(document.selection().begin(), document.selection().end(), std::back_inserter(removable),
                 isRemovable);
    return removable;
}

template <class Enum>
QString choiceLabel(Enum value) {
    return translated(choicesOf<Enum>()[static_cast<std::size_t>(value)].label);
}

} // namespace

void deleteSelected(Document& document) {
    const auto entities = removableSelection(document);
    if (!entities.empty())
        document.edit(Document::tr("Delete %1").arg(describeEntities(document.scene(), entities)),
                      [&](Scene& scene) { removeEntities(scene, entities); });
}

void duplicateSelected(Document& document) {
    const auto entities = removableSelection(document);
    if (entities.empty())
        return;
    std::vector<EntityRef> copies;
    document.edit(Document::tr("Duplicate %1").arg(describeEntities(document.scene(), entities)),
                  [&](Scene& scene) { copies = duplicateEntities(scene, entities); });
    document.setSelection(copies);
}

void selectAll(Document& document) {
    std::vector<EntityRef> all;
    for (const Light& light : document.scene().lights)
        all.push_back({EntityKind::Light, light.id});
    for (const Object& object : document.scene().objects)
        all.push_back({EntityKind::Object, object.id});
    document.setSelection(all);
}

void addPrimitive(Document& document, PrimitiveType type) {
    Id id = noId;
    document.edit(Document::tr("Add %1").arg(labelOf(type).toLower()),
                  [&](Scene& scene) { id = addPrimitive(scene, type); });
    document.setSelection({{EntityKind::Object, id}});
}

void addLight(Document& document, LightType type) {
    Id id = noId;
    document.edit(Document::tr("Add light"), [&](Scene& scene) { id = addLight(scene, type); });
    document.setSelection({{EntityKind::Light, id}});
}

void addMaterial(Document& document) {
    Id id = noId;
    document.edit(Document::tr("Add material"), [&](Scene& scene) { id = addMaterial(scene); });
    document.setSelection({{EntityKind::Material, id}});
}

void assignMaterial(Document& document, const std::vector<Id>& objects, int slot, Id material) {
    document.edit(Document::tr("Assign %1").arg(nameOf(document.scene(), {EntityKind::Material, material})),
                  [&](Scene& scene) { assignMaterial(scene, objects, slot, material); });
}

std::vector<Id> addImportedModels(Document& document, const std::vector<BatchModel>& models) {
    std::vector<Id> ids;
    document.edit(models.size() == 1 ? Document::tr("Import model") : Document::tr("Import models"),
                  [&](Scene& scene) {
                      for (const BatchModel& model : models)
                          ids.push_back(addModel(scene, model));
                  });
    std::vector<EntityRef> selection;
    for (const Id id : ids)
        selection.push_back({EntityKind::Object, id});
    document.setSelection(selection);
    return ids;
}

void addImportedAnimations(Document& document, Id object, const std::vector<ImportedAnimation>& animations) {
    document.edit(Document::tr("Import animation"), [&](Scene& scene) {
        for (Object& candidate : scene.objects.edit())
            if (candidate.id == object)
                for (const ImportedAnimation& animation : animations)
                    addAnimation(candidate, animation);
    });
}

Id animationTarget(const Document& document) {
    const auto hasBones = [](const Object* object) {
        return object && object->mesh && object->mesh->skeleton;
    };
    const std::vector<Id> selected = selectedObjects(document);
    for (auto id = selected.rbegin(); id != selected.rend(); ++id)
        if (hasBones(document.scene().findObject(*id)))
            return *id;
    Id only = noId;
    for (const Object& object : document.scene().objects) {
        if (!hasBones(&object))
            continue;
        if (only != noId)
            return noId;
        only = object.id;
    }
    return only;
}

std::vector<Id> selectedObjects(const Document& document) {
    std::vector<Id> ids;
    for (const EntityRef& entity : document.selection())
        if (entity.kind == EntityKind::Object)
            ids.push_back(entity.id);
    return ids;
}

bool hasRemovableSelection(const Document& document) {
    return std::any_of(document.selection().begin(), document.selection().end(), isRemovable);
}

QString labelOf(LightType type) {
    return choiceLabel(type);
}
QString labelOf(PrimitiveType type) {
    return choiceLabel(type);
}
QString labelOf(ShaderType type) {
    return choiceLabel(type);
}

} // namespace prizma
