// GenerateCameraRays: one ray a pixel from a pinhole or a thin lens, through a place inside the pixel.
#include "math.clh"
#include "microfacet.clh"
#include "pixel_order.clh"
#include "sampler.clh"

// All pixels share the view's place inside them, unless it asks for a place of each one's own.
inline float2 placeInPixel(const DeviceView* view, const Sampler* sampler) {
    if (view->scattered)
        return sampleSquare(sampler, PIXEL_DIMENSION);
    return (float2)(view->jitter[0], view->jitter[1]);
}

kernel void generateCameraRays(DeviceView view, global DeviceRay* rays) {
    uint launched = get_global_id(0);
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    Sampler sampler = samplerOf(index, view.sample, view.seed);
    float2 place = placeInPixel(&view, &sampler);
    float x = ((float)pixel.x + place.x) / (float)view.width * 2.0f - 1.0f;
    float y = 1.0f - ((float)pixel.y + place.y) / (float)view.height * 2.0f;
    global DeviceRay* ray = rays + index;
    float3 forward = (float3)(view.forward[0], view.forward[1], view.forward[2]);
    float3 right = (float3)(view.right[0], view.right[1], view.right[2]);
    float3 up = (float3)(view.up[0], view.up[1], view.up[2]);
    float3 origin = (float3)(view.origin[0], view.origin[1], view.origin[2]);
    float3 direction = forward + right * x + up * y;
    if (view.lensRadius > 0.0f) { // all rays of a place in the picture meet in the plane of focus
        float2 lens = sampleDisk(sampleSquare(&sampler, LENS_DIMENSION)) * view.lensRadius;
        float3 aside = normalize(right) * lens.x + normalize(up) * lens.y;
        origin += aside;
        direction = direction * view.focusDistance - aside;
    }
    direction = normalize(direction);
    bool inside = pixel.x < view.width && pixel.y < view.height;
    ray->origin[0] = origin.x;
    ray->origin[1] = origin.y;
    ray->origin[2] = origin.z;
    ray->tMin = 0.0f;
    ray->direction[0] = direction.x;
    ray->direction[1] = direction.y;
    ray->direction[2] = direction.z;
    ray->tMax = inside ? INFINITY : -1.0f; // pixels that only fill up a tile trace nothing
}
