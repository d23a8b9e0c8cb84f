#include "ui/viewport/gestures/zoom_gesture.h"

#include "core/scene/camera_motion.h"

#include <cmath>

namespace prizma {
namespace {

constexpr double factorPerNotch = 0.85;
constexpr double anglePerNotch = 120.0;
constexpr double factorPerHalfHeight = 1.0 / 3.0;

} // namespace

bool ZoomGesture::startsWith(Qt::MouseButton button, Qt::KeyboardModifiers) const {
    return button == Qt::RightButton;
}

void ZoomGesture::drag(const QPointF& from, const QPointF& to) {
    const double factor = std::pow(factorPerHalfHeight, context_.wayOf(from, to).y);
    context_.moveCamera(zoom(context_.camera(), factor, anchor_.point()));
}

void WheelZoom::turn(const QPointF& position, double angle) {
    anchor_.aim(position);
    const double factor = std::pow(factorPerNotch, angle / anglePerNotch);
    context_.moveCamera(zoom(context_.camera(), factor, anchor_.point()));
}

} // namespace prizma
