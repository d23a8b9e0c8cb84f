#include "core/render/render_thread.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <condition_variable>
#include <future>
#include <mutex>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Collects what a render thread says.
class Listener {
  public:
    RenderEvents events() {
        return {[this](FramePtr frame) { add(frames_, std::move(frame)); },
                [this](Diagnostic message) { add(messages_, std::move(message)); },
                [this](DeviceInfo device) { add(devices_, std::move(device)); },
                {}};
    }

    /// Waits for a frame that fits; null after ten seconds.
    FramePtr waitForFrame(const std::function<bool(const Frame&)>& fits) {
        return waitFor<FramePtr>(frames_, [&](const FramePtr& frame) { return fits(*frame); });
    }
    Diagnostic waitForMessage() {
        return waitFor<Diagnostic>(messages_, [](const Diagnostic&) { return true; });
    }
    std::size_t frameCount() {
        const std::lock_guard lock(mutex_);
        return frames_.size();
    }
    std::size_t messageCount() {
        const std::lock_guard lock(mutex_);
        return messages_.size();
    }

  private:
    template <class T>
    void add(std::vector<T>& list, T item) {
        {
            const std::lock_guard lock(mutex_);
            list.push_back(std::move(item));
        }
        changed_.notify_all();
    }

    template <class T>
    T waitFor(const std::vector<T>& list, const std::function<bool(const T&)>& fits) {
        std::unique_lock lock(mutex_);
        T found{};
        changed_.wait_for(lock, std::chrono::seconds(60), [&] {
            for (const T& item : list)
                if (fits(item)) {
                    found = item;
                    return true;
                }
            return false;
        });
        return found;
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<FramePtr> frames_;
    std::vector<Diagnostic> messages_;
    std::vector<DeviceInfo> devices_;
};

RenderRequest makeRequest(int samples = 4) {
    RenderRequest request;
    const Id white = addMaterial(request.scene, lambert());
    addObject(request.scene, primitiveObject(PrimitiveType::Sphere, 1.0, white, {0, 1, 0}));
    Light light;
    light.position = {2, 3, 4};
    light.intensity = 15.0; // mid grey in the middle, so that exposure shows
    addLight(request.scene, light);
    request.scene.render.samples = samples;
    request.width = 160;
    request.height = 120;
    return request;
}

} // namespace

class RenderThreadTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase();
    void rendersToTheLimitAndStops();
    void latestRequestWins();
    void renamingKeepsTheSamples();
    void exposureKeepsTheSamples();
    void interactionMayLowerTheResolution();
    void pausedKeepsStill();
    void unknownDeviceLeavesTheOldOne();
    void picksTheObjectUnderThePointer();
    void emptyAndDegenerateScenesAreDrawn();
    void stopsInTheMiddle();
};

void RenderThreadTest::initTestCase() {
    if (chooseDevice(listDevices(), {}) < 0)
        QSKIP("There is no OpenCL device here.");
}

void RenderThreadTest::rendersToTheLimitAndStops() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    thread.submit(makeRequest(9));
    const FramePtr last = listener.waitForFrame([](const Frame& f) { return f.isFinal; });
    QVERIFY(last);
    QCOMPARE(last->samples, 9);
    QCOMPARE(last->width, 160);
    QCOMPARE(last->pixels.size(), std::size_t(160 * 120 * 4));
    const std::size_t frames = listener.frameCount();
    QTest::qSleep(300);
    QCOMPARE(listener.frameCount(), frames);
    QCOMPARE(listener.messageCount(), 0u);
}

void RenderThreadTest::latestRequestWins() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request = makeRequest(3);
    for (int i = 0; i < 200; ++i) {
        request.scene.camera.position.x = i * 0.01;
        thread.submit(request);
    }
    const FramePtr last = listener.waitForFrame(
        [&](const Frame& f) { return f.isFinal && f.camera == request.scene.camera && f.samples == 3; });
    QVERIFY(last);
    QVERIFY(listener.frameCount() < 200);
}

void RenderThreadTest::renamingKeepsTheSamples() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request = makeRequest(6);
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal; }));
    request.scene.objects.edit()[0].name = "renamed";
    request.scene.render.samples = 8;
    thread.submit(request);
    const FramePtr next = listener.waitForFrame([](const Frame& f) { return f.sampleLimit == 8; });
    QVERIFY(next);
    QVERIFY(next->samples >= 7);
}

void RenderThreadTest::exposureKeepsTheSamples() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request = makeRequest(6);
    thread.submit(request);
    const FramePtr dark = listener.waitForFrame([](const Frame& f) { return f.isFinal; });
    QVERIFY(dark);
    request.scene.render.exposure = 2.0;
    thread.submit(request);
    const FramePtr bright =
        listener.waitForFrame([&](const Frame& f) { return f.isFinal && f.pixels != dark->pixels; });
    QVERIFY(bright);
    QCOMPARE(bright->samples, 6);
    const std::size_t middle = 4 * (60 * 160 + 80);
    QVERIFY(bright->pixels[middle] > dark->pixels[middle]);
}

void RenderThreadTest::interactionMayLowerTheResolution() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request = makeRequest(2);
    request.width = 1600;
    request.height = 1200;
    request.interacting = true;
    thread.submit(request);
    const FramePtr first = listener.waitForFrame([](const Frame&) { return true; });
    QVERIFY(first);
    QVERIFY(first->width <= 1600 && first->width >= 64);
    request.interacting = false;
    thread.submit(request);
    const FramePtr full = listener.waitForFrame([](const Frame& f) { return f.isFinal && f.width == 1600; });
    QVERIFY(full);
    QCOMPARE(full->height, 1200);
}

void RenderThreadTest::pausedKeepsStill() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request = makeRequest(4);
    request.paused = true;
    thread.submit(request);
    QTest::qSleep(300);
    QCOMPARE(listener.frameCount(), 0u);
    request.paused = false;
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal; }));
}

void RenderThreadTest::unknownDeviceLeavesTheOldOne() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    thread.submit(makeRequest(3));
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal; }));
    thread.selectDevice("no such device");
    QVERIFY(listener.waitForMessage().message.find("no such device") != std::string::npos);
    RenderRequest request = makeRequest(5);
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal && f.samples == 5; }));
}

void RenderThreadTest::picksTheObjectUnderThePointer() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    const RenderRequest request = makeRequest(1);
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal; }));
    std::promise<Pick> middle;
    std::promise<Pick> corner;
    thread.pick(80, 60, [&](Pick pick) { middle.set_value(pick); });
    thread.pick(1, 1, [&](Pick pick) { corner.set_value(pick); });
    const Pick hit = middle.get_future().get();
    QCOMPARE(hit.object, request.scene.objects[0].id);
    QVERIFY(std::abs(glm::length(hit.position - glm::dvec3(0, 1, 0)) - 0.5) < 0.01);
    QCOMPARE(corner.get_future().get().object, noId);
}

void RenderThreadTest::emptyAndDegenerateScenesAreDrawn() {
    Listener listener;
    RenderThread thread(listener.events(), {});
    RenderRequest request;
    request.scene.render.samples = 2;
    request.width = 33;
    request.height = 17;
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal && f.width == 33; }));
    Object flat = primitiveObject(PrimitiveType::Cube, 1.0, noId);
    flat.transform.scale = {0, 1, 1};
    addObject(request.scene, flat);
    flat.transform.translation = {std::nan(""), 0, 0};
    addObject(request.scene, flat);
    request.scene.camera.target = request.scene.camera.position;
    request.width = 34;
    thread.submit(request);
    QVERIFY(listener.waitForFrame([](const Frame& f) { return f.isFinal && f.width == 34; }));
    QCOMPARE(listener.messageCount(), 0u);
}

void RenderThreadTest::stopsInTheMiddle() {
    for (int i = 0; i < 3; ++i) {
        Listener listener;
        RenderThread thread(listener.events(), {});
        RenderRequest request = makeRequest(100000);
        request.width = 1600;
        request.height = 1200;
        thread.submit(request);
        QTest::qSleep(50 * i);
    }
}

QTEST_GUILESS_MAIN(RenderThreadTest)
#include "tst_render_thread.moc"
