#pragma once

#include "core/render/render_thread.h"
#include "core/scene/camera.h"

#include <QPointF>

#include <glm/glm.hpp>

#include <functional>

class QWidget;

namespace prizma {

class Document;
class InteractionClock;
class RenderSession;

/// What gestures may know and do: where places are in the view, what lies there, and moving the camera.
/// Positions are those of mouse events: in the view's own coordinates.
class GestureContext {
  public:
    /// Keeps references to all of them.
    GestureContext(QWidget& view, Document& document, RenderSession& session, InteractionClock& clock);

    Document& document() { return document_; }
    const Camera& camera() const;

    /// Moves the camera as part of a gesture.
    void moveCamera(const Camera& camera);

    /// See camera_motion.h for what a place is.
    glm::dvec2 placeAt(const QPointF& position) const;

    /// A way across the view in half picture heights, y up.
    glm::dvec2 wayOf(const QPointF& from, const QPointF& to) const { return placeAt(to) - placeAt(from); }

    /// Finds out what is at `position`; the answer comes later, unless the view is gone by then.
    void pick(const QPointF& position, std::function<void(const Pick&)> answer);

  private:
    QWidget& view_;
    Document& document_;
    RenderSession& session_;
    InteractionClock& clock_;
};

} // namespace prizma
