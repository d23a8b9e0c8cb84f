// The tracing kernels by themselves: rays in, hits out, from `first` on. Camera rays go through them too.
#include "traverse.clh"

#ifdef PRIZMA_WIDE8
#include "traverse_packet.clh"
#endif

// How many rays this work item traces, at most `perItem`; `index` gets the first one.
inline uint raysOfItem(uint first, uint rayCount, uint perItem, uint* index) {
    uint launched = (uint)get_global_id(0) * perItem;
    *index = first + launched;
    return launched < rayCount ? min(rayCount - launched, perItem) : 0;
}

inline void traceOne(const Scene* scene, const global DeviceRay* ray, global DeviceHit* hit) {
    *hit = trace(scene, loadRay(ray));
}

// t is 0 for a ray that meets something and infinite for others; the rest of the hit stays as it is.
inline void occludeOne(const Scene* scene, const global DeviceRay* ray, global DeviceHit* hit) {
    hit->t = occluded(scene, loadRay(ray)) ? 0.0f : INFINITY;
}

kernel void traceClosest(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                         uint rayCount) {
    Scene scene = SCENE;
    uint index;
    if (raysOfItem(first, rayCount, 1, &index) != 0)
        traceOne(&scene, rays + index, hits + index);
}

kernel void traceAny(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                     uint rayCount) {
    Scene scene = SCENE;
    uint index;
    if (raysOfItem(first, rayCount, 1, &index) != 0)
        occludeOne(&scene, rays + index, hits + index);
}

// The same for rays that lie close together: sixteen in a row share a work item on CPU devices.
kernel void tracePacket(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                        uint rayCount) {
    Scene scene = SCENE;
    uint index;
#ifdef PRIZMA_WIDE8
    uint count = raysOfItem(first, rayCount, PACKET, &index);
    if (count != 0)
        tracePacketClosest(&scene, rays + index, hits + index, count);
#else
    if (raysOfItem(first, rayCount, 1, &index) != 0)
        traceOne(&scene, rays + index, hits + index);
#endif
}

kernel void traceAnyPacket(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                           uint rayCount) {
    Scene scene = SCENE;
    uint index;
#ifdef PRIZMA_WIDE8
    uint count = raysOfItem(first, rayCount, PACKET, &index);
    if (count != 0)
        tracePacketAny(&scene, rays + index, hits + index, count);
#else
    if (raysOfItem(first, rayCount, 1, &index) != 0)
        occludeOne(&scene, rays + index, hits + index);
#endif
}
