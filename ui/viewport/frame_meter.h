#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>

namespace prizma {

/// Counts the pictures that were shown in the last second. Its timer runs only while there are any.
class FrameMeter : public QObject {
    Q_OBJECT

  public:
    explicit FrameMeter(QObject* parent = nullptr);

    void noteFrame();
    double framesPerSecond() const;

  Q_SIGNALS:
    /// Four times a second while pictures come, with 0 at last.
    void updated(double framesPerSecond);

  private:
    void update();

    QElapsedTimer clock_;
    QTimer timer_;
    std::deque<qint64> shown_; ///< When, in ms of `clock_`; oldest first.
};

} // namespace prizma
