#include "core/render/renderer.h"

#include "core/render/sampling.h"
#include "core/render/work_totals.h"

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double chunkMilliseconds = 25.0; // a newer snapshot waits no longer than about this
constexpr std::uint32_t firstChunk = 1u << 14;
constexpr std::uint32_t tilePixels = 64;

double since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void store(float (&target)[3], const glm::dvec3& value) {
    for (int i = 0; i < 3; ++i)
        target[i] = static_cast<float>(value[i]);
}

} // namespace

Renderer::Renderer(std::unique_ptr<Context> context, TreeLayout layout, std::function<void()> treeReady)
    : context_(std::move(context)), trees_(layout, std::move(treeReady)) {}

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(RendererOptions options) {
    auto context = Context::create(options.deviceId);
    if (!context)
        return std::unexpected(context.error());
    const TreeLayout layout = options.layout.value_or(layoutFor((*context)->info().type));
    auto kernels = KernelSet::create(**context, layout, std::move(options.building), options.packets);
    if (!kernels)
        return std::unexpected(kernels.error());
    std::unique_ptr<Renderer> made(new Renderer(std::move(*context), layout, std::move(options.treeReady)));
    made->kernels_ = std::make_unique<KernelSet>(std::move(*kernels));
    made->deviceScene_ =
        std::make_unique<DeviceScene>(*made->context_, *made->kernels_, layout, options.renewTrees);
    return made;
}

Scene Renderer::drawable(Scene scene) {
    const Hierarchy hierarchy(scene);
    std::vector<MeshPtr> wanted;
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!object.mesh)
            continue;
        wanted.push_back(object.mesh);
        if (hierarchy.isShown(object) && !trees_.request(object.mesh))
            waiting.push_back(i);
    }
    state_.newTrees = deviceScene_->newTrees(trees_, wanted);
    trees_.keepOnly(wanted);
    for (const std::size_t i : waiting)
        scene.objects.edit()[i].mesh = nullptr;
    return scene;
}

void Renderer::waitForTrees(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    for (const Object& object : scene.objects)
        if (isDrawn(hierarchy, object))
            trees_.wait(object.mesh);
}

RenderPlan Renderer::plan(const Scene& scene, int width, int height) const {
    return makePlan(state_, scene, width, height);
}

void Renderer::record(Stage stage, double milliseconds) {
    const PlannedStage* planned = plan_.find(stage);
    for (StageStatistics& entry : stageStatistics_)
        if (entry.stage == describe(stage)) {
            entry.milliseconds += milliseconds;
            return;
        }
    stageStatistics_.push_back({describe(stage), planned ? planned->why : std::string(), milliseconds,
                                planned ? static_cast<int>(planned->objects.size()) : 0});
}

Result<void> Renderer::update(const RenderPlan& plan, const Scene& scene) {
    std::set<Id> present;
    for (const Object& object : scene.objects)
        if (object.mesh)
            present.insert(object.id);
    std::erase_if(state_.resident, [&](Id id) { return !present.contains(id); });
    std::erase_if(state_.poses, [&](const auto& pose) { return !present.contains(pose.first); });
    deviceScene_->removeAllBut(present);
    for (const PlannedStage& stage : plan.stages) {
        if (stage.stage >= Stage::GenerateCameraRays)
            break;
        const auto start = Clock::now();
        if (auto ok = deviceScene_->run(stage, scene, plan.anchor, trees_, state_); !ok)
            return ok;
        if (auto ok = context_->finish(); !ok)
            return ok;
        record(stage.stage, since(start));
    }
    return deviceScene_->ensure();
}

Result<void> Renderer::begin(const RenderPlan& plan, const Scene& scene, int width, int height) {
    began_ = Clock::now();
    plan_ = plan;
    stageStatistics_.clear();
    const auto fail = [&](const Diagnostic& error) {
        state_.scene.reset();
        inPass_ = false;
        return std::unexpected(error);
    };
    if (auto ok = update(plan, scene); !ok)
        return fail(ok.error());
    if (width != film_.width || height != film_.height)
        if (auto ok = film_.resize(*context_, width, height); !ok)
            return fail(ok.error());
    state_.scene = scene;
    state_.anchor = plan.anchor;
    state_.width = width;
    state_.height = height;
    if (plan.restarts) {
        state_.samples = 0;
        hasGuides_ = false;
    }
    inPass_ = plan.find(Stage::RayShader) != nullptr;
    if (!inPass_)
        return {};
    const auto shader = kernels_->rayShader(*context_, scene.render.shader);
    if (!shader)
        return fail(shader.error());
    rayShader_ = *shader;
    if (!rayShader_->makesRays)
        if (auto ok = film_.reserveRays(*context_); !ok)
            return fail(ok.error());
    passTimes_ = {};
    view_ = viewOf(scene, width, height);
    shading_ = shadingOf(scene);
    nextPixel_ = 0;
    state_.dropped = true; // until the pass is complete
    return {};
}

DeviceView Renderer::viewOf(const Scene& scene, int width, int height) const {
    DeviceView view{};
    const CameraFrame frame = frameOf(scene.camera);
    const double halfHeight = std::tan(glm::radians(scene.camera.fovY) * 0.5);
    const double aspect = static_cast<double>(width) / std::max(height, 1);
    store(view.origin, scene.camera.position - state_.anchor);
    store(view.forward, frame.forward);
    store(view.right, frame.right * (halfHeight * aspect));
    store(view.up, frame.up * halfHeight);
    view.width = width;
    view.height = height;
    view.sample = static_cast<std::uint32_t>(state_.samples);
    view.seed = static_cast<std::uint32_t>(scene.render.seed);
    view.lensRadius = static_cast<float>(scene.camera.lensRadius);
    view.focusDistance = static_cast<float>(focusDistanceOf(scene.camera));
    const glm::vec2 jitter = sobolPoint(view.sample);
    view.jitter[0] = jitter.x;
    view.jitter[1] = jitter.y;
    view.scattered = scene.render.shader == ShaderType::Path ? 1 : 0;
    return view;
}

DeviceShading Renderer::shadingOf(const Scene& scene) const {
    DeviceShading shading{};
    const Background& background = scene.background;
    const bool hasImage = background.image.isSet();
    store(shading.background, (hasImage ? glm::dvec3(1.0) : background.color) * background.intensity);
    store(shading.ambient, (hasImage ? deviceScene_->materials().backgroundImageMean() : background.color) *
                               background.intensity);
    shading.backgroundTexture = deviceScene_->materials().indexOf(background.image);
    const double turn = glm::radians(background.rotation);
    shading.backgroundTurn[0] = static_cast<float>(std::cos(turn));
    shading.backgroundTurn[1] = static_cast<float>(std::sin(turn));
    shading.maxDepth = scene.render.maxDepth;
    shading.fireflyClamp = static_cast<float>(scene.render.fireflyClamp);
    shading.transparentShadows = scene.render.transparentShadows ? 1 : 0;
    shading.sceneRadius = static_cast<float>(deviceScene_->instances().radius());
    return shading;
}

Result<void> Renderer::traceCameraRays(std::uint32_t count, ClEvent& generated, ClEvent& traced) {
    const std::size_t packets = (count + kernels_->raysAPacket - 1) / kernels_->raysAPacket;
    kernels_->generateCameraRays.setArguments(view_, film_.rays);
    auto launched = kernels_->generateCameraRays.launch(*context_, count, kernels_->groupSize);
    if (!launched)
        return std::unexpected(launched.error());
    generated = std::move(*launched);
    Kernel& trace = kernels_->tracePacket;
    deviceScene_->setSceneArguments(trace);
    trace.addArgument(film_.rays);
    trace.addArgument(film_.hits);
    trace.addArgument(nextPixel_);
    trace.addArgument(count);
    launched = trace.launch(*context_, packets, kernels_->packetGroupSize());
    if (!launched)
        return std::unexpected(launched.error());
    traced = std::move(*launched);
    return {};
}

Result<void> Renderer::launchChunk(std::uint32_t count, const RayRecord* recorder) {
    view_.firstPixel = nextPixel_;
    view_.pixelCount = count;
    const bool makesRays = rayShader_->makesRays;
    ClEvent generated, traced;
    if (!makesRays)
        if (auto ok = traceCameraRays(count, generated, traced); !ok)
            return ok;
    Kernel& shade = rayShader_->kernel;
    deviceScene_->setSceneArguments(shade);
    shade.addArgument(view_);
    shade.addArgument(shading_);
    if (!makesRays) {
        shade.addArgument(film_.rays);
        shade.addArgument(film_.hits);
    }
    shade.addArgument(film_.sums);
    shade.addArgument(film_.losses);
    shade.addArgument(film_.work);
    if (recorder) {
        shade.addArgument(recorder->rays);
        shade.addArgument(recorder->count);
        shade.addArgument(recorder->capacity);
    }
    const std::size_t items = makesRays ? count / kernels_->raysAPacket : count;
    auto shaded =
        shade.launch(*context_, items, makesRays ? kernels_->packetGroupSize() : kernels_->groupSize);
    if (!shaded)
        return std::unexpected(shaded.error());
    if (auto ok = context_->finish(); !ok)
        return ok;
    passTimes_.generate += milliseconds(generated);
    passTimes_.trace += milliseconds(traced);
    passTimes_.shade += milliseconds(*shaded);
    if (!makesRays)
        record(Stage::GenerateCameraRays, milliseconds(generated) + milliseconds(traced));
    record(Stage::RayShader, milliseconds(*shaded));
    return {};
}

Result<bool> Renderer::step() {
    if (!inPass_)
        return true;
    const std::uint32_t left = film_.pixelCount - nextPixel_;
    std::uint32_t count = firstChunk;
    if (pixelsPerMillisecond_ > 0.0)
        count =
            static_cast<std::uint32_t>(std::clamp(pixelsPerMillisecond_ * chunkMilliseconds, 1024.0, 1e9));
    count = std::min(left, (count + tilePixels - 1) / tilePixels * tilePixels);
    const auto start = Clock::now();
    if (auto ok = launchChunk(count); !ok) {
        state_.scene.reset();
        inPass_ = false;
        return std::unexpected(ok.error());
    }
    pixelsPerMillisecond_ = count / std::max(since(start), 1e-3);
    nextPixel_ += count;
    if (nextPixel_ < film_.pixelCount)
        return false;
    inPass_ = false;
    state_.dropped = false;
    ++state_.samples;
    passMilliseconds_ = since(began_);
    return true;
}

void Renderer::drop() {
    inPass_ = false;
}

RenderSettings Renderer::settings() const {
    return state_.scene ? state_.scene->render : RenderSettings{};
}

Result<std::vector<std::uint8_t>> Renderer::display() {
    auto pixels = display_.bytes(*context_, *kernels_, summed(), settings());
    if (pixels)
        record(Stage::Display, display_.milliseconds());
    return pixels;
}

Result<SummedPicture> Renderer::denoised() {
    if (!denoiser_) {
        auto made = PreviewDenoiser::create(*context_, layout(), kernels_->groupSize);
        if (!made)
            return std::unexpected(made.error());
        denoiser_ = std::move(*made);
        hasGuides_ = false;
    }
    if (!hasGuides_)
        if (auto ok = denoiser_->takeGuides(*context_, *kernels_, *deviceScene_, view_); !ok)
            return std::unexpected(ok.error());
    hasGuides_ = true;
    return denoiser_->denoise(*context_, summed());
}

Result<Preview> Renderer::preview() {
    const bool isWanted = hasPicture() && isDenoised(settings());
    if (!isWanted)
        denoiser_.reset();
    const auto shown = isWanted ? denoised() : summed();
    if (!shown)
        return std::unexpected(shown.error());
    auto pixels = display_.bytes(*context_, *kernels_, *shown, settings());
    if (!pixels)
        return std::unexpected(pixels.error());
    const double denoising = isWanted ? denoiser_->milliseconds() : 0.0;
    record(Stage::Display, display_.milliseconds() + denoising);
    return Preview{std::move(*pixels), isWanted, denoising};
}

Result<Picture> Renderer::picture(std::initializer_list<PictureFormat> formats) {
    Picture picture;
    picture.width = film_.width;
    picture.height = film_.height;
    picture.samples = state_.samples;
    const auto take = [](auto made, auto& target) -> Result<void> {
        if (!made)
            return std::unexpected(made.error());
        target = std::move(*made);
        return {};
    };
    for (const PictureFormat format : formats) {
        const auto taken =
            format == PictureFormat::Png8 ? take(display(), picture.display)
            : format == PictureFormat::Png16
                ? take(display_.words(*context_, *kernels_, summed(), settings()), picture.deep)
                : take(mean(), picture.radiance);
        if (!taken)
            return std::unexpected(taken.error());
    }
    return picture;
}

Result<std::vector<float>> Renderer::mean() {
    return display_.mean(*context_, *kernels_, summed());
}

RenderStatistics Renderer::statistics(bool readWork) {
    RenderStatistics result;
    result.device = device().name;
    result.stages = stageStatistics_;
    result.passMilliseconds = passMilliseconds_;
    result.times = passTimes_;
    result.triangles = deviceScene_->instances().triangleCount();
    result.deviceBytes = context_->allocatedBytes();
    result.treeWear = deviceScene_->treeWear();
    result.rays.camera = static_cast<std::uint64_t>(film_.width) * static_cast<std::uint64_t>(film_.height);
    if (readWork && rayShader_)
        addWork(result);
    return result;
}

void Renderer::addWork(RenderStatistics& statistics) {
    const std::size_t pixels = rayShader_->makesRays ? kernels_->raysAPacket : kernels_->groupSize;
    std::vector<DeviceWork> work((film_.pixelCount + pixels - 1) / pixels);
    if (!film_.work.read(*context_, work, 0, "ray counts"))
        return;
    WorkTotals totals;
    for (const DeviceWork& part : work)
        totals.add(part);
    statistics.rays.shadow = totals.shadowRays;
    statistics.rays.secondary = totals.secondaryRays;
    statistics.nonFinitePixels = totals.nonFinite;
    if (!rayShader_->makesRays)
        return;
    statistics.times = totals.split(passTimes_.shade);
    const double tracing = statistics.times.generate + statistics.times.trace;
    const auto shaded =
        std::find_if(statistics.stages.begin(), statistics.stages.end(),
                     [](const auto& entry) { return entry.stage == describe(Stage::RayShader); });
    if (shaded == statistics.stages.end())
        return;
    shaded->milliseconds -= tracing;
    statistics.stages.insert(shaded, {describe(Stage::GenerateCameraRays), shaded->why, tracing, 0});
}

Result<std::vector<DeviceRecordedRay>> Renderer::recordRays() {
    if (!state_.scene || !rayShader_)
        return failure("There is no picture whose rays could be recorded.");
    const auto shader = kernels_->rayShader(*context_, state_.scene->render.shader, true);
    if (!shader)
        return std::unexpected(shader.error());
    RayShader* const ordinary = std::exchange(rayShader_, *shader);
    state_.dropped = true;
    nextPixel_ = 0;
    RayRecord record;
    std::vector<std::uint32_t> count(1, 0);
    Result<void> ok = record.rays.reserve(*context_, 1, "rays");
    for (int run = 0; ok && run < 2; ++run) { // the first only counts
        const std::uint32_t none = 0;
        record.capacity = count.front();
        ok = record.rays.reserve(*context_, record.capacity, "rays");
        if (ok)
            ok = record.count.assign(*context_, std::span(&none, 1), "number of rays");
        if (ok)
            ok = launchChunk(film_.pixelCount, &record);
        if (ok)
            ok = record.count.read(*context_, count, 0, "number of rays");
    }
    rayShader_ = ordinary;
    std::vector<DeviceRecordedRay> rays(std::min(record.capacity, count.front()));
    if (ok)
        ok = record.rays.read(*context_, rays, 0, "rays");
    if (!ok)
        return std::unexpected(ok.error());
    return rays;
}

Result<Pick> Renderer::pick(double x, double y, int viewWidth, int viewHeight) {
    if (!state_.scene || film_.pixelCount == 0)
        return Pick{};
    const CameraFrame frame = frameOf(state_.scene->camera);
    const double halfHeight = std::tan(glm::radians(state_.scene->camera.fovY) * 0.5);
    const double aspect = static_cast<double>(viewWidth) / std::max(viewHeight, 1);
    const double across = (x / std::max(viewWidth, 1) * 2.0 - 1.0) * halfHeight * aspect;
    const double upward = (1.0 - y / std::max(viewHeight, 1) * 2.0) * halfHeight;
    const glm::dvec3 direction = glm::normalize(frame.forward + frame.right * across + frame.up * upward);
    const glm::dvec3 origin = state_.scene->camera.position - state_.anchor;
    DeviceRay ray{};
    store(ray.origin, origin);
    store(ray.direction, direction);
    ray.tMax = INFINITY;
    Buffer<DeviceRay> rays;
    Buffer<DeviceHit> hits;
    std::vector<DeviceHit> found(1);
    if (auto ok = rays.assign(*context_, std::span(&ray, 1), "ray"); !ok)
        return std::unexpected(ok.error());
    if (auto ok = hits.reserve(*context_, 1, "hit"); !ok)
        return std::unexpected(ok.error());
    Kernel& trace = kernels_->traceClosest;
    deviceScene_->setSceneArguments(trace);
    trace.addArgument(rays);
    trace.addArgument(hits);
    trace.addArgument(0u);
    trace.addArgument(1u);
    if (const auto launched = trace.launch(*context_, 1, kernels_->groupSize); !launched)
        return std::unexpected(launched.error());
    if (auto ok = hits.read(*context_, found, 0, "hit"); !ok)
        return std::unexpected(ok.error());
    if (found[0].instance == PRIZMA_NO_HIT)
        return Pick{};
    return Pick{deviceScene_->instances().objectOf(found[0].instance),
                state_.scene->camera.position + direction * static_cast<double>(found[0].t)};
}

} // namespace prizma
