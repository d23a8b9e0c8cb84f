// GenerateCameraRays: one ray a pixel (camera.clh).
#include "camera.clh"

kernel void generateCameraRays(DeviceView view, global DeviceRay* rays) {
    uint launched = get_global_id(0);
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    global DeviceRay* ray = rays + index;
    float3 origin;
    float3 direction = cameraRay(&view, index, &origin);
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
