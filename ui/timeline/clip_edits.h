#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <optional>
#include <string>

namespace prizma {

class Document;

/// The object whose clips the timeline is about: the last selected one that has any; if none has, the only
/// one in the scene that does. Null if there is none.
const Object* timelineObject(const Document& document);

/// Where a clip is on the timeline, in the timeline's frames.
struct ClipSpan {
    QString name;
    double start = 0.0;   ///< One of its beginnings, if it repeats.
    double frames = 0.0;  ///< How long it takes; more than 0.
    bool repeats = false; ///< Before and after, without end.
};

/// The span of the clip that the timeline's object plays; nothing if it plays none, or one that stands still.
std::optional<ClipSpan> playingSpan(const Document& document);

/// Makes an object play another of its clips (empty: the bind pose), as one undo step. If the object has a
/// fade time, it goes over to the clip from now on (`fromNow`), or has just done so: whoever chooses a clip
/// for a picture that stands still wants to see it.
void chooseClip(Document& document, Id object, const std::string& clip, bool fromNow);

/// Gives the timeline the frame rate of an object's clip and the frames that it takes, as one undo step.
void fitTimeline(Document& document, const Object& object, const Clip& clip);

} // namespace prizma
