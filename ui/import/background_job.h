#pragma once

#include "core/progress.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <thread>

namespace prizma {

/// One long piece of work in a thread of its own. The work gives back a delivery: a function that is called
/// on the UI thread, unless the job was cancelled. A job deletes itself some time after it has finished.
class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(Progress&)>;

    /// Starts at once. `label` says what goes on ("Importing bunny.obj").
    BackgroundJob(QString label, Work work, QObject* parent);
    ~BackgroundJob() override;

    const QString& label() const { return label_; }

    /// Over for the user at once; the thread may need a moment longer to notice.
    void cancel();

  Q_SIGNALS:
    void progressed(double fraction);
    void finished(); ///< After the delivery or after being cancelled; exactly once.

  private:
    void workDone(const Delivery& delivery);

    QString label_;
    std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();
    QTimer poll_;
    bool finished_ = false;
    std::jthread thread_; ///< Last: joined before the rest goes.
};

} // namespace prizma
