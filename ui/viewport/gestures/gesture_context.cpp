#include "ui/viewport/gestures/gesture_context.h"

#include "ui/document/document.h"
#include "ui/viewport/interaction_clock.h"
#include "ui/viewport/render_session.h"

#include <QPointer>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace prizma {

GestureContext::GestureContext(QWidget& view, Document& document, RenderSession& session,
                               InteractionClock& clock)
    : view_(view), document_(document), session_(session), clock_(clock) {}

const Camera& GestureContext::camera() const {
    return document_.scene().camera;
}

void GestureContext::moveCamera(const Camera& camera) {
    clock_.noteMovement();
    document_.setCamera(camera);
}

glm::dvec2 GestureContext::placeAt(const QPointF& position) const {
    const double halfWidth = view_.width() * 0.5;
    const double halfHeight = std::max(view_.height(), 1) * 0.5;
    return {(position.x() - halfWidth) / halfHeight, (halfHeight - position.y()) / halfHeight};
}

void GestureContext::pick(const QPointF& position, std::function<void(const Pick&)> answer) {
    const QPointF pixel = position * view_.devicePixelRatioF();
    const QPointer<QWidget> view(&view_);
    session_.pick(std::floor(pixel.x()), std::floor(pixel.y()),
                  [view, answer = std::move(answer)](const Pick& pick) {
                      if (view)
                          answer(pick);
                  });
}

} // namespace prizma
