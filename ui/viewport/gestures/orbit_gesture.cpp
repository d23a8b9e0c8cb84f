#include "ui/viewport/gestures/orbit_gesture.h"

#include "core/scene/camera_motion.h"

#include <numbers>

namespace prizma {
namespace {

constexpr double radiansPerHalfHeight = std::numbers::pi / 2.0;

} // namespace

bool OrbitGesture::startsWith(Qt::MouseButton button, Qt::KeyboardModifiers keys) const {
    return button == Qt::LeftButton && !keys.testFlag(Qt::ShiftModifier);
}

void OrbitGesture::drag(const QPointF& from, const QPointF& to) {
    const glm::dvec2 turn = context_.wayOf(from, to) * -radiansPerHalfHeight;
    context_.moveCamera(orbit(context_.camera(), turn.x, turn.y));
}

} // namespace prizma
