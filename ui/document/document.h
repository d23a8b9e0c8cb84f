#pragma once

#include "core/project/project_file.h"
#include "core/scene/diff.h"
#include "core/scene/properties.h"
#include "core/scene/scene.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <vector>

namespace prizma {

/// The scene that is being edited, its undo stack, its selection and its file. Every edit of the scene goes
/// through the undo stack; everybody else reads `scene()` and listens to `sceneChanged`.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    const Scene& scene() const { return scene_; }
    QUndoStack& undoStack() { return undoStack_; }

    /// Things that are selected, the current one last. Never holds what is not in the scene.
    const std::vector<EntityRef>& selection() const { return selection_; }
    void setSelection(std::vector<EntityRef> selection);

    /// A number for one gesture (a drag, a run of typing): edits with equal gesture numbers become one undo
    /// step.
    int newGesture() { return ++lastGesture_; }

    /// Sets one property of one or several things as one undo step named after it ("Change intensity of
    /// key"). A value that changes nothing makes no step. Returns what was wrong with the value, or nothing.
    QString setProperty(const std::vector<EntityRef>& entities, std::string_view key,
                        const PropertyValue& value, int gesture = 0);

    /// Like `setProperty`, with a value of its own for each thing: `change` gets the present value and gives
    /// the new one. (Setting X of several positions leaves their Y and Z alone.)
    QString changeProperty(const std::vector<EntityRef>& entities, std::string_view key,
                           const std::function<PropertyValue(const PropertyValue&)>& change, int gesture = 0);

    /// Any other edit as one undo step called `text`: `change` gets a copy of the scene and alters it.
    void edit(const QString& text, const std::function<void(Scene&)>& change, int gesture = 0);

    /// Moves the camera. Part of the document (it marks a saved one as modified) but not of the undo stack:
    /// nobody expects Ctrl+Z to orbit back.
    void setCamera(const Camera& camera);

    /// Shows another frame. The frame is where one looks in time, as the camera is where one looks in space:
    /// playing and scrubbing make no undo steps, and undoing an edit leaves the frame alone. It is saved with
    /// the project, but unlike the camera it does not even mark it as modified, because nobody who played a
    /// clip wants to be asked whether to save that. Not finite: ignored.
    void setFrame(double frame);

    /// Alters what the view shows, but not the scene, until `endPreview`: a look at what an edit would do.
    /// `change` is called with a copy of the scene whenever that is asked for.
    void setPreview(std::function<void(Scene&)> change);
    void endPreview();
    bool hasPreview() const { return preview_ != nullptr; }

    /// What the view shows: the scene, altered by the preview if there is one.
    Scene shownScene() const;

    /// Replaces everything: the undo stack is cleared. `file` is empty for a scene that was never saved.
    void reset(Scene scene, const QString& file, UnknownKeysPtr unknownKeys = {});

    /// Saves to `file`, which becomes the document's file. Returns what went wrong, or nothing.
    QString save(const QString& file);

    const QString& file() const { return file_; } ///< Absolute path, or empty.
    QString title() const;                        ///< File name without path, or "Untitled".
    bool isModified() const;

    /// Grows with every edit, camera moves apart: tells whether something happened in between.
    int revision() const { return revision_; }

  Q_SIGNALS:
    /// After every change of the scene. Names are no part of a picture, so that renaming gives an empty diff.
    void sceneChanged(const prizma::SceneDiff& changes);
    void selectionChanged();
    void previewChanged();
    void replaced();    ///< The scene is another one altogether; told before `sceneChanged`.
    void fileChanged(); ///< Title or modified mark.

  private:
    friend class SceneCommand;
    void apply(Scene scene);
    void push(const QString& text, Scene after, int gesture);
    bool dropLostSelection(); ///< Gives whether there was any.

    Scene scene_;
    QUndoStack undoStack_;
    std::vector<EntityRef> selection_;
    std::function<void(Scene&)> preview_;
    QString file_;
    UnknownKeysPtr unknownKeys_;
    bool cameraMoved_ = false;
    int lastGesture_ = 0;
    int revision_ = 0;
};

} // namespace prizma
