// What the denoiser knows about the surfaces of a picture: each pixel's first hit, in the middle of the pixel. Mirrors
// and glass are guided by their own surface; what shows in them is kept apart by its brightness only.
#include "surface.clh"
#include "denoise_planes.clh"

// For every place of the planes (denoise_planes.clh). `rays` and `hits` are in the order of pixel_order.clh.
kernel void denoiseGuides(SCENE_PARAMETERS, DeviceView view, const global DeviceRay* rays,
                          const global DeviceHit* hits, global float* guides) {
    int place = (int)get_global_id(0);
    int places = placesOf(view.width, view.height);
    if (place >= places)
        return;
    int2 pixel = pixelOfPlace(place, view.width);
    float3 normal = (float3)(0.0f);
    float3 position = (float3)(0.0f);
    float3 albedo = (float3)(1.0f);
    float footprint = 0.0f;
    if (pixel.x >= 0 && pixel.x < view.width) {
        Scene scene = SCENE;
        uint index = indexOf(pixel.x, pixel.y, view.width);
        DeviceHit hit = hits[index];
        if (hit.instance != PRIZMA_NO_HIT) {
            Ray ray = loadRay(rays + index);
            Surface s = surfaceAt(&scene, &ray, &hit);
            normal = s.normal;
            position = ray.direction * hit.t;
            // Emission counts as colour: a glowing picture is as sharp as a painted one.
            albedo = max(s.baseColor + 0.04f * s.specular + s.emission, 0.01f);
            footprint = hit.t * length((float3)(view.up[0], view.up[1], view.up[2])) * 2.0f / (float)view.height;
        }
        if (!allFinite(normal) || !allFinite(position) || !allFinite(albedo) || !(footprint > 0.0f)) {
            normal = position = (float3)(0.0f);
            albedo = (float3)(1.0f);
            footprint = 0.0f;
        }
    }
    global float* g = guides + place;
    g[GUIDE_NORMAL * places] = normal.x;
    g[(GUIDE_NORMAL + 1) * places] = normal.y;
    g[(GUIDE_NORMAL + 2) * places] = normal.z;
    g[GUIDE_POSITION * places] = position.x;
    g[(GUIDE_POSITION + 1) * places] = position.y;
    g[(GUIDE_POSITION + 2) * places] = position.z;
    g[GUIDE_FOOTPRINT * places] = footprint;
    g[GUIDE_ALBEDO * places] = albedo.x;
    g[(GUIDE_ALBEDO + 1) * places] = albedo.y;
    g[(GUIDE_ALBEDO + 2) * places] = albedo.z;
}
