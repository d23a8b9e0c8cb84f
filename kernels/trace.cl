// The tracing kernels by themselves: rays in, hits out, from `first` on. Camera rays go through them too.
#include "traverse.clh"

#ifdef PRIZMA_WIDE8
#include "traverse_packet.clh"
#endif

kernel void traceClosest(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                         uint rayCount) {
    uint launched = get_global_id(0);
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    Scene scene = SCENE;
    hits[index] = trace(&scene, loadRay(rays + index));
}

kernel void traceAny(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                         uint rayCount) {
    uint launched = get_global_id(0);
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    Scene scene = SCENE;
    hits[index].t = occluded(&scene, loadRay(rays + index)) ? 0.0f : INFINITY;
}

// The same for rays that lie close together: sixteen in a row share a work item on CPU devices.
kernel void tracePacket(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                        uint rayCount) {
    Scene scene = SCENE;
#ifdef PRIZMA_WIDE8
    uint launched = (uint)get_global_id(0) * PACKET;
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    tracePacketClosest(&scene, rays + index, hits + index, min(rayCount - launched, (uint)PACKET));
#else
    uint launched = get_global_id(0);
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    hits[index] = trace(&scene, loadRay(rays + index));
#endif
}

kernel void traceAnyPacket(SCENE_PARAMETERS, const global DeviceRay* rays, global DeviceHit* hits, uint first,
                           uint rayCount) {
    Scene scene = SCENE;
#ifdef PRIZMA_WIDE8
    uint launched = (uint)get_global_id(0) * PACKET;
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    tracePacketAny(&scene, rays + index, hits + index, min(rayCount - launched, (uint)PACKET));
#else
    uint launched = get_global_id(0);
    if (launched >= rayCount)
        return;
    uint index = first + launched;
    hits[index].t = occluded(&scene, loadRay(rays + index)) ? 0.0f : INFINITY;
#endif
}
