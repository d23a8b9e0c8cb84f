#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace prizma {

class TimelineController;

/// The Playback menu; the timeline's buttons are the same commands. Their keys are ones that text fields,
/// lists and buttons need for themselves (Space, arrows, Home and End), so that they work only in the widgets
/// that ask for them.
class PlaybackActions : public QObject {
    Q_OBJECT

  public:
    /// Keeps a reference to `controller`.
    explicit PlaybackActions(TimelineController& controller, QObject* parent = nullptr);

    void fillMenu(QMenu& menu);

    /// All keys work while `widget`, or one within it, has the focus.
    void addKeysTo(QWidget& widget);
    /// The same with Space and Shift+Space only.
    void addPlayKeysTo(QWidget& widget);

    QAction* play() const { return play_; }
    QAction* stop() const { return stop_; }
    QAction* stepBack() const { return stepBack_; }
    QAction* stepForward() const { return stepForward_; }
    QAction* toStart() const { return toStart_; }
    QAction* toEnd() const { return toEnd_; }
    QList<QAction*> modes() const;

  private:
    QAction* make(const char* iconName, const QString& text, const QKeySequence& key, const QString& tip);
    void makeModes();
    void showState();

    TimelineController& controller_;
    QAction* play_;
    QAction* playBackwards_;
    QAction* stop_;
    QAction* stepBack_;
    QAction* stepForward_;
    QAction* toStart_;
    QAction* toEnd_;
    QActionGroup* modes_;
};

} // namespace prizma
