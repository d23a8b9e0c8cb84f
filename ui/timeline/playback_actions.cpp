#include "ui/timeline/playback_actions.h"

#include "ui/main_window/theme.h"
#include "ui/timeline/timeline_controller.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace prizma {

PlaybackActions::PlaybackActions(TimelineController& controller, QObject* parent)
    : QObject(parent),
      controller_(controller),
      play_(make("play", tr("&Play"), Qt::Key_Space, tr("Play the timeline, or pause it"))),
      playBackwards_(make("play", tr("Play &Backwards"), Qt::SHIFT | Qt::Key_Space,
                          tr("Play the timeline the other way, or pause it"))),
      stop_(make("stop", tr("&Stop"), {}, tr("Pause, and go back to the start"))),
      stepBack_(make("step-back", tr("P&revious Frame"), Qt::Key_Left, tr("Go back a frame"))),
      stepForward_(make("step-forward", tr("&Next Frame"), Qt::Key_Right, tr("Go on a frame"))),
      toStart_(make("to-start", tr("&First Frame"), Qt::Key_Home, tr("Go to the start of the timeline"))),
      toEnd_(make("to-end", tr("&Last Frame"), Qt::Key_End, tr("Go to the end of the timeline"))),
      modes_(new QActionGroup(this)) {
    playBackwards_->setIcon({});
    connect(play_, &QAction::triggered, this, [this] { controller_.setPlaying(!controller_.isPlaying()); });
    connect(playBackwards_, &QAction::triggered, this, [this] {
        if (controller_.isPlaying() && controller_.isBackwards())
            controller_.pause();
        else
            controller_.playBackwards();
    });
    connect(stop_, &QAction::triggered, &controller_, &TimelineController::stop);
    connect(stepBack_, &QAction::triggered, &controller_, [this] { controller_.stepBy(-1); });
    connect(stepForward_, &QAction::triggered, &controller_, [this] { controller_.stepBy(1); });
    connect(toStart_, &QAction::triggered, &controller_, &TimelineController::goToStart);
    connect(toEnd_, &QAction::triggered, &controller_, &TimelineController::goToEnd);
    makeModes();
    connect(&controller_, &TimelineController::playingChanged, this, &PlaybackActions::showState);
    connect(&controller_, &TimelineController::settingsChanged, this, &PlaybackActions::showState);
    showState();
}

QAction* PlaybackActions::make(const char* iconName, const QString& text, const QKeySequence& key,
                               const QString& tip) {
    auto* action = new QAction(icon(QString::fromLatin1(iconName)), text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setStatusTip(tip);
    return action;
}

void PlaybackActions::makeModes() {
    const auto add = [this](PlayMode mode, const char* iconName, const QString& text) {
        auto* action = new QAction(icon(QString::fromLatin1(iconName)), text, modes_);
        action->setCheckable(true);
        action->setData(static_cast<int>(mode));
        connect(action, &QAction::triggered, this, [this, mode] { controller_.setPlayMode(mode); });
    };
    add(PlayMode::Loop, "play-loop", tr("L&oop"));
    add(PlayMode::Once, "play-once", tr("On&ce"));
    add(PlayMode::PingPong, "play-ping-pong", tr("Back and For&th"));
}

QList<QAction*> PlaybackActions::modes() const {
    return modes_->actions();
}

void PlaybackActions::showState() {
    const bool playing = controller_.isPlaying();
    play_->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    play_->setText(playing ? tr("&Pause") : tr("&Play"));
    for (QAction* mode : modes_->actions())
        mode->setChecked(mode->data().toInt() == static_cast<int>(controller_.playMode()));
}

void PlaybackActions::fillMenu(QMenu& menu) {
    menu.addActions({play_, playBackwards_, stop_});
    menu.addSeparator();
    menu.addActions({stepBack_, stepForward_, toStart_, toEnd_});
    menu.addSeparator();
    menu.addActions(modes_->actions());
}

void PlaybackActions::addKeysTo(QWidget& widget) {
    widget.addActions({play_, playBackwards_, stepBack_, stepForward_, toStart_, toEnd_});
}

void PlaybackActions::addPlayKeysTo(QWidget& widget) {
    widget.addActions({play_, playBackwards_});
}

} // namespace prizma
