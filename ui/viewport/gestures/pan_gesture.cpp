#include "ui/viewport/gestures/pan_gesture.h"

#include "core/scene/camera_motion.h"

namespace prizma {

bool PanGesture::startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const {
    return button == Qt::MiddleButton || (button == Qt::LeftButton && keys.testFlag(Qt::ShiftModifier));
}

void PanGesture::begin(const QPointF& position) {
    grabbedDepth_.reset();
    context_.pick(position, [this, number = ++number_](const Pick& pick) {
        if (number != number_ || pick.object == noId)
            return;
        const double depth = depthOf(context_.camera(), pick.position);
        if (depth > 0.0)
            grabbedDepth_ = depth;
    });
}

void PanGesture::drag(const QPointF& from, const QPointF& to) {
    const Camera& camera = context_.camera();
    const double depth = grabbedDepth_.value_or(depthOf(camera, camera.target));
    context_.moveCamera(pan(camera, context_.wayOf(from, to), depth));
}

} // namespace prizma
