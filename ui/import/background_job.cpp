#include "ui/import/background_job.h"

namespace prizma {

BackgroundJob::BackgroundJob(QString label, Work work, QObject* parent)
    : QObject(parent), label_(std::move(label)) {
    poll_.setInterval(50);
    connect(&poll_, &QTimer::timeout, this, [this] { Q_EMIT progressed(progress_->fraction()); });
    poll_.start();
    thread_ = std::jthread([this, work = std::move(work)] {
        auto delivery = work(*progress_);
        // The destructor joins this thread, so that `this` is alive; a call that is still queued then is
        // dropped.
        QMetaObject::invokeMethod(
            this, [this, delivery = std::move(delivery)] { workDone(delivery); }, Qt::QueuedConnection);
    });
}

BackgroundJob::~BackgroundJob() {
    progress_->cancel();
}

void BackgroundJob::cancel() {
    if (finished_)
        return;
    finished_ = true;
    progress_->cancel();
    poll_.stop();
    Q_EMIT finished();
}

void BackgroundJob::workDone(const Delivery& delivery) {
    deleteLater();
    if (finished_)
        return;
    finished_ = true;
    poll_.stop();
    if (delivery)
        delivery();
    Q_EMIT finished();
}

} // namespace prizma
