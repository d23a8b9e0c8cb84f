#include "ui/document/scene_command.h"

#include "ui/document/document.h"

namespace prizma {
namespace {

/// Whether two scenes are the same for a person; the counter of ids is not.
bool looksEqual(const Scene& a, Scene b) {
    b.lastId = a.lastId;
    return a == b;
}

} // namespace

SceneCommand::SceneCommand(Document& document, const QString& text, Scene before, Scene after, int gesture)
    : QUndoCommand(text),
      document_(document),
      before_(std::move(before)),
      after_(std::move(after)),
      gesture_(gesture),
      editsCamera_(before_.camera != after_.camera) {}

void SceneCommand::undo() {
    show(before_);
}

void SceneCommand::redo() {
    show(after_);
}

bool SceneCommand::mergeWith(const QUndoCommand* other) {
    // Only scene commands are ever pushed, and equal ids mean an equal gesture.
    const auto& later = static_cast<const SceneCommand&>(*other);
    after_ = later.after_;
    editsCamera_ = editsCamera_ || later.editsCamera_;
    if (!editsCamera_)
        before_.camera = after_.camera;             // it may have been moved between the two
    before_.timeline.frame = after_.timeline.frame; // so may the frame
    setObsolete(looksEqual(before_, after_));
    return true;
}

void SceneCommand::show(Scene scene) {
    if (!editsCamera_)
        scene.camera = document_.scene().camera;
    scene.timeline.frame = document_.scene().timeline.frame;
    document_.apply(std::move(scene));
}

} // namespace prizma
