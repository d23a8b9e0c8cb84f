#include "core/bench/embree_peer.h"

#ifdef PRIZMA_WITH_EMBREE

#include "core/bench/embree_handles.h"
#include "core/bench/statistics_of.h"
#include "core/scene/hierarchy.h"

#include <tbb/parallel_for.h>

#include <array>
#include <limits>

namespace prizma::bench {
namespace {

constexpr std::size_t packetSize = 16;
constexpr std::size_t grain = 64; ///< Packets a task at least.

RTCRay embreeRay(const DeviceRay& ray) {
    RTCRay result{};
    result.org_x = ray.origin[0];
    result.org_y = ray.origin[1];
    result.org_z = ray.origin[2];
    result.tnear = ray.tMin;
    result.dir_x = ray.direction[0];
    result.dir_y = ray.direction[1];
    result.dir_z = ray.direction[2];
    result.tfar = ray.tMax;
    result.mask = ~0u;
    return result;
}

class Peer final : public EmbreePeer {
  public:
    Peer(const Scene& scene, const glm::dvec3& origin, bool robust)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(scene_.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        const Hierarchy hierarchy(scene);
        for (const Object& object : scene.objects) {
            if (!object.mesh || !hierarchy.isShown(object))
                continue;
            const glm::dmat4 matrix = hierarchy.worldMatrix(object);
            EmbreeCorners corners;
            corners.reserve(object.mesh->positions.size() + 1);
            for (const glm::vec3& position : object.mesh->positions)
                corners.emplace_back(glm::dvec3(matrix * glm::dvec4(glm::dvec3(position), 1.0)) - origin);
            meshes_.push_back(object.mesh);
            corners_.push_back(padded(std::move(corners)));
        }
        for (std::size_t i = 0; i < meshes_.size(); ++i) // geometry ids count as Hit::instance does
            attach(device_.get(), scene_.get(), *meshes_[i], corners_[i]);
        rtcCommitScene(scene_.get());
    }

    double trace(std::span<const DeviceRay> rays, const EmbreeCall& call) override {
        hits_.resize(rays.size());
        return call.packets ? tracePackets(rays, call) : traceSingly(rays, call);
    }

    const std::vector<DeviceHit>& hits() const override { return hits_; }

  private:
    static RTCIntersectContext context(const EmbreeCall& call) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags =
            call.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        return context;
    }

    template <class Work>
    static double inParallel(std::size_t count, std::size_t minimum, const Work& work) {
        return measure([&] {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, minimum), [&](const auto& range) {
                for (std::size_t i = range.begin(); i != range.end(); ++i)
                    work(i);
            });
        });
    }

    static DeviceHit toHit(bool anyHit, float t, float u, float v, unsigned geometry, unsigned primitive) {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        if (anyHit) // Embree sets the far end of an occluded ray to minus infinity
            return {t < 0.0f ? 0.0f : infinity, 0.0f, 0.0f, PRIZMA_NO_HIT, PRIZMA_NO_HIT};
        if (geometry == RTC_INVALID_GEOMETRY_ID)
            return {infinity, 0.0f, 0.0f, PRIZMA_NO_HIT, PRIZMA_NO_HIT};
        return {t, u, v, geometry, primitive};
    }

    double traceSingly(std::span<const DeviceRay> rays, const EmbreeCall& call) {
        std::vector<RTCRayHit> work(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            work[i].ray = embreeRay(rays[i]);
            work[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
        }
        const double milliseconds = inParallel(work.size(), grain * packetSize, [&](std::size_t i) {
            RTCIntersectContext intersection = context(call);
            if (call.anyHit)
                rtcOccluded1(scene_.get(), &intersection, &work[i].ray);
            else
                rtcIntersect1(scene_.get(), &intersection, &work[i]);
        });
        for (std::size_t i = 0; i < rays.size(); ++i)
            hits_[i] = toHit(call.anyHit, work[i].ray.tfar, work[i].hit.u, work[i].hit.v, work[i].hit.geomID,
                             work[i].hit.primID);
        return milliseconds;
    }

    double tracePackets(std::span<const DeviceRay> rays, const EmbreeCall& call) {
        struct Packet {
            RTCRayHit16 content;
            alignas(64) std::array<int, packetSize> valid;
        };
        std::vector<Packet> packets((rays.size() + packetSize - 1) / packetSize);
        for (std::size_t i = 0; i < packets.size() * packetSize; ++i) {
            RTCRayHit16& packet = packets[i / packetSize].content;
            const std::size_t lane = i % packetSize;
            const RTCRay ray = embreeRay(rays[std::min(i, rays.size() - 1)]);
            packets[i / packetSize].valid[lane] = i < rays.size() ? -1 : 0;
            packet.ray.org_x[lane] = ray.org_x;
            packet.ray.org_y[lane] = ray.org_y;
            packet.ray.org_z[lane] = ray.org_z;
            packet.ray.tnear[lane] = ray.tnear;
            packet.ray.dir_x[lane] = ray.dir_x;
            packet.ray.dir_y[lane] = ray.dir_y;
            packet.ray.dir_z[lane] = ray.dir_z;
            packet.ray.tfar[lane] = ray.tfar;
            packet.ray.time[lane] = 0.0f;
            packet.ray.mask[lane] = ray.mask;
            packet.ray.flags[lane] = 0;
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        }
        const double milliseconds = inParallel(packets.size(), grain, [&](std::size_t i) {
            RTCIntersectContext intersection = context(call);
            if (call.anyHit)
                rtcOccluded16(packets[i].valid.data(), scene_.get(), &intersection, &packets[i].content.ray);
            else
                rtcIntersect16(packets[i].valid.data(), scene_.get(), &intersection, &packets[i].content);
        });
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const RTCRayHit16& packet = packets[i / packetSize].content;
            const std::size_t lane = i % packetSize;
            hits_[i] = toHit(call.anyHit, packet.ray.tfar[lane], packet.hit.u[lane], packet.hit.v[lane],
                             packet.hit.geomID[lane], packet.hit.primID[lane]);
        }
        return milliseconds;
    }

    std::vector<MeshPtr> meshes_;
    std::vector<EmbreeCorners> corners_;
    EmbreeOwned<RTCDevice> device_;
    EmbreeOwned<RTCScene> scene_;
    std::vector<DeviceHit> hits_;
};

} // namespace

std::unique_ptr<EmbreePeer> EmbreePeer::create(const Scene& scene, const glm::dvec3& origin, bool robust) {
    return std::make_unique<Peer>(scene, origin, robust);
}

std::optional<double> embreeBuildMilliseconds(const Mesh& mesh) {
    const EmbreeCorners corners = padded(mesh.positions);
    const EmbreeOwned<RTCDevice> device(rtcNewDevice(nullptr));
    const EmbreeOwned<RTCScene> scene(rtcNewScene(device.get()));
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
    attach(device.get(), scene.get(), mesh, corners);
    return measure([&] { rtcCommitScene(scene.get()); });
}

} // namespace prizma::bench

#else

namespace prizma::bench {

std::unique_ptr<EmbreePeer> EmbreePeer::create(const Scene&, const glm::dvec3&, bool) {
    return nullptr;
}

std::optional<double> embreeBuildMilliseconds(const Mesh&) {
    return std::nullopt;
}

} // namespace prizma::bench

#endif
