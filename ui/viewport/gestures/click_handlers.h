#pragma once

#include "ui/viewport/gestures/gesture_context.h"

#include <Qt>

namespace prizma {

/// Click: selects the object under the pointer; with Ctrl or Shift, adds it or takes it away; on the
/// background, selects nothing.
class SelectClick {
  public:
    explicit SelectClick(GestureContext& context) : context_(context) {}

    void click(const QPointF& position, Qt::KeyboardModifiers keys);

  private:
    void select(Id object, bool toggle);

    GestureContext& context_;
};

/// Double click on an object: the camera turns to the point that was hit and orbits about it from then on.
class TargetDoubleClick {
  public:
    explicit TargetDoubleClick(GestureContext& context) : context_(context) {}

    void click(const QPointF& position);

  private:
    GestureContext& context_;
};

} // namespace prizma
