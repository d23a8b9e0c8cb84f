#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace prizma {

/// Says whether somebody is moving something right now: from the first movement until a short while after the
/// last. Its timer runs only in that time.
class InteractionClock : public QObject {
    Q_OBJECT

  public:
    explicit InteractionClock(QObject* parent = nullptr);

    bool isInteracting() const { return timer_.isActive(); }

    /// A gesture moved something.
    void noteMovement() { timer_.start(); }

    /// The scene or the view changed for whatever reason: only changes in quick succession are an
    /// interaction.
    void noteChange();

  Q_SIGNALS:
    void ended();

  private:
    QTimer timer_;
    QElapsedTimer sinceChange_;
};

} // namespace prizma
