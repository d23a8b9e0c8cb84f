// GenerateCameraRays: one ray a pixel (camera.clh).
#include "camera.clh"

kernel void generateCameraRays(DeviceView view, global DeviceRay* rays) {
    uint launched = get_global_id(0);
    if (launched >= view.pixelCount)
        return;
    uint index = view.firstPixel + launched;
    int2 pixel = pixelAt(index, view.width);
    global DeviceRay* ray = rays + index;
    float3 direction = cameraDirection(&view, pixel);
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
