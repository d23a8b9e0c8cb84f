#include "ui/viewport/gestures/click_handlers.h"

#include "core/scene/camera_motion.h"
#include "ui/document/document.h"

#include <algorithm>

namespace prizma {

void SelectClick::click(const QPointF& position, Qt::KeyboardModifiers keys) {
    const bool toggle = (keys & (Qt::ControlModifier | Qt::ShiftModifier)) != 0;
    context_.pick(position, [this, toggle](const Pick& pick) { select(pick.object, toggle); });
}

void SelectClick::select(Id object, bool toggle) {
    Document& document = context_.document();
    if (!document.scene().findObject(object)) {
        // The background, or something that was deleted while the answer was on its way.
        if (!toggle)
            document.setSelection({});
        return;
    }
    const EntityRef entity{EntityKind::Object, object};
    if (!toggle) {
        document.setSelection({entity});
        return;
    }
    auto selection = document.selection();
    if (std::erase(selection, entity) == 0)
        selection.push_back(entity);
    document.setSelection(std::move(selection));
}

void TargetDoubleClick::click(const QPointF& position) {
    context_.pick(position, [this](const Pick& pick) {
        if (pick.object != noId)
            context_.document().setCamera(lookAt(context_.camera(), pick.position));
    });
}

} // namespace prizma
