#include "ui/viewport/render_session.h"

#include <QMetaObject>

#include <utility>

namespace prizma {

// The callbacks run on the render thread. They only post events to this object; events that are still queued
// when it is destroyed are dropped by Qt, and RenderThread's destructor waits for callbacks that are running.

RenderSession::RenderSession(const QString& deviceId, QObject* parent)
    : QObject(parent), thread_(std::make_unique<RenderThread>(makeEvents(), deviceId.toStdString())) {}

RenderSession::~RenderSession() = default;

RenderEvents RenderSession::makeEvents() {
    RenderEvents events;
    events.frame = [this](FramePtr frame) { post(std::move(frame)); };
    events.message = [this](Diagnostic diagnostic) {
        QMetaObject::invokeMethod(
            this, [this, diagnostic = std::move(diagnostic)] { Q_EMIT message(diagnostic); },
            Qt::QueuedConnection);
    };
    events.deviceChanged = [this](DeviceInfo device) {
        const auto change = [this, device = std::move(device)] {
            device_ = device;
            Q_EMIT deviceChanged(device_);
        };
        QMetaObject::invokeMethod(this, change, Qt::QueuedConnection);
    };
    events.activity = [this](const std::string& what, bool running) {
        const auto change = [this, what = QString::fromStdString(what), running] {
            Q_EMIT activityChanged(what, running);
        };
        QMetaObject::invokeMethod(this, change, Qt::QueuedConnection);
    };
    return events;
}

void RenderSession::submit(RenderRequest request) {
    thread_->submit(std::move(request));
}

void RenderSession::selectDevice(const QString& deviceId) {
    thread_->selectDevice(deviceId.toStdString());
}

void RenderSession::pick(double x, double y, std::function<void(prizma::Pick)> answer) {
    thread_->pick(x, y, [this, answer = std::move(answer)](Pick pick) {
        QMetaObject::invokeMethod(
            this, [answer, pick] { answer(pick); }, Qt::QueuedConnection);
    });
}

void RenderSession::capture(PictureFormat format,
                            std::function<void(prizma::Result<prizma::Picture>)> answer) {
    thread_->capture(format, [this, answer = std::move(answer)](Result<Picture> picture) {
        QMetaObject::invokeMethod(
            this, [answer, picture = std::move(picture)] { answer(picture); }, Qt::QueuedConnection);
    });
}

void RenderSession::post(FramePtr frame) {
    if (!frame)
        return;
    const std::scoped_lock lock(mutex_);
    const bool deliveryPending = newest_ != nullptr;
    newest_ = std::move(frame);
    if (!deliveryPending)
        QMetaObject::invokeMethod(
            this, [this] { deliverFrame(); }, Qt::QueuedConnection);
}

void RenderSession::deliverFrame() {
    FramePtr frame;
    {
        const std::scoped_lock lock(mutex_);
        frame = std::exchange(newest_, nullptr);
    }
    Q_EMIT frameReady(frame);
}

} // namespace prizma
