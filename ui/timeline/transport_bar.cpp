#include "ui/timeline/transport_bar.h"

#include "ui/document/document.h"
#include "ui/properties/number_field.h"
#include "ui/timeline/labelled_field.h"
#include "ui/timeline/playback_actions.h"
#include "ui/timeline/timeline_controller.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double fastest = 100.0;
constexpr double timeGrain = 0.01; // Seconds; finer ones are neither shown nor meant.

/// The frame that somebody means who asks for a time as it is shown: a whole one, if it would be shown so.
double frameAt(double seconds, double fps) {
    const double frame = seconds * fps;
    const double nearest = std::round(frame);
    return std::abs(frame - nearest) <= 0.5 * timeGrain * fps + 1e-9 ? nearest : frame;
}

} // namespace

TransportBar::TransportBar(Document& document, TimelineController& controller, const PlaybackActions& actions,
                           QWidget* parent)
    : QWidget(parent), document_(document), controller_(controller) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (QAction* action : {actions.toStart(), actions.stepBack(), actions.play(), actions.stop(),
                            actions.stepForward(), actions.toEnd()})
        addButton(action);
    layout->addSpacing(8);
    makeModeButton(actions);
    makeFields();
    connect(&document, &Document::sceneChanged, this, &TransportBar::showPlace);
    connect(&controller, &TimelineController::settingsChanged, this, &TransportBar::showSettings);
    showPlace();
    showSettings();
}

/// Without the focus, or Space would press the button that was clicked last instead of playing.
QToolButton* TransportBar::addButton(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    layout()->addWidget(button);
    return button;
}

void TransportBar::makeModeButton(const PlaybackActions& actions) {
    mode_ = new QToolButton;
    mode_->setObjectName(QStringLiteral("playMode"));
    mode_->setAutoRaise(true);
    mode_->setFocusPolicy(Qt::NoFocus);
    mode_->setPopupMode(QToolButton::InstantPopup);
    mode_->setToolTip(tr("What comes after the last frame"));
    auto* menu = new QMenu(mode_);
    menu->addActions(actions.modes());
    mode_->setMenu(menu);
    layout()->addWidget(mode_);
}

NumberField* TransportBar::addField(const QString& label, const char* name, const QString& tip,
                                    const QString& longest) {
    auto* field = addLabelledField(static_cast<QBoxLayout&>(*layout()), label, longest);
    field->setObjectName(QString::fromLatin1(name));
    field->setToolTip(tip);
    return field;
}

void TransportBar::makeFields() {
    speed_ = addField(tr("Speed"), "speed", tr("1 is real time; below 0 it plays backwards"),
                      QStringLiteral("-0.00 ×"));
    speed_->setUnit(QStringLiteral("×"));
    speed_->setRange(-fastest, fastest);
    connect(speed_, &NumberField::valueEdited, &controller_, &TimelineController::setSpeed);
    static_cast<QHBoxLayout*>(layout())->addStretch(1);

    frame_ = addField(tr("Frame"), "frame", tr("The frame that is shown"), QStringLiteral("00000"));
    frame_->setStep(1.0);
    connect(frame_, &NumberField::valueEdited, &controller_, &TimelineController::goTo);
    time_ = addField(tr("Time"), "time", tr("Where that is in seconds"), QStringLiteral("000.00 s"));
    time_->setUnit(QStringLiteral("s"));
    connect(time_, &NumberField::valueEdited, this,
            [this](double seconds) { controller_.goTo(frameAt(seconds, document_.scene().timeline.fps)); });
    for (NumberField* field : {frame_, time_}) {
        connect(field, &NumberField::gestureStarted, &controller_, &TimelineController::beginScrub);
        connect(field, &NumberField::gestureFinished, &controller_, &TimelineController::endScrub);
    }
}

void TransportBar::showPlace() {
    const Timeline& timeline = document_.scene().timeline;
    // While playing, parts of frames and of seconds are too quick to be read.
    const bool playing = controller_.isPlaying();
    const double frame = playing ? std::floor(timeline.frame + 1e-6) : timeline.frame;
    const double seconds = timeline.seconds();
    for (auto [field, value] :
         {std::pair(frame_, frame), std::pair(time_, std::round(seconds / timeGrain) * timeGrain)})
        if (field->value() != value)
            field->setValue(value);
    time_->setStep(timeline.fps > 0.0 ? 1.0 / timeline.fps : 0.1);
    frame_->setRange(timeline.start, std::max(timeline.start, timeline.end));
}

void TransportBar::showSettings() {
    speed_->setValue(controller_.speed());
    for (const QAction* mode : mode_->menu()->actions())
        if (mode->isChecked())
            mode_->setIcon(mode->icon());
}

} // namespace prizma
