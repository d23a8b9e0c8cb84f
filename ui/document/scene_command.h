#pragma once

#include "core/scene/scene.h"

#include <QUndoCommand>

namespace prizma {

class Document;

/// An edit as two snapshots of the scene: they share everything that is heavy, so that a step costs little
/// memory. The timeline's frame stays what it is at the moment, whatever the snapshots say.
class SceneCommand : public QUndoCommand {
  public:
    /// Edits with an equal gesture number other than 0 merge into one step.
    SceneCommand(Document& document, const QString& text, Scene before, Scene after, int gesture);

    void undo() override;
    void redo() override;
    int id() const override { return gesture_ > 0 ? gesture_ : -1; }
    bool mergeWith(const QUndoCommand* other) override;

  private:
    void show(Scene scene);

    Document& document_;
    Scene before_;
    Scene after_;
    int gesture_;
    bool editsCamera_; ///< The camera itself was edited in a panel; else the present one is kept.
};

} // namespace prizma
