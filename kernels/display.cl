// From sums of radiance to what a screen shows, or to the plain mean for files.
#include "math.clh"
#include "pixel_order.clh"

inline float encodeSrgb(float x) {
    x = clamp(x, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}

inline uint toByte(float x) { return (uint)(encodeSrgb(x) * 255.0f + 0.5f); }

// Rows from the top, RGBA bytes. `scale` is 2^exposure / samples.
kernel void toneMap(const global float4* sums, global uint* pixels, int width, int height, float scale) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    float4 sum = sums[indexOf((int)i % width, (int)i / width, width)];
    pixels[i] = toByte(sum.x * scale) | (toByte(sum.y * scale) << 8) | (toByte(sum.z * scale) << 16) | 0xFF000000u;
}

// Rows from the top, linear radiance and coverage.
kernel void meanRadiance(const global float4* sums, global float4* pixels, int width, int height, float scale) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    pixels[i] = sums[indexOf((int)i % width, (int)i / width, width)] * scale;
}
