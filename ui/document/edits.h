#pragma once

#include "core/import/import_batch.h"
#include "core/scene/scene.h"

#include <QString>

#include <vector>

namespace prizma {

class Document;

/// The editor's commands on a scene, each one undo step that leaves the outcome selected.

void deleteSelected(Document& document); ///< Cameras and settings stay.
void duplicateSelected(Document& document);
void selectAll(Document& document); ///< All objects and lights.
void addPrimitive(Document& document, PrimitiveType type);
void addLight(Document& document, LightType type);
void addMaterial(Document& document);

/// `slot` negative: in all slots.
void assignMaterial(Document& document, const std::vector<Id>& objects, int slot, Id material);

/// Adds the models, each with its animations. Gives the new objects' ids.
std::vector<Id> addImportedModels(Document& document, const std::vector<BatchModel>& models);

/// Gives an object clips.
void addImportedAnimations(Document& document, Id object, const std::vector<ImportedAnimation>& animations);

/// The object that an imported animation is for: the last of the selected ones that has bones, else the only
/// one of the scene that has. noId if neither exists.
Id animationTarget(const Document& document);

/// The ids of the selected objects.
std::vector<Id> selectedObjects(const Document& document);

/// Whether anything is selected that can be deleted and duplicated.
bool hasRemovableSelection(const Document& document);

/// "Point light", "Cube", ... for menus.
QString labelOf(LightType type);
QString labelOf(PrimitiveType type);
QString labelOf(ShaderType type);

} // namespace prizma
