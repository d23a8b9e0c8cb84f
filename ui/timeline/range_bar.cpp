#include "ui/timeline/range_bar.h"

#include "core/animation/pose_key.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"
#include "ui/timeline/clip_edits.h"
#include "ui/timeline/labelled_field.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace prizma {
namespace {

const std::vector<EntityRef> timelineEntity{{EntityKind::Timeline}};

ClipPtr chosenClip(const Document& document) {
    const Object* object = timelineObject(document);
    return object ? findClip(*object, object->clip) : nullptr;
}

} // namespace

RangeBar::RangeBar(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), fit_(new QToolButton) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    start_ = addField(*layout, tr("Start"), "start", true);
    layout->addStretch(1);
    rate_ = addField(*layout, tr("Frames a second"), "fps", false);
    layout->addStretch(1);
    end_ = addField(*layout, tr("End"), "end", true);

    fit_->setObjectName(QStringLiteral("fitRange"));
    fit_->setIcon(icon(QStringLiteral("fit-range")));
    fit_->setToolTip(tr("Make start, end and frame rate those of the clip"));
    fit_->setAutoRaise(true);
    fit_->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(fit_);
    connect(fit_, &QToolButton::clicked, this, &RangeBar::fit);
    connect(&document, &Document::sceneChanged, this, [this](const SceneDiff& changes) {
        if (!changes.isTimeOnly() || document_.scene().timeline.fps != rate_->value())
            refresh();
    });
    connect(&document, &Document::selectionChanged, this, &RangeBar::refresh);
    refresh();
}

NumberField* RangeBar::addField(QBoxLayout& layout, const QString& label, const char* key, bool integer) {
    auto* field = addLabelledField(layout, label, QStringLiteral("-00000"));
    field->setObjectName(QString::fromLatin1(key));
    field->setInteger(integer);
    field->setStep(1.0);
    for (const PropertyInfo& property : properties(document_.scene(), timelineEntity.front()))
        if (property.key == key) {
            field->setRange(property.minimum, property.maximum);
            field->setToolTip(translated(property.help));
        }
    connect(field, &NumberField::gestureStarted, this, [this] { gesture_ = document_.newGesture(); });
    connect(field, &NumberField::gestureFinished, this, [this] { gesture_ = 0; });
    connect(field, &NumberField::valueEdited, this, [this, key, integer](double value) {
        const PropertyValue typed = integer ? PropertyValue(static_cast<int>(value)) : PropertyValue(value);
        document_.setProperty(timelineEntity, key, typed, gesture_);
    });
    return field;
}

void RangeBar::refresh() {
    const Timeline& timeline = document_.scene().timeline;
    start_->setValue(timeline.start);
    start_->setRange(-Timeline::furthestFrame, timeline.end);
    rate_->setValue(timeline.fps);
    end_->setValue(timeline.end);
    end_->setRange(timeline.start, Timeline::furthestFrame);
    fit_->setEnabled(chosenClip(document_) != nullptr);
}

void RangeBar::fit() {
    if (const ClipPtr clip = chosenClip(document_))
        fitTimeline(document_, *timelineObject(document_), *clip);
}

} // namespace prizma
