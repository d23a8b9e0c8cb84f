#include "ui/document/document.h"

#include "core/scene/edits.h"
#include "ui/document/scene_command.h"
#include "ui/document/strings.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

QString labelOf(const Scene& scene, EntityRef entity, std::string_view key) {
    for (const PropertyInfo& info : properties(scene, entity))
        if (info.key == key)
            return translated(info.label);
    return toQString(key);
}

/// "Change intensity of key", "Hide bunny", ...
QString stepText(const Scene& scene, const std::vector<EntityRef>& entities, std::string_view key,
                 const PropertyValue& value) {
    const QString what = describeEntities(scene, entities);
    if (key == "name")
        return Document::tr("Rename %1").arg(what);
    if (key == "visible")
        return (std::get<bool>(value) ? Document::tr("Show %1") : Document::tr("Hide %1")).arg(what);
    if (key == "enabled")
        return (std::get<bool>(value) ? Document::tr("Switch on %1") : Document::tr("Switch off %1"))
            .arg(what);
    return Document::tr("Change %1 of %2").arg(labelOf(scene, entities.front(), key).toLower(), what);
}

} // namespace

Document::Document(QObject* parent) : QObject(parent) {
    connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

// A stack that goes says that it is clean. Whoever listens may be half gone by then.
Document::~Document() {
    undoStack_.disconnect(this);
}

void Document::setSelection(std::vector<EntityRef> selection) {
    std::vector<EntityRef> kept;
    for (const EntityRef& entity : selection)
        if (exists(scene_, entity) && std::find(kept.begin(), kept.end(), entity) == kept.end())
            kept.push_back(entity);
    if (kept == selection_)
        return;
    selection_ = std::move(kept);
    Q_EMIT selectionChanged();
}

QString Document::setProperty(const std::vector<EntityRef>& entities, std::string_view key,
                              const PropertyValue& value, int gesture) {
    return changeProperty(
        entities, key, [&value](const PropertyValue&) { return value; }, gesture);
}

QString Document::changeProperty(const std::vector<EntityRef>& entities, std::string_view key,
                                 const std::function<PropertyValue(const PropertyValue&)>& change,
                                 int gesture) {
    if (entities.empty())
        return {};
    Scene after = scene_;
    PropertyValue value;
    for (const EntityRef& entity : entities) {
        const auto present = getProperty(after, entity, key);
        if (!present)
            return toQString(present.error().message);
        value = change(*present);
        if (value == *present)
            continue; // no copy of the list for nothing
        const auto* name = key == "name" ? std::get_if<std::string>(&value) : nullptr;
        const auto done =
            name ? renameEntity(after, entity, *name) : prizma::setProperty(after, entity, key, value);
        if (!done)
            return toQString(done.error().message);
    }
    push(stepText(scene_, entities, key, value), std::move(after), gesture);
    return {};
}

void Document::edit(const QString& text, const std::function<void(Scene&)>& change, int gesture) {
    Scene after = scene_;
    change(after);
    push(text, std::move(after), gesture);
}

void Document::push(const QString& text, Scene after, int gesture) {
    setFrame(after.timeline.frame); // never part of a step
    after.timeline.frame = scene_.timeline.frame;
    Scene same = scene_;
    same.lastId = after.lastId;
    if (after != same)
        undoStack_.push(new SceneCommand(*this, text, scene_, std::move(after), gesture));
}

void Document::setCamera(const Camera& camera) {
    if (camera == scene_.camera)
        return;
    scene_.camera = camera;
    const bool wasModified = isModified();
    cameraMoved_ = true;
    SceneDiff changes;
    changes.camera = true;
    Q_EMIT sceneChanged(changes);
    if (!wasModified && isModified())
        Q_EMIT fileChanged();
}

void Document::setFrame(double frame) {
    if (!std::isfinite(frame) || frame == scene_.timeline.frame)
        return;
    const Scene before = scene_;
    scene_.timeline.frame = frame;
    Q_EMIT sceneChanged(diff(before, scene_));
}

void Document::setPreview(std::function<void(Scene&)> change) {
    preview_ = std::move(change);
    Q_EMIT previewChanged();
}

void Document::endPreview() {
    if (preview_)
        setPreview({});
}

Scene Document::shownScene() const {
    Scene shown = scene_;
    if (preview_)
        preview_(shown);
    return shown;
}

void Document::reset(Scene scene, const QString& file, UnknownKeysPtr unknownKeys) {
    const SceneDiff changes = diff(scene_, scene);
    scene_ = std::move(scene);
    file_ = file;
    unknownKeys_ = std::move(unknownKeys);
    cameraMoved_ = false;
    ++revision_;
    const bool hadSelection = !selection_.empty();
    selection_.clear();
    preview_ = {};
    undoStack_.clear();
    Q_EMIT replaced();
    Q_EMIT sceneChanged(changes);
    if (hadSelection)
        Q_EMIT selectionChanged();
    Q_EMIT fileChanged();
}

QString Document::save(const QString& file) {
    const QString absolute = QFileInfo(file).absoluteFilePath();
    if (const auto saved = saveProject(toStdString(absolute), scene_, unknownKeys_); !saved)
        return toQString(describe(saved.error()));
    file_ = absolute;
    cameraMoved_ = false;
    undoStack_.setClean();
    Q_EMIT fileChanged();
    return {};
}

QString Document::title() const {
    return file_.isEmpty() ? tr("Untitled") : QFileInfo(file_).fileName();
}

bool Document::isModified() const {
    // Looking around in a scene that was never saved is no work that could be lost.
    return !undoStack_.isClean() || (cameraMoved_ && !file_.isEmpty());
}

void Document::apply(Scene scene) {
    // Ids are never given out twice, not even after an undo: the render thread may still hold the old ones.
    scene.lastId = std::max(scene.lastId, scene_.lastId);
    const SceneDiff changes = diff(scene_, scene);
    scene_ = std::move(scene);
    ++revision_;
    // Before the change is told, so that no listener meets a selected thing that is gone.
    const bool lost = dropLostSelection();
    Q_EMIT sceneChanged(changes);
    if (lost)
        Q_EMIT selectionChanged();
}

bool Document::dropLostSelection() {
    return std::erase_if(selection_, [this](const EntityRef& entity) { return !exists(scene_, entity); }) > 0;
}

} // namespace prizma
