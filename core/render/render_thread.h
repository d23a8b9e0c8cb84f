#pragma once

#include "core/compute/device.h"
#include "core/diagnostic.h"
#include "core/render/picture.h"
#include "core/render/statistics.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace prizma {

/// What somebody wants to see.
struct RenderRequest {
    Scene scene;
    int width = 0; ///< Of the view, in device pixels.
    int height = 0;
    bool interacting = false;     ///< A gesture is going on: the resolution may drop to hold the frame rate.
    bool paused = false;          ///< Keep the picture that is there.
    double resolutionScale = 1.0; ///< 1 is a sample a pixel; at most 1.
};

/// A finished pass, ready for the screen.
struct Frame {
    int width = 0; ///< May be less than requested while interacting; stretch it over the view.
    int height = 0;
    std::vector<std::uint8_t> pixels; ///< RGBA, sRGB, top row first.
    int samples = 0;                  ///< In each pixel so far.
    int sampleLimit = 0;
    bool isFinal = false;    ///< Nothing more comes until the next request.
    bool isDenoised = false; ///< `pixels` are a smoothed preview: to be said beside them.
    Camera camera;           ///< The camera it shows.
    Scene scene; ///< The snapshot it shows: what is drawn over the picture fits it, however late it is.
    RenderStatistics statistics;
};

using FramePtr = std::shared_ptr<const Frame>;

/// What the pointer is on.
struct Pick {
    Id object = noId;         ///< noId: the background.
    glm::dvec3 position{0.0}; ///< Hit point in world space.
};

/// Called on the render thread: hand over and return at once.
struct RenderEvents {
    std::function<void(FramePtr)> frame;
    std::function<void(Diagnostic)> message;         ///< Something went wrong; rendering goes on if it can.
    std::function<void(DeviceInfo)> deviceChanged;   ///< This device renders from now on.
    std::function<void(std::string, bool)> activity; ///< "Building kernels", true: started, false: done.
};

/// Renders in a thread of its own. No call waits for the device: the latest request wins, a pass that is
/// going on is dropped between two chunks of about 30 ms. Without a device it reports so and stays quiet.
class RenderThread {
  public:
    /// Starts on the device `deviceId` names, or on the default one.
    RenderThread(RenderEvents events, std::string deviceId);
    ~RenderThread();

    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    void submit(RenderRequest request);

    /// Changes the device; the scene stays. If the new one fails, a message says why and the old one goes on.
    void selectDevice(std::string deviceId);

    /// Finds what the centre of pixel (x, y) of the requested view shows; answers on the render thread.
    void pick(double x, double y, std::function<void(Pick)> answer);

    /// Takes the picture of the last request as soon as it has a whole sample in each pixel, at full size and
    /// never denoised, as a file of `format` needs it; answers on the render thread. Errors: nothing is there
    /// and nothing comes, as rendering is paused or has no device.
    void capture(PictureFormat format, std::function<void(Result<Picture>)> answer);

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

} // namespace prizma
