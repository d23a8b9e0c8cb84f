#pragma once

#include "core/scene/scene.h"

#include <string>

namespace prizma {

class Document;

/// The object whose clips the timeline is about: the last selected one that has any; if none has, the only
/// one in the scene that does. Null if there is none.
const Object* timelineObject(const Document& document);

/// The object's clip of that name, or null.
const Clip* findClip(const Object& object, const std::string& name);

/// Makes an object play another of its clips (empty: the bind pose), as one undo step.
void chooseClip(Document& document, Id object, const std::string& clip);

/// Gives the timeline the clip's frames and its frame rate, as one undo step.
void fitTimeline(Document& document, const Clip& clip);

} // namespace prizma
