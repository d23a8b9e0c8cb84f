// RayShader: turns each pixel's camera ray and its first hit into radiance and adds it to the pixel's sum.
// PRIZMA_VIEW is 0 for Whitted, 1 for Path, else one of the views.
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

// Adds without losing what a large sum would round away (Kahan 1965): 100,000 samples stay exact to a few ulp.
inline void accumulate(global float4* sum, global float4* lost, float4 value, bool first) {
    float4 oldSum = first ? (float4)(0.0f) : *sum;
    float4 corrected = value - (first ? (float4)(0.0f) : *lost);
    float4 newSum = oldSum + corrected;
    *lost = (newSum - oldSum) - corrected;
    *sum = newSum;
}

// `rayCounts` gets each pixel's shadow rays in the lower half and its secondary rays in the upper.
kernel void rayShader(SCENE_PARAMETERS, DeviceView view, DeviceShading shading, const global DeviceRay* rays,
                      const global DeviceHit* hits, global float4* sums, global float4* losses, global uint* rayCounts) {
    uint launched = get_global_id(0);
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    if (pixel.x >= view.width || pixel.y >= view.height) {
        rayCounts[index] = 0;
        return;
    }
    Scene scene = SCENE;
#ifdef PRIZMA_COUNT_STEPS
    uint steps = 0;
    scene.steps = &steps;
#endif
    Frame frame = {shading, view.seed, view.sample, index, 0, 0};
    Ray ray = loadRay(rays + index);
    giveCameraCone(&ray, &view);
    DeviceHit hit = hits[index];
    float3 radiance = shade(&scene, &frame, ray, hit);
    float alpha = hit.instance == PRIZMA_NO_HIT ? 0.0f : 1.0f;
    accumulate(sums + index, losses + index, (float4)(radiance, alpha), view.sample == 0);
    rayCounts[index] = min(frame.shadowRays, 65535u) | (min(frame.secondaryRays, 65535u) << 16);
}
