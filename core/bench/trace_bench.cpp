#include "core/bench/trace_bench.h"

#include "core/bench/embree_peer.h"
#include "core/bench/ray_sets.h"
#include "core/bench/statistics_of.h"
#include "core/render/ray_query.h"
#include "core/scene/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prizma::bench {
namespace {

struct RaySet {
    const char* name;
    std::span<const DeviceRay> rays;
    RayQueryMode mode;

    bool anyHit() const { return isOcclusion(mode); }
};

/// Whether two hits of a ray are at different places. On one and the same triangle they are not: what is left
/// there is rounding, which is large beside the distance of a near hit under a grazing angle.
bool endsElsewhere(const DeviceHit& ours, const DeviceHit& theirs, bool anyHit) {
    if (std::isinf(ours.t) || std::isinf(theirs.t) || anyHit)
        return std::isinf(ours.t) != std::isinf(theirs.t);
    if (ours.instance == theirs.instance && ours.primitive == theirs.primitive)
        return false;
    return !(std::abs(ours.t - theirs.t) <= 1e-4f * std::abs(theirs.t));
}

/// The reference tracer, answering as the kernels do.
class Judge {
  public:
    Judge(const Scene& scene, const reference::Tracer& tracer, const glm::dvec3& origin)
        : tracer_(tracer), origin_(origin) {
        const Hierarchy hierarchy(scene);
        std::uint32_t instances = 0;
        for (const Object& object : scene.objects)
            instanceOf_.push_back(object.mesh && hierarchy.isShown(object) ? instances++ : PRIZMA_NO_HIT);
    }

    DeviceHit hit(const reference::Ray& ray, bool anyHit) const {
        DeviceHit none{std::numeric_limits<float>::infinity(), 0.0f, 0.0f, PRIZMA_NO_HIT, PRIZMA_NO_HIT};
        if (anyHit) {
            none.t = tracer_.occluded(ray) ? 0.0f : none.t;
            return none;
        }
        const auto found = tracer_.closestHit(ray);
        if (!found)
            return none;
        return {static_cast<float>(found->t), static_cast<float>(found->u), static_cast<float>(found->v),
                instanceOf_[found->object], found->primitive};
    }

    /// True if the reference contradicts a hit even when the ray is moved by what single precision may lose:
    /// a ray that passes an edge that closely can go either way.
    bool refutes(const DeviceHit& hit, const DeviceRay& deviceRay, bool anyHit) const {
        const reference::Ray ray = referenceRay(deviceRay, origin_);
        double size = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            size =
                std::max({size, std::abs(ray.origin[axis] - origin_[axis]), std::abs(ray.direction[axis])});
        constexpr double share = 4e-6;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner{(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                                    (i & 4) != 0 ? 1.0 : -1.0};
            reference::Ray moved = ray;
            moved.origin += corner * (share * size);
            if (!endsElsewhere(hit, this->hit(moved, anyHit), anyHit))
                return false;
        }
        return endsElsewhere(hit, this->hit(ray, anyHit), anyHit);
    }

  private:
    const reference::Tracer& tracer_;
    glm::dvec3 origin_;
    std::vector<std::uint32_t> instanceOf_; ///< By object.
};

class TraceBench {
  public:
    TraceBench(const Scene& scene, const TraceBenchOptions& options, RayQuery query)
        : options_(options),
          query_(std::move(query)),
          origin_(query_.origin()),
          tracer_(scene),
          judge_(scene, tracer_, origin_),
          fast_(EmbreePeer::create(scene, origin_, false)),
          robust_(EmbreePeer::create(scene, origin_, true)),
          scene_(scene) {}

    Result<TraceReport> run();

  private:
    std::vector<glm::ivec2> sizes() const;
    Result<void> measureSize(const glm::ivec2& size, TraceReport& report);
    Result<TraceResult> measureSet(const RaySet& set);
    Result<void> compare(const RaySet& set, TraceResult& result);

    TraceBenchOptions options_;
    RayQuery query_;
    glm::dvec3 origin_;
    reference::Tracer tracer_;
    Judge judge_;
    std::unique_ptr<EmbreePeer> fast_;
    std::unique_ptr<EmbreePeer> robust_;
    const Scene& scene_;
};

Result<void> TraceBench::compare(const RaySet& set, TraceResult& result) {
    const auto ours = query_.hits();
    if (!ours)
        return std::unexpected(ours.error());
    if (robust_)
        robust_->trace(set.rays, {set.anyHit(), false, false});
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        const DeviceHit& hit = (*ours)[i];
        const DeviceHit theirs =
            robust_ ? robust_->hits()[i] : judge_.hit(referenceRay(set.rays[i], origin_), set.anyHit());
        if (!endsElsewhere(hit, theirs, set.anyHit()))
            continue;
        ++result.mismatches;
        result.wrong += judge_.refutes(hit, set.rays[i], set.anyHit()) ? 1 : 0;
    }
    return {};
}

Result<TraceResult> TraceBench::measureSet(const RaySet& set) {
    if (auto ok = query_.setRays(set.rays); !ok)
        return std::unexpected(ok.error());
    if (auto warmUp = query_.trace(set.mode); !warmUp) // the kernel's first launch compiles it
        return std::unexpected(warmUp.error());
    // Embree traces shadow packets faster when told that they are coherent, and diffuse ones slower.
    const bool coherent = set.mode != RayQueryMode::Closest;
    const auto rate = [&](double milliseconds) {
        return static_cast<double>(set.rays.size()) / std::max(milliseconds, 1e-6) * 1e-3;
    };
    std::vector<double> ours, single, packet16, robustSingle, robustPacket16;
    for (int i = 0; i < options_.repeats; ++i) {
        // Each side's first run after the other's is not timed: workers of the other still look for more work
        // then, and its own have to wake up.
        auto milliseconds = query_.trace(set.mode);
        if (milliseconds)
            milliseconds = query_.trace(set.mode);
        if (!milliseconds)
            return std::unexpected(milliseconds.error());
        ours.push_back(rate(*milliseconds));
        if (!fast_)
            continue;
        const auto embreeRate = [&](EmbreePeer& peer, bool packets) {
            const EmbreeCall call{set.anyHit(), packets, coherent};
            peer.trace(set.rays, call);
            return rate(peer.trace(set.rays, call));
        };
        single.push_back(embreeRate(*fast_, false));
        packet16.push_back(embreeRate(*fast_, true));
        robustSingle.push_back(embreeRate(*robust_, false));
        robustPacket16.push_back(embreeRate(*robust_, true));
    }
    TraceResult result;
    result.rays = set.name;
    result.rayCount = set.rays.size();
    result.mraysPerSecond = median(ours);
    if (fast_) {
        const EmbreeRates rates{median(single), median(packet16), median(robustSingle),
                                median(robustPacket16)};
        result.embree = rates;
        result.ratio = result.mraysPerSecond / std::max(rates.single, rates.packet16);
        result.ratioRobust = result.mraysPerSecond / std::max(rates.robustSingle, rates.robustPacket16);
    }
    if (auto ok = compare(set, result); !ok)
        return std::unexpected(ok.error());
    return result;
}

std::vector<glm::ivec2> TraceBench::sizes() const {
    if (options_.width > 0 || options_.height > 0) // 16 : 9 where only one is given
        return {{options_.width > 0 ? options_.width : std::max(options_.height * 16 / 9, 1),
                 options_.height > 0 ? options_.height : std::max(options_.width * 9 / 16, 1)}};
    if (query_.deviceType() == DeviceType::Gpu)
        return {{1920, 1080}, {3840, 2160}};
    return {{1280, 720}};
}

Result<void> TraceBench::measureSize(const glm::ivec2& size, TraceReport& report) {
    const RaySets rays = makeRaySets(scene_, tracer_, origin_, size.x, size.y);
    const RaySet sets[] = {{"camera", rays.camera, RayQueryMode::ClosestPacket},
                           {"diffuse", rays.diffuse, RayQueryMode::Closest},
                           {"shadow", rays.shadow, RayQueryMode::AnyPacket}};
    for (const RaySet& set : sets) {
        if (set.rays.empty()) // the camera sees nothing that could bounce a ray
            continue;
        auto result = measureSet(set);
        if (!result)
            return std::unexpected(result.error());
        result->width = size.x;
        result->height = size.y;
        report.results.push_back(std::move(*result));
    }
    return {};
}

Result<TraceReport> TraceBench::run() {
    TraceReport report;
    report.device = query_.deviceName();
    report.layout = query_.layout();
    report.deviceBytes = query_.deviceBytes();
    for (const glm::ivec2& size : sizes())
        if (auto ok = measureSize(size, report); !ok)
            return std::unexpected(ok.error());
    return report;
}

} // namespace

Result<TraceReport> benchTrace(const Scene& scene, const TraceBenchOptions& options) {
    const Hierarchy hierarchy(scene);
    std::size_t triangles = 0;
    for (const Object& object : scene.objects)
        triangles += object.mesh && hierarchy.isShown(object) ? object.mesh->triangles.size() : 0;
    if (triangles == 0)
        return failure("There is nothing to trace in the scene.");
    auto query = RayQuery::create(scene, options.deviceId);
    if (!query)
        return std::unexpected(query.error());
    auto report = TraceBench(scene, options, std::move(*query)).run();
    if (report)
        report->triangles = triangles;
    return report;
}

} // namespace prizma::bench
