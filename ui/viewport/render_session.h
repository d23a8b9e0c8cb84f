#pragma once

#include "core/render/render_thread.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <mutex>

namespace prizma {

/// The Qt face of RenderThread: every answer arrives as a signal, or as a call, on the thread that this
/// object lives in. No member waits for the device.
class RenderSession : public QObject {
    Q_OBJECT

  public:
    /// Starts on the device `deviceId` names, or on the default one if it is empty or not there.
    explicit RenderSession(const QString& deviceId, QObject* parent = nullptr);

    /// Waits for the chunk that is being rendered, no longer. No signal and no answer comes after it.
    ~RenderSession() override;

    /// Asks for a picture; whatever was asked for before and is not finished is dropped.
    void submit(RenderRequest request);

    /// Changes the device. `deviceChanged` confirms it; if it fails, `message` says why and the old one goes
    /// on.
    void selectDevice(const QString& deviceId);

    /// Finds what pixel (x, y) of the view that was last asked for shows. `answer` is called on the UI
    /// thread, or never if this session ends first.
    void pick(double x, double y, std::function<void(prizma::Pick)> answer);

    /// Takes the present picture for a file (RenderThread::capture). `answer` is called on the UI thread, or
    /// never if this session ends first.
    void capture(PictureFormat format, std::function<void(prizma::Result<prizma::Picture>)> answer);

    /// The device that renders; its id is empty until one does.
    const DeviceInfo& device() const { return device_; }

  Q_SIGNALS:
    /// The newest picture; older ones that the UI thread had no time for are left out.
    void frameReady(prizma::FramePtr frame);
    void message(prizma::Diagnostic diagnostic);
    void deviceChanged(prizma::DeviceInfo device);
    /// "Building kernels" and the like; `running` is false when it is done.
    void activityChanged(const QString& what, bool running);

  private:
    RenderEvents makeEvents();
    void post(FramePtr frame);
    void deliverFrame();

    DeviceInfo device_;
    std::mutex mutex_;
    FramePtr newest_; ///< Guarded by `mutex_`; not null: a delivery is on its way.
    /// Last, so that it ends before anything that its callbacks use.
    std::unique_ptr<RenderThread> thread_;
};

} // namespace prizma
