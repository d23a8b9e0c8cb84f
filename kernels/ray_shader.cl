// RayShader: turns each pixel's camera ray and its first hit into radiance and adds it to the pixel's sum.
// PRIZMA_VIEW is 0 for Whitted, 1 for Path, else one of the views. With PRIZMA_PACKETS a work item does sixteen pixels,
// camera rays and all.
#include "pixel_order.clh"

#if PRIZMA_VIEW == 7
#define PRIZMA_COUNT_STEPS
#endif

#include "shader_api.clh"

#if PRIZMA_VIEW == 0
#include "shader_whitted.clh"
#elif PRIZMA_VIEW == 1
#include "shader_path.clh"
#else
#include "shader_views.clh"
#endif

#ifdef PRIZMA_RECORD_RAYS
#define RECORD_PARAMETERS , global DeviceRecordedRay *recorded, global uint *recordedCount, uint recordedCapacity
#define RECORD(scene)                                                                                                  \
    (scene)->recorded = recorded;                                                                                      \
    (scene)->recordedCount = recordedCount;                                                                            \
    (scene)->recordedCapacity = recordedCapacity
#else
#define RECORD_PARAMETERS
#define RECORD(scene)
#endif

#ifdef PRIZMA_PACKETS

#if PRIZMA_VIEW == 0
#include "packet_whitted.clh"
#else
#include "packet_path.clh"
#endif
#include "shade_packet.clh"

kernel void rayShaderPacket(SCENE_PARAMETERS, DeviceView view, DeviceShading shading, global float4* sums,
                            global float4* losses, global DeviceWork* work RECORD_PARAMETERS) {
    uint launched = (uint)get_global_id(0) * PACKET;
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    Scene scene = SCENE;
    RECORD(&scene);
    shadePacket(&scene, &view, &shading, index, sums, losses, work + index / PACKET);
}

#else

#include "accumulate.clh"

// Radiance and coverage of a pixel; counts what it took into `total`, which the work group shares.
inline void shadePixel(const Scene* scene, Frame* frame, Ray ray, DeviceHit hit, global float4* sum,
                       global float4* loss, local uint* total) {
    float3 radiance = shade(scene, frame, ray, hit);
    if (!allFinite(radiance)) { // would stay in the sum for ever
        radiance = (float3)(0.0f);
        atomic_inc(total + 2);
    }
    float alpha = hit.instance == PRIZMA_NO_HIT ? 0.0f : 1.0f;
    accumulate(sum, loss, (float4)(radiance, alpha), frame->sample == 0);
    if (frame->shadowRays != 0)
        atomic_add(total, frame->shadowRays);
    if (frame->secondaryRays != 0)
        atomic_add(total + 1, frame->secondaryRays);
}

// `work` gets the counts of each work group.
kernel void rayShader(SCENE_PARAMETERS, DeviceView view, DeviceShading shading, const global DeviceRay* rays,
                      const global DeviceHit* hits, global float4* sums, global float4* losses,
                      global DeviceWork* work RECORD_PARAMETERS) {
    local uint total[3];
    if (get_local_id(0) == 0)
        total[0] = total[1] = total[2] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    uint launched = get_global_id(0);
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    if (launched < view.pixelCount && pixel.x < view.width && pixel.y < view.height) {
        Scene scene = SCENE;
        RECORD(&scene);
#ifdef PRIZMA_COUNT_STEPS
        uint steps = 0;
        scene.steps = &steps;
#endif
        Frame frame = {shading, view.seed, view.sample, index, 0, 0};
        Ray ray = loadRay(rays + index);
        giveCameraCone(&ray, &view);
        recordRay(&scene, &ray, PRIZMA_RECORDED_PACKET);
        shadePixel(&scene, &frame, ray, hits[index], sums + index, losses + index, total);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        DeviceWork counts = {total[0], total[1], total[2], {0, 0, 0, 0, 0, 0, 0}};
        work[view.firstPixel / (uint)get_local_size(0) + get_group_id(0)] = counts;
    }
}

#endif
