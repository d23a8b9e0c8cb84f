// From sums of radiance to what a screen shows, or to the plain mean for files.
#include "math.clh"
#include "pixel_order.clh"

// Where a linear value becomes the next sRGB byte. The upper 16 bits of the float pick a first guess, which is right or
// one too low (a bin is narrower than a byte's step); the exact limit decides. Equal to rounding the sRGB curve, without
// its pow, which took as long as tracing the picture.
inline uint toByte(float x, const global uint* encoding) {
    if (!(x > PRIZMA_SRGB_SMALLEST))
        x = PRIZMA_SRGB_SMALLEST;
    x = min(x, 1.0f);
    uint guess = encoding[256 + (as_uint(x) >> 16) - (as_uint(PRIZMA_SRGB_SMALLEST) >> 16)];
    return guess + (guess < 255 && x >= as_float(encoding[guess + 1]) ? 1 : 0);
}

// Rows from the top, RGBA bytes. `scale` is 2^exposure / samples.
// `encoding` holds the 256 linear values from which on each byte is used (as float bits), then the guesses.
kernel void toneMap(const global float4* sums, global uint* pixels, int width, int height, float scale,
                    const global uint* encoding) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    float4 sum = sums[indexOf((int)i % width, (int)i / width, width)];
    pixels[i] = toByte(sum.x * scale, encoding) | (toByte(sum.y * scale, encoding) << 8) |
                (toByte(sum.z * scale, encoding) << 16) | 0xFF000000u;
}

// Rows from the top, linear radiance and coverage.
kernel void meanRadiance(const global float4* sums, global float4* pixels, int width, int height, float scale) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    pixels[i] = sums[indexOf((int)i % width, (int)i / width, width)] * scale;
}
