#pragma once

#include "core/compute/context.h"
#include "core/render/device_scene.h"
#include "core/render/film.h"
#include "core/render/picture.h"
#include "core/render/picture_display.h"
#include "core/render/preview_denoiser.h"
#include "core/render/render_plan.h"
#include "core/render/render_thread.h"
#include "core/render/statistics.h"

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

namespace prizma {

struct RendererOptions {
    std::string deviceId;             ///< Empty: the default device.
    std::optional<TreeLayout> layout; ///< Nothing: what suits the device.
    std::function<void()> treeReady;  ///< From another thread: a tree that a scene waits for has been built.
    std::function<void()> building;   ///< Before kernels are compiled.
    bool packets = true;    ///< RayShader may work on packets of pixels, on devices where that pays.
    bool renewTrees = true; ///< Build trees anew, in the background, that refitting has worn out.
};

/// Where a recording shader puts its rays.
struct RayRecord {
    Buffer<DeviceRecordedRay> rays;
    Buffer<std::uint32_t> count; ///< One, of the rays that there are, also where there is no room for them.
    std::uint32_t capacity = 0;
};

/// A picture for the screen, sRGB RGBA.
struct Preview {
    std::vector<std::uint8_t> pixels;
    bool isDenoised = false;   ///< To be said wherever it is shown.
    double milliseconds = 0.0; ///< That the device spent on denoising.
};

/// Renders scenes on one device: plans, brings the device up to date, adds sample after sample. For one
/// thread.
class Renderer {
  public:
    static Result<std::unique_ptr<Renderer>> create(RendererOptions options);
    ~Renderer();

    const DeviceInfo& device() const { return context_->info(); }
    TreeLayout layout() const { return trees_.layout(); }

    /// The scene with what can be drawn now: meshes whose trees are still being built are taken out. The
    /// first call for a mesh starts its build.
    Scene drawable(Scene scene);

    /// Waits for the trees of all visible objects.
    void waitForTrees(const Scene& scene);

    bool isBuildingTrees() const { return trees_.isBuilding(); }

    /// What it would take to come to the next sample of `scene`, which `drawable` gave.
    RenderPlan plan(const Scene& scene, int width, int height) const;

    /// Brings the device up to the plan and starts its pass, if it has one. After an error the device's
    /// content counts as lost and the next plan starts from nothing.
    Result<void> begin(const RenderPlan& plan, const Scene& scene, int width, int height);

    /// Works for about 30 ms on the pass. True: the pass is complete, or there was none.
    Result<bool> step();

    /// Leaves a pass half done.
    void drop();

    int samples() const { return state_.samples; }
    int width() const { return state_.width; }
    int height() const { return state_.height; }

    /// The picture for a screen, sRGB RGBA, through the scene's exposure and view transform; never denoised.
    Result<std::vector<std::uint8_t>> display();

    /// The picture for a preview: denoised where the scene's settings want that.
    Result<Preview> preview();

    /// The picture as these files need it; never denoised.
    Result<Picture> picture(std::initializer_list<PictureFormat> formats);

    /// False while a pass was left half done: the picture is no use.
    bool hasPicture() const { return state_.scene && state_.samples > 0 && !state_.dropped; }

    /// Linear radiance and coverage, RGBA.
    Result<std::vector<float>> mean();

    /// Of the last plan and pass. Rays, times of the pass and pixels that are no numbers are read from the
    /// device (two bytes a pixel): only where `readWork` is set.
    RenderStatistics statistics(bool readWork);

    /// For measurements: all rays of the last pass, which is repeated twice with a shader that writes them
    /// down. Those of a packet stand together, sixteen in a row; ones that only fill it up have tMax -1. The
    /// picture is lost. Errors: no pass yet, no memory.
    Result<std::vector<DeviceRecordedRay>> recordRays();

    /// What the centre of a pixel of a view shows; the scene is the one of the last `begin`.
    Result<Pick> pick(double x, double y, int viewWidth, int viewHeight);

    Context& context() { return *context_; }
    KernelSet& kernels() { return *kernels_; }
    DeviceScene& deviceScene() { return *deviceScene_; }
    const glm::dvec3& anchor() const { return state_.anchor; }

  private:
    Renderer(std::unique_ptr<Context> context, TreeLayout layout, std::function<void()> treeReady);

    Result<void> update(const RenderPlan& plan, const Scene& scene);
    Result<void> launchChunk(std::uint32_t count, const RayRecord* recorder = nullptr);
    Result<void> traceCameraRays(std::uint32_t count, ClEvent& generated, ClEvent& traced);
    void addWork(RenderStatistics& statistics);
    DeviceView viewOf(const Scene& scene, int width, int height) const;
    DeviceShading shadingOf(const Scene& scene) const;
    void record(Stage stage, double milliseconds);
    SummedPicture summed() const { return {film_.sums, film_.width, film_.height, state_.samples}; }
    RenderSettings settings() const;
    Result<SummedPicture> denoised();

    std::unique_ptr<Context> context_;
    TreeStore trees_;
    std::unique_ptr<KernelSet> kernels_;
    std::unique_ptr<DeviceScene> deviceScene_;
    DeviceState state_;
    Film film_;
    PictureDisplay display_;
    std::optional<PreviewDenoiser> denoiser_; ///< While it is wanted.
    bool hasGuides_ = false;                  ///< Of the present picture.

    RenderPlan plan_;
    RayShader* rayShader_ = nullptr;
    DeviceView view_{};
    DeviceShading shading_{};
    std::uint32_t nextPixel_ = 0;
    bool inPass_ = false;
    double pixelsPerMillisecond_ = 0.0; ///< Of the last chunk, to size the next.
    std::vector<StageStatistics> stageStatistics_;
    std::chrono::steady_clock::time_point began_;
    double passMilliseconds_ = 0.0;
    PassTimes passTimes_; ///< As far as the kernels' own times tell.
};

} // namespace prizma
