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

inline uint toPixel(float3 color, const global uint* encoding) {
    return toByte(color.x, encoding) | (toByte(color.y, encoding) << 8) | (toByte(color.z, encoding) << 16) |
           0xFF000000u;
}

// Rows from the top, RGBA bytes. `scale` is 2^exposure / samples.
// `encoding` holds the 256 linear values from which on each byte is used (as float bits), then the guesses.
kernel void toneMap(const global float4* sums, global uint* pixels, int width, int height, float scale,
                    const global uint* encoding) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    float4 sum = sums[indexOf((int)i % width, (int)i / width, width)];
    pixels[i] = toPixel(sum.xyz * scale, encoding);
}

// A film's curve for one channel, between the values of the table; floats' upper 16 bits count its bins.
inline float filmicCurve(float x, const global float* curve) {
    if (!(x > PRIZMA_FILMIC_SMALLEST))
        x = PRIZMA_FILMIC_SMALLEST;
    uint bits = as_uint(min(x, PRIZMA_FILMIC_LARGEST));
    uint bin = (bits >> 16) - (as_uint(PRIZMA_FILMIC_SMALLEST) >> 16);
    float low = curve[bin];
    float part = (float)(bits & 0xFFFFu) * 1.52587890625e-5f;
    return part > 0.0f ? low + (curve[bin + 1] - low) * part : low;
}

inline float3 timesRows(const global float* m, float3 v) {
    return (float3)(m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
                    m[6] * v.x + m[7] * v.y + m[8] * v.z);
}

// What is no number counts as black, before the inset could mix it into the other channels; what is infinite is as
// bright as can be.
inline float3 asLight(float3 v) {
    return (float3)(v.x > 0.0f ? min(v.x, 1e30f) : 0.0f, v.y > 0.0f ? min(v.y, 1e30f) : 0.0f,
                    v.z > 0.0f ? min(v.z, 1e30f) : 0.0f);
}

// ViewTransform::Filmic (core/render/view_transform.h says where it comes from); `table` holds the inset, its inverse
// and the curve.
inline float3 filmic(float3 radiance, const global float* table) {
    float3 mixed = timesRows(table, asLight(radiance));
    const global float* curve = table + 18;
    return timesRows(table + 9, (float3)(filmicCurve(mixed.x, curve), filmicCurve(mixed.y, curve),
                                         filmicCurve(mixed.z, curve)));
}

// The same as toneMap through a film's curve.
kernel void toneMapFilmic(const global float4* sums, global uint* pixels, int width, int height, float scale,
                          const global uint* encoding, const global float* table) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    float4 sum = sums[indexOf((int)i % width, (int)i / width, width)];
    pixels[i] = toPixel(filmic(sum.xyz * scale, table), encoding);
}

inline ushort toWord(float x) {
    x = clamp(x, 0.0f, 1.0f);
    float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
    return (ushort)(encoded * 65535.0f + 0.5f);
}

// 16 bits a channel, for files: time counts less than that the curve is the sRGB curve itself.
kernel void toneMapDeep(const global float4* sums, global ushort4* pixels, int width, int height, float scale,
                        uint isFilmic, const global float* table) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    float3 radiance = sums[indexOf((int)i % width, (int)i / width, width)].xyz * scale;
    float3 color = isFilmic ? filmic(radiance, table) : asLight(radiance);
    pixels[i] = (ushort4)(toWord(color.x), toWord(color.y), toWord(color.z), 65535);
}

// Rows from the top, linear radiance and coverage.
kernel void meanRadiance(const global float4* sums, global float4* pixels, int width, int height, float scale) {
    uint i = get_global_id(0);
    if (i >= (uint)(width * height))
        return;
    pixels[i] = sums[indexOf((int)i % width, (int)i / width, width)] * scale;
}
