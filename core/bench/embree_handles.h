#pragma once

// Only for files that are built with Embree.

#include "core/scene/mesh.h"

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace prizma::bench {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

template <class Handle>
using EmbreeOwned = std::unique_ptr<std::remove_pointer_t<Handle>, EmbreeRelease>;

using EmbreeCorners = std::vector<glm::vec3>;

/// Embree may read four bytes beyond the last corner.
inline EmbreeCorners padded(EmbreeCorners corners) {
    corners.emplace_back(0.0f);
    return corners;
}

/// Adds a mesh to a scene. `positions` end with one that is not used; they and the mesh have to live as long
/// as the geometry.
inline EmbreeOwned<RTCGeometry> attach(RTCDevice device, RTCScene scene, const Mesh& mesh,
                                       const EmbreeCorners& positions,
                                       RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM) {
    EmbreeOwned<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    rtcSetGeometryBuildQuality(geometry.get(), quality);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(),
                               0, sizeof(glm::vec3), positions.size() - 1);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(glm::uvec3), mesh.triangles.size());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene, geometry.get());
    return geometry;
}

} // namespace prizma::bench
