#include "ui/viewport/gestures/zoom_anchor.h"

#include "core/scene/camera_motion.h"

namespace prizma {
namespace {

constexpr qint64 rest = 600;      // ms
constexpr double samePlace = 3.0; // Hands shake by this many pixels while they turn a wheel.
constexpr double nearest = 1e-6;  // Of the target's distance: closer hits would stop the zoom.

} // namespace

void ZoomAnchor::aim(const QPointF& position) {
    const bool goesOn = sinceAimed_.isValid() && !sinceAimed_.hasExpired(rest) &&
                        (position - position_).manhattanLength() <= samePlace;
    sinceAimed_.start();
    if (goesOn)
        return;
    position_ = position;
    hit_.reset();
    context_.pick(position, [this, number = ++number_](const Pick& pick) {
        if (number == number_ && pick.object != noId)
            hit_ = pick.position;
    });
}

glm::dvec3 ZoomAnchor::point() const {
    const Camera& camera = context_.camera();
    const double targetDepth = depthOf(camera, camera.target);
    const double hitDepth = hit_ ? depthOf(camera, *hit_) : targetDepth;
    const double depth = hitDepth > nearest * targetDepth ? hitDepth : targetDepth;
    return pointInPicture(camera, context_.placeAt(position_), depth);
}

} // namespace prizma
