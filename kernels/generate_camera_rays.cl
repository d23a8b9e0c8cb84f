// GenerateCameraRays: one ray a pixel from an exact pinhole, through a place inside the pixel.
#include "math.clh"
#include "pixel_order.clh"

kernel void generateCameraRays(DeviceView view, global DeviceRay* rays) {
    uint launched = get_global_id(0);
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    float x = ((float)pixel.x + view.jitter[0]) / (float)view.width * 2.0f - 1.0f;
    float y = 1.0f - ((float)pixel.y + view.jitter[1]) / (float)view.height * 2.0f;
    global DeviceRay* ray = rays + index;
    float3 forward = (float3)(view.forward[0], view.forward[1], view.forward[2]);
    float3 right = (float3)(view.right[0], view.right[1], view.right[2]);
    float3 up = (float3)(view.up[0], view.up[1], view.up[2]);
    float3 direction = normalize(forward + right * x + up * y);
    bool inside = pixel.x < view.width && pixel.y < view.height;
    ray->origin[0] = view.origin[0];
    ray->origin[1] = view.origin[1];
    ray->origin[2] = view.origin[2];
    ray->tMin = 0.0f;
    ray->direction[0] = direction.x;
    ray->direction[1] = direction.y;
    ray->direction[2] = direction.z;
    ray->tMax = inside ? INFINITY : -1.0f; // pixels that only fill up a tile trace nothing
}
