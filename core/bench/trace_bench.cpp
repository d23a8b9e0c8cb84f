#include "core/bench/trace_bench.h"

#include "core/bench/embree_peer.h"
#include "core/bench/ray_sets.h"
#include "core/bench/statistics_of.h"
#include "core/render/ray_query.h"

#include <algorithm>
#include <cmath>

namespace prizma::bench {
namespace {

struct RaySet {
    const char* name;
    std::span<const DeviceRay> rays;
    RayQueryMode mode;

    bool anyHit() const { return mode == RayQueryMode::Any; }
};

bool endsElsewhere(float ours, float theirs, bool anyHit) {
    if (std::isinf(ours) || std::isinf(theirs) || anyHit)
        return std::isinf(ours) != std::isinf(theirs);
    return !(std::abs(ours - theirs) <= 1e-4f * std::abs(theirs));
}

/// How the reference sees a ray, in the form of a device hit's `t`.
float referenceEnd(const reference::Tracer& tracer, const reference::Ray& ray, bool anyHit) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (anyHit)
        return tracer.occluded(ray) ? 0.0f : infinity;
    const auto hit = tracer.closestHit(ray);
    return hit ? static_cast<float>(hit->t) : infinity;
}

/// True if the reference contradicts a hit even when the ray is moved by what single precision may lose: a
/// ray that passes an edge that closely can go either way.
bool isClearlyWrong(const reference::Tracer& tracer, const DeviceRay& deviceRay, const glm::dvec3& origin,
                    float ours, bool anyHit) {
    const reference::Ray ray = referenceRay(deviceRay, origin);
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        size = std::max({size, std::abs(ray.origin[axis] - origin[axis]), std::abs(ray.direction[axis])});
    constexpr double share = 4e-6;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner{(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                                (i & 4) != 0 ? 1.0 : -1.0};
        reference::Ray moved = ray;
        moved.origin += corner * (share * size);
        if (!endsElsewhere(ours, referenceEnd(tracer, moved, anyHit), anyHit))
            return false;
    }
    return endsElsewhere(ours, referenceEnd(tracer, ray, anyHit), anyHit);
}

class TraceBench {
public:
    TraceBench(const Scene& scene, const TraceBenchOptions& options, RayQuery query)
        : options_(options),
          query_(std::move(query)),
          origin_(query_.origin()),
          tracer_(scene),
          fast_(EmbreePeer::create(scene, origin_, false)),
          robust_(EmbreePeer::create(scene, origin_, true)) {
        sets_ = makeRaySets(scene, tracer_, origin_, options.width, options.height);
    }

    Result<TraceReport> run();

private:
    Result<TraceResult> measureSet(const RaySet& set);
    Result<void> compare(const RaySet& set, TraceResult& result);

    TraceBenchOptions options_;
    RayQuery query_;
    glm::dvec3 origin_;
    reference::Tracer tracer_;
    std::unique_ptr<EmbreePeer> fast_;
    std::unique_ptr<EmbreePeer> robust_;
    RaySets sets_;
};

Result<void> TraceBench::compare(const RaySet& set, TraceResult& result) {
    const auto ours = query_.hits();
    if (!ours)
        return std::unexpected(ours.error());
    if (robust_)
        robust_->trace(set.rays, {set.anyHit(), false, false});
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        const float t = (*ours)[i].t;
        const float theirs = robust_
                                 ? robust_->hits()[i].t
                                 : referenceEnd(tracer_, referenceRay(set.rays[i], origin_), set.anyHit());
        if (!endsElsewhere(t, theirs, set.anyHit()))
            continue;
        ++result.mismatches;
        result.wrong += isClearlyWrong(tracer_, set.rays[i], origin_, t, set.anyHit()) ? 1 : 0;
    }
    return {};
}

Result<TraceResult> TraceBench::measureSet(const RaySet& set) {
    if (auto ok = query_.setRays(set.rays); !ok)
        return std::unexpected(ok.error());
    if (auto warmUp = query_.trace(set.mode); !warmUp) // the kernel's first launch compiles it
        return std::unexpected(warmUp.error());
    const bool coherent = set.mode == RayQueryMode::ClosestPacket;
    const auto rate = [&](double milliseconds) {
        return static_cast<double>(set.rays.size()) / std::max(milliseconds, 1e-6) * 1e-3;
    };
    std::vector<double> ours, single, packet16, robustSingle, robustPacket16;
    for (int i = 0; i < options_.repeats; ++i) {
        const auto milliseconds = query_.trace(set.mode);
        if (!milliseconds)
            return std::unexpected(milliseconds.error());
        ours.push_back(rate(*milliseconds));
        if (!fast_)
            continue;
        single.push_back(rate(fast_->trace(set.rays, {set.anyHit(), false, coherent})));
        packet16.push_back(rate(fast_->trace(set.rays, {set.anyHit(), true, coherent})));
        robustSingle.push_back(rate(robust_->trace(set.rays, {set.anyHit(), false, coherent})));
        robustPacket16.push_back(rate(robust_->trace(set.rays, {set.anyHit(), true, coherent})));
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

Result<TraceReport> TraceBench::run() {
    TraceReport report;
    report.device = query_.deviceName();
    const RaySet sets[] = {{"camera", sets_.camera, RayQueryMode::ClosestPacket},
                           {"diffuse", sets_.diffuse, RayQueryMode::Closest},
                           {"shadow", sets_.shadow, RayQueryMode::Any}};
    for (const RaySet& set : sets) {
        if (set.rays.empty()) // the camera sees nothing that could bounce a ray
            continue;
        auto result = measureSet(set);
        if (!result)
            return std::unexpected(result.error());
        report.results.push_back(std::move(*result));
    }
    return report;
}

} // namespace

Result<TraceReport> benchTrace(const Scene& scene, const TraceBenchOptions& options) {
    std::size_t triangles = 0;
    for (const Object& object : scene.objects)
        triangles += object.visible && object.mesh ? object.mesh->triangles.size() : 0;
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
