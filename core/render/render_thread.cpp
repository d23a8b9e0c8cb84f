#include "core/render/render_thread.h"

#include "core/render/interactive_resolution.h"
#include "core/render/renderer.h"
#include "core/thread_priority.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

namespace prizma {
namespace {

using Clock = std::chrono::steady_clock;

/// While samples accumulate quickly, the screen gets no more pictures than it can show.
constexpr auto shortestFrameTime = std::chrono::milliseconds(30);

/// Denoising takes at most about the fourth part of the time: samples make a better picture than smoothing.
constexpr int denoisingPause = 4;

/// Whether two requests differ in nothing that a pass in progress depends on.
bool wantSamePass(const RenderRequest& a, const RenderRequest& b) {
    SceneDiff changes = diff(a.scene, b.scene);
    changes.samples = changes.exposure = false; // who pauses keeps the samples that are there
    return changes.isEmpty() && a.width == b.width && a.height == b.height &&
           a.interacting == b.interacting && a.resolutionScale == b.resolutionScale;
}

struct PickRequest {
    double x = 0.0, y = 0.0;
    std::function<void(Pick)> answer;
};

struct CaptureRequest {
    PictureFormat format;
    std::function<void(Result<Picture>)> answer;
};

} // namespace

class RenderThread::Worker {
  public:
    Worker(RenderEvents events, std::string deviceId)
        : events_(std::move(events)),
          wantedDevice_(std::move(deviceId)),
          thread_([this](const std::stop_token& stop) { run(stop); }) {}

    ~Worker() {
        thread_.request_stop();
        wake([] {});
    }

    void submit(RenderRequest request) {
        wake([&] { pending_ = std::move(request); });
    }
    void selectDevice(std::string deviceId) {
        wake([&] { wantedDevice_ = std::move(deviceId); });
    }
    void pick(PickRequest request) {
        wake([&] { picks_.push_back(std::move(request)); });
    }
    void capture(CaptureRequest request) {
        wake([&] {
            captures_.push_back(std::move(request));
            captureAsked_ = true;
        });
    }

  private:
    /// Changes what the two threads share and wakes the render thread.
    template <class Change>
    void wake(Change&& change) {
        {
            const std::lock_guard lock(mutex_);
            change();
        }
        changed_.notify_all();
    }

    void run(const std::stop_token& stop);
    void waitForWork(const std::stop_token& stop);
    void takeRequest();
    void changeDevice(const std::string& deviceId);
    void answerPicks();
    void answerCaptures();
    bool work(const std::stop_token& stop);
    bool finishPass(const std::stop_token& stop);
    bool isStale();
    void showFrame(bool isFinal);
    void report(const Diagnostic& error);
    void reportActivity();

    std::pair<int, int> pictureSize() const;

    const RenderEvents events_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<RenderRequest> pending_;    ///< Not yet looked at.
    std::optional<std::string> wantedDevice_; ///< To change to.
    std::deque<PickRequest> picks_;
    std::deque<CaptureRequest> captures_;
    bool captureAsked_ = false; ///< Since the thread last waited.
    bool treeReady_ = false;

    // Only the render thread touches these.
    std::unique_ptr<Renderer> renderer_;
    std::optional<RenderRequest> request_;
    InteractiveResolution interactiveResolution_;
    Clock::time_point lastShown_;
    Clock::duration denoising_{}; ///< How long it took for the last frame.
    bool hasWork_ = false;        ///< More samples, or something changed.
    bool complete_ = false;       ///< What is drawn lacks no object whose tree is still being built.
    bool settled_ = false;        ///< The last frame said that nothing more comes.
    std::string activity_;

    std::jthread thread_; ///< Last: it uses everything above.
};

void RenderThread::Worker::run(const std::stop_token& stop) {
    lowerThreadPriority();
    while (!stop.stop_requested()) {
        waitForWork(stop);
        if (stop.stop_requested())
            return;
        std::optional<std::string> device;
        {
            const std::lock_guard lock(mutex_);
            device.swap(wantedDevice_);
        }
        if (device)
            changeDevice(*device);
        takeRequest();
        if (renderer_ && request_) {
            answerPicks();
            hasWork_ = work(stop);
        } else {
            hasWork_ = false;
        }
        answerCaptures();
    }
}

void RenderThread::Worker::waitForWork(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [this] {
        return hasWork_ || pending_ || wantedDevice_ || (renderer_ && request_ && !picks_.empty()) ||
               treeReady_ || captureAsked_;
    });
    treeReady_ = captureAsked_ = false;
}

void RenderThread::Worker::takeRequest() {
    const std::lock_guard lock(mutex_);
    if (!pending_)
        return;
    // A change that needs no kernel (a name, the timeline's end) still wants a frame that tells its scene.
    if (request_ && request_->scene != pending_->scene)
        settled_ = false;
    request_ = std::exchange(pending_, std::nullopt);
}

void RenderThread::Worker::changeDevice(const std::string& deviceId) {
    if (renderer_ && renderer_->device().id == deviceId)
        return;
    RendererOptions options;
    options.deviceId = deviceId;
    options.treeReady = [this] { wake([this] { treeReady_ = true; }); };
    options.building = [this] {
        if (events_.activity && activity_.empty())
            events_.activity("Preparing kernels", true);
    };
    auto made = Renderer::create(std::move(options));
    if (events_.activity)
        events_.activity("Preparing kernels", false);
    if (!made && !renderer_ && !deviceId.empty()) {
        // The device of the last session is gone: say so, and start on the default one.
        report(made.error());
        changeDevice({});
        return;
    }
    if (!made) {
        report(made.error());
        return;
    }
    renderer_ = std::move(*made);
    interactiveResolution_ = {};
    if (events_.deviceChanged)
        events_.deviceChanged(renderer_->device());
}

void RenderThread::Worker::report(const Diagnostic& error) {
    if (events_.message)
        events_.message(error);
}

void RenderThread::Worker::reportActivity() {
    const std::string activity = renderer_->isBuildingTrees() ? "Building trees" : "";
    if (activity == activity_ || !events_.activity)
        return;
    if (!activity_.empty())
        events_.activity(activity_, false);
    activity_ = activity;
    if (!activity_.empty())
        events_.activity(activity_, true);
}

std::pair<int, int> RenderThread::Worker::pictureSize() const {
    const double scale = std::clamp(request_->resolutionScale, 1.0 / 16.0, 1.0);
    const int width = std::max(1, static_cast<int>(request_->width * scale));
    const int height = std::max(1, static_cast<int>(request_->height * scale));
    return request_->interacting ? interactiveResolution_.sizeFor(width, height) : std::pair(width, height);
}

void RenderThread::Worker::answerPicks() {
    std::deque<PickRequest> picks;
    {
        const std::lock_guard lock(mutex_);
        picks.swap(picks_);
    }
    for (PickRequest& request : picks) {
        auto found = renderer_->pick(request.x, request.y, request_->width, request_->height);
        if (!found)
            report(found.error());
        request.answer(found.value_or(Pick{}));
    }
}

void RenderThread::Worker::answerCaptures() {
    const bool isWhole = renderer_ && request_ && renderer_->hasPicture() && !request_->interacting;
    const bool mayCome =
        hasWork_ || (renderer_ && request_ && !request_->paused && (request_->interacting || !complete_));
    if (!isWhole && mayCome)
        return;
    std::deque<CaptureRequest> captures;
    {
        const std::lock_guard lock(mutex_);
        captures.swap(captures_);
    }
    for (const CaptureRequest& capture : captures)
        capture.answer(isWhole ? renderer_->picture({capture.format})
                               : failure("There is no picture yet. Let rendering go on, and try again."));
}

bool RenderThread::Worker::isStale() {
    const std::lock_guard lock(mutex_);
    return wantedDevice_.has_value() || (pending_.has_value() && !wantSamePass(*request_, *pending_));
}

/// One pass at most. True if there is more to do without a new request.
bool RenderThread::Worker::work(const std::stop_token& stop) {
    if (request_->width <= 0 || request_->height <= 0 || request_->paused)
        return false;
    const Scene scene = renderer_->drawable(request_->scene);
    complete_ = scene.objects.shares(request_->scene.objects);
    reportActivity();
    const auto [width, height] = pictureSize();
    const RenderPlan plan = renderer_->plan(scene, width, height);
    if (plan.isEmpty()) {
        if (!settled_ && complete_)
            showFrame(true);
        return false;
    }
    if (auto ok = renderer_->begin(plan, scene, width, height); !ok) {
        report(ok.error());
        return false;
    }
    if (!plan.find(Stage::RayShader)) {
        showFrame(renderer_->samples() >= scene.render.samples);
        return true;
    }
    return finishPass(stop);
}

bool RenderThread::Worker::finishPass(const std::stop_token& stop) {
    const auto start = Clock::now();
    while (true) {
        const auto done = renderer_->step();
        if (!done) {
            report(done.error());
            return false;
        }
        if (*done)
            break;
        if (stop.stop_requested())
            return false;
        if (isStale() && !request_->interacting) {
            // A pass at full resolution gives way to whatever is newer; one of a gesture is short and is
            // shown, or a mouse that never rests would never see a picture.
            renderer_->drop();
            return true;
        }
    }
    const double elapsed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    settled_ = false;
    const bool isFinal = renderer_->samples() >= request_->scene.render.samples;
    const bool isFirst = renderer_->samples() == 1;
    const auto pause = std::max<Clock::duration>(shortestFrameTime, denoisingPause * denoising_);
    if (isFinal || isFirst || Clock::now() - lastShown_ >= pause)
        showFrame(isFinal);
    interactiveResolution_.measured(static_cast<double>(renderer_->width()) * renderer_->height(),
                                    elapsed + std::chrono::duration<double, std::milli>(denoising_).count());
    return true;
}

void RenderThread::Worker::showFrame(bool isFinal) {
    auto preview = renderer_->preview();
    if (!preview) {
        report(preview.error());
        return;
    }
    denoising_ = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double, std::milli>(preview->milliseconds));
    auto frame = std::make_shared<Frame>();
    frame->width = renderer_->width();
    frame->height = renderer_->height();
    frame->pixels = std::move(preview->pixels);
    frame->isDenoised = preview->isDenoised;
    frame->samples = renderer_->samples();
    frame->sampleLimit = request_->scene.render.samples;
    frame->isFinal = isFinal && complete_;
    frame->camera = request_->scene.camera;
    frame->scene = request_->scene;
    frame->statistics = renderer_->statistics(true);
    lastShown_ = Clock::now();
    settled_ = frame->isFinal;
    if (events_.frame)
        events_.frame(std::move(frame));
}

RenderThread::RenderThread(RenderEvents events, std::string deviceId)
    : worker_(std::make_unique<Worker>(std::move(events), std::move(deviceId))) {}

RenderThread::~RenderThread() = default;

void RenderThread::submit(RenderRequest request) {
    worker_->submit(std::move(request));
}

void RenderThread::selectDevice(std::string deviceId) {
    worker_->selectDevice(std::move(deviceId));
}

void RenderThread::pick(double x, double y, std::function<void(Pick)> answer) {
    worker_->pick({x, y, std::move(answer)});
}

void RenderThread::capture(PictureFormat format, std::function<void(Result<Picture>)> answer) {
    worker_->capture({format, std::move(answer)});
}

} // namespace prizma
