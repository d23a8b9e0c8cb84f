// Kernels that ask BSDFs by themselves.
#include "bsdf.clh"
#include "sampler.clh"

// A surface and a viewer.
typedef struct {
    float baseColor[3];
    float specular, metallic, roughness, transmission, ior;
    float specularColor[3];
    uint entering;
    float normal[3];
    float geometricNormal[3];
    float toEye[3];
} Question;

typedef struct {
    float direction[3];
    float pdf;
    float weight[3];
    uint isDelta;
    float value[3]; // evaluateBsdf and bsdfPdf in that direction
    float valuePdf;
    uint transmitted;
} Sample;

inline void put(global float* target, float3 value) {
    target[0] = value.x;
    target[1] = value.y;
    target[2] = value.z;
}

inline Surface surfaceOf(const global Question* q) {
    Surface s;
    s.position = (float3)(0.0f);
    s.positionError = 0.0f;
    s.texCoord = (float2)(0.0f);
    s.baseColor = loadFloat3(q->baseColor);
    s.alpha = 1.0f;
    s.emission = (float3)(0.0f);
    s.absorption = (float3)(0.0f);
    s.material = 0;
    s.specular = q->specular;
    s.metallic = q->metallic;
    s.roughness = q->roughness;
    s.transmission = q->transmission;
    s.ior = q->ior;
    s.specularColor = loadFloat3(q->specularColor);
    s.entering = q->entering != 0;
    s.normal = loadFloat3(q->normal);
    s.geometricNormal = loadFloat3(q->geometricNormal);
    return s;
}

inline float3 uniformCube(uint i, uint seed) {
    uint a = hashed(i * 3u + hashed(seed));
    uint b = hashed(a ^ 0x68E31DA4u);
    uint c = hashed(b ^ 0xB5297A4Du);
    return (float3)((float)(a >> 8), (float)(b >> 8), (float)(c >> 8)) * 0x1p-24f;
}

// `each` samples of each question.
kernel void sampleAll(const global Question* questions, uint each, uint seed, uint count, global Sample* samples) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    const global Question* q = questions + i / each;
    Surface s = surfaceOf(q);
    float3 toEye = loadFloat3(q->toEye);
    BsdfSample sample = sampleBsdf(&s, toEye, uniformCube(i, seed));
    global Sample* out = samples + i;
    put(out->direction, sample.direction);
    put(out->weight, sample.weight);
    out->pdf = sample.pdf;
    out->isDelta = sample.isDelta;
    out->transmitted = sample.transmitted;
    put(out->value, evaluateBsdf(&s, toEye, sample.direction));
    out->valuePdf = bsdfPdf(&s, toEye, sample.direction);
}

// Value and density of one question for directions of each one's own (question i / each).
kernel void evaluateAll(const global Question* questions, const global float* directions, uint each, uint count,
                        global float4* values) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    const global Question* q = questions + i / each;
    Surface s = surfaceOf(q);
    float3 toEye = loadFloat3(q->toEye);
    float3 toLight = loadFloat3(directions + 3 * i);
    values[i] = (float4)(evaluateBsdf(&s, toEye, toLight), bsdfPdf(&s, toEye, toLight));
}

// Place k of the two-point Gauss rule in each of the parts of a unit.
inline float gaussNode(uint k, uint parts) {
    return ((float)(k / 2) + ((k & 1) != 0 ? 0.788675135f : 0.211324865f)) / (float)parts;
}

// Integral of the density over each of `rings` x `sectors` cells of the sphere about z (even in angle), by the Gauss
// rule in `high` x `wide` parts of each.
kernel void integrateCells(const global Question* question, uint rings, uint sectors, uint high, uint wide,
                           global float* integrals) {
    uint i = get_global_id(0);
    if (i >= rings * sectors)
        return;
    Surface s = surfaceOf(question);
    Bsdf bsdf = prepareBsdf(&s, loadFloat3(question->toEye));
    float ring = PI_F / (float)rings;
    float sector = 2.0f * PI_F / (float)sectors;
    float sum = 0.0f;
    for (uint a = 0; a < 2 * high; ++a) {
        float theta = ((float)(i / sectors) + gaussNode(a, high)) * ring;
        float rowSum = 0.0f;
        for (uint b = 0; b < 2 * wide; ++b) {
            float phi = ((float)(i % sectors) + gaussNode(b, wide)) * sector;
            float pdf;
            bsdfValue(&bsdf, (float3)(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)), &pdf);
            rowSum += pdf;
        }
        sum += rowSum * sin(theta);
    }
    integrals[i] = sum * ring * sector / (float)(4 * high * wide);
}

kernel void albedos(const global float4* places, uint count, global float4* out) { // cosine, roughness, index
    uint i = get_global_id(0);
    if (i >= count)
        return;
    AlbedoPlace place = albedoPlace(places[i].y, places[i].z);
    out[i] = (float4)(albedoAt(specularAlbedo, &place, places[i].x),
                      albedoAt(glassAlbedoIn, &place, places[i].x),
                      albedoAt(glassAlbedoOut, &place, places[i].x), metalAlbedoAt(&place, places[i].x));
}
