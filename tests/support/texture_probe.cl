// Texture filtering by itself: places in, texels out.
#include "texture.clh"

typedef struct {
    float u, v;
    float footprint;
    uint texture;
    int reading; // TEXELS_..., or -1: sampleTexture as a colour
} Question;

kernel void filterTextures(const global DeviceTexture* textures, const global uint* texels,
                           const global Question* questions, global float4* answers, uint count) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    Scene scene;
    scene.textures = textures;
    scene.texels = texels;
    Question q = questions[i];
    float2 uv = (float2)(q.u, q.v);
    answers[i] = q.reading < 0 ? sampleTexture(&scene, q.texture, uv, false)
                               : filterTexture(&scene, q.texture, uv, q.footprint, q.reading);
}
