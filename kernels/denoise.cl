// The preview's denoiser: an edge-avoiding à-trous wavelet (Dammertz, Sewtz, Hanika and Lensch 2010) over light from
// which the surfaces' colour is divided out, stopped at edges of normal, depth, colour and, by as much as the samples
// scatter, of brightness (Schied et al. 2017). On processors a work item does eight pixels in a row.
#include "denoise_planes.clh"

#ifdef PRIZMA_WIDE8
#define LANES 8
typedef float8 Lanes;
#define LOAD(p) vload8(0, (p))
#define STORE(value, p) vstore8((value), 0, (p))
#else
#define LANES 1
typedef float Lanes;
#define LOAD(p) (*(p))
#define STORE(value, p) (*(p) = (value))
#endif

// For what stands in the innermost loops: a call would spill every vector register.
#define INLINE inline __attribute__((always_inline))

#define FEW_BATCHES 4 // from so many on, their scatter tells the variance; before, the neighbours' does

// From sums to light without colour and its variance. What the samples scatter is learned from batches of them, one a
// call: `history` holds what the sum's luminance was at the last call, and the sum of the batches' squares.
// `batch` is how many samples came since, `batches` how many calls there were with this one.
kernel void demodulate(const global float4* sums, const global float* guides, global float* history, global float* light,
                       global float* otherLight, int width, int height, int samples, int batch, int batches) {
    int place = (int)get_global_id(0);
    int places = placesOf(width, height);
    if (place >= places)
        return;
    int2 pixel = pixelOfPlace(place, width);
    float3 value = (float3)(0.0f);
    float variance = -1.0f;
    if (pixel.x >= 0 && pixel.x < width) {
        float3 albedo = (float3)(guides[GUIDE_ALBEDO * places + place], guides[(GUIDE_ALBEDO + 1) * places + place],
                                 guides[(GUIDE_ALBEDO + 2) * places + place]);
        float3 sum = sums[indexOf(pixel.x, pixel.y, width)].xyz / albedo;
        float total = luminance(sum);
        float before = batches > 1 ? history[place] : 0.0f;
        float squares = batches > 1 ? history[places + place] : 0.0f;
        if (batch > 0) {
            float mean = (total - before) / (float)batch;
            squares += (float)batch * mean * mean;
        }
        history[place] = total;
        history[places + place] = squares;
        if (allFinite(sum)) {
            float mean = total / (float)samples;
            value = sum / (float)samples;
            variance = 0.0f;
            if (batches >= FEW_BATCHES)
                variance = max((squares - (float)samples * mean * mean) / (float)((batches - 1) * samples), 0.0f);
        }
    }
    light[place] = value.x;
    light[places + place] = value.y;
    light[2 * places + place] = value.z;
    light[LIGHT_VARIANCE * places + place] = variance;
    if (pixel.x < 0 || pixel.x >= width) // the filter does not write the margins, but reads them
        for (int plane = 0; plane < 4; ++plane)
            otherLight[plane * places + place] = plane == LIGHT_VARIANCE ? -1.0f : 0.0f;
}

typedef struct {
    Lanes nx, ny, nz, px, py, pz, r, g, b, footprint;
} Guide;

INLINE Guide loadGuide(const global float* guides, int places, int place) {
    const global float* p = guides + place;
    Guide g;
    g.nx = LOAD(p + GUIDE_NORMAL * places);
    g.ny = LOAD(p + (GUIDE_NORMAL + 1) * places);
    g.nz = LOAD(p + (GUIDE_NORMAL + 2) * places);
    g.px = LOAD(p + GUIDE_POSITION * places);
    g.py = LOAD(p + (GUIDE_POSITION + 1) * places);
    g.pz = LOAD(p + (GUIDE_POSITION + 2) * places);
    g.footprint = LOAD(p + GUIDE_FOOTPRINT * places);
    g.r = LOAD(p + GUIDE_ALBEDO * places);
    g.g = LOAD(p + (GUIDE_ALBEDO + 1) * places);
    g.b = LOAD(p + (GUIDE_ALBEDO + 2) * places);
    return g;
}

INLINE Lanes luminanceOf(Lanes r, Lanes g, Lanes b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }

// Close to exp(-x) for x from 0, and 0 from 16 on.
INLINE Lanes falloff(Lanes x) {
    Lanes y = max(1.0f - x * 0.0625f, 0.0f);
    y *= y;
    y *= y;
    y *= y;
    return y * y;
}

// How little two pixels' surfaces differ, 1 to 0; `exponent` is what else sets them apart, as an exponent of e.
// `reach` is what their planes may be apart.
INLINE Lanes likeness(const Guide* p, const Guide* q, Lanes inverseReach, Lanes exponent) {
    Lanes cosine = clamp(p->nx * q->nx + p->ny * q->ny + p->nz * q->nz, 0.0f, 1.0f);
    for (int i = 0; i < 7; ++i)
        cosine *= cosine; // to the power of 128, as Schied et al. have it
    Lanes apart = fabs(p->nx * (q->px - p->px) + p->ny * (q->py - p->py) + p->nz * (q->pz - p->pz));
    Lanes dr = p->r - q->r, dg = p->g - q->g, db = p->b - q->b;
    Lanes colour = (dr * dr + dg * dg + db * db) * 10.0f;
    Lanes weight = cosine * falloff(min(exponent + apart * inverseReach + colour, 16.0f));
    return q->footprint > 0.0f ? weight : (Lanes)(0.0f);
}

// Where a work item's pixels begin; false: nowhere.
INLINE bool firstPlace(int width, int height, int* y, int* place) {
    int groups = (width + LANES - 1) / LANES;
    int group = (int)get_global_id(0);
    *y = group / groups;
    *place = placeOf(group % groups * LANES, *y, width);
    return *y < height;
}

// Guesses the variance from the neighbours on the same surface while there are few samples.
kernel void spatialVariance(const global float* guides, const global float* light, global float* out, int width,
                            int height) {
    int y, place;
    if (!firstPlace(width, height, &y, &place))
        return;
    int places = placesOf(width, height);
    int stride = strideOf(width);
    Guide p = loadGuide(guides, places, place);
    Lanes inverseReach = 1.0f / max(p.footprint, 1e-30f);
    Lanes sum = 0.0f, squares = 0.0f, weights = 0.0f;
    for (int dy = -3; dy <= 3; ++dy) {
        if (y + dy < 0 || y + dy >= height)
            continue;
        for (int dx = -3; dx <= 3; ++dx) {
            int at = place + dy * stride + dx;
            Guide q = loadGuide(guides, places, at);
            Lanes weight = likeness(&p, &q, inverseReach * 0.25f, 0.0f);
            weight = LOAD(light + LIGHT_VARIANCE * places + at) >= 0.0f ? weight : (Lanes)(0.0f);
            Lanes value = luminanceOf(LOAD(light + at), LOAD(light + places + at), LOAD(light + 2 * places + at));
            sum += weight * value;
            squares += weight * value * value;
            weights += weight;
        }
    }
    Lanes inverse = 1.0f / max(weights, 1e-10f);
    Lanes mean = sum * inverse;
    Lanes variance = max(squares * inverse - mean * mean, 0.0f);
    Lanes present = LOAD(light + LIGHT_VARIANCE * places + place);
    STORE(LOAD(light + place), out + place);
    STORE(LOAD(light + places + place), out + places + place);
    STORE(LOAD(light + 2 * places + place), out + 2 * places + place);
    STORE(present < 0.0f ? present : variance, out + LIGHT_VARIANCE * places + place);
}

// The variance about a pixel: a single one's is too noisy to say where an edge is.
INLINE Lanes smoothVariance(const global float* variances, int y, int place, int stride, int height) {
    Lanes sum = 0.0f, weights = 0.0f;
    for (int dy = -1; dy <= 1; ++dy) {
        if (y + dy < 0 || y + dy >= height)
            continue;
        for (int dx = -1; dx <= 1; ++dx) {
            Lanes value = LOAD(variances + place + dy * stride + dx);
            Lanes weight = value >= 0.0f ? (Lanes)((dx == 0 ? 2.0f : 1.0f) * (dy == 0 ? 2.0f : 1.0f)) : (Lanes)(0.0f);
            sum += weight * value;
            weights += weight;
        }
    }
    return sum / max(weights, 1e-10f);
}

// One step of the wavelet: 5 x 5 pixels, `step` apart, weighted by a cubic B-spline and by likeness.
kernel void waveletStep(const global float* guides, const global float* light, global float* out, int width, int height,
                        int step) {
    int y, place;
    if (!firstPlace(width, height, &y, &place))
        return;
    int places = placesOf(width, height);
    int stride = strideOf(width);
    const global float* variances = light + LIGHT_VARIANCE * places;
    Guide p = loadGuide(guides, places, place);
    Lanes present = LOAD(variances + place);
    Lanes red = LOAD(light + place), green = LOAD(light + places + place), blue = LOAD(light + 2 * places + place);
    Lanes brightness = luminanceOf(red, green, blue);
    Lanes scatter = sqrt(smoothVariance(variances, y, place, stride, height));
    Lanes sharpness = 1.0f / (4.0f * scatter + 1e-3f * fabs(brightness) + 1e-10f);
    Lanes inverseReach = 1.0f / (max(p.footprint, 1e-30f) * (float)step);
    const float spline[3] = {0.375f, 0.25f, 0.0625f};
    Lanes r = 0.0f, g = 0.0f, b = 0.0f, v = 0.0f, weights = 0.0f;
    for (int dy = -2; dy <= 2; ++dy) {
        if (y + dy * step < 0 || y + dy * step >= height)
            continue;
        for (int dx = -2; dx <= 2; ++dx) {
            int at = place + (dy * stride + dx) * step;
            Guide q = loadGuide(guides, places, at);
            Lanes qr = LOAD(light + at), qg = LOAD(light + places + at), qb = LOAD(light + 2 * places + at);
            Lanes qv = LOAD(variances + at);
            Lanes differs = min(fabs(luminanceOf(qr, qg, qb) - brightness) * sharpness, 16.0f);
            Lanes weight = likeness(&p, &q, inverseReach, differs) * (spline[abs(dx)] * spline[abs(dy)]);
            weight = qv >= 0.0f ? weight : (Lanes)(0.0f);
            r += weight * qr;
            g += weight * qg;
            b += weight * qb;
            v += weight * weight * qv;
            weights += weight;
        }
    }
    // Pixels without a surface, or without a number, stay as they are.
    Lanes keep = p.footprint > 0.0f ? present : (Lanes)(-1.0f);
    Lanes inverse = 1.0f / max(weights, 1e-10f);
    STORE(keep < 0.0f ? red : r * inverse, out + place);
    STORE(keep < 0.0f ? green : g * inverse, out + places + place);
    STORE(keep < 0.0f ? blue : b * inverse, out + 2 * places + place);
    STORE(keep < 0.0f ? present : v * inverse * inverse, out + LIGHT_VARIANCE * places + place);
}

// Back to a picture like the sums, of one sample: where nothing was filtered, the sums' own mean.
kernel void modulate(const global float4* sums, const global float* guides, const global float* light,
                     global float4* pixels, int width, int height, int samples) {
    int place = (int)get_global_id(0);
    int places = placesOf(width, height);
    int2 pixel = pixelOfPlace(place, width);
    if (place >= places || pixel.x < 0 || pixel.x >= width)
        return;
    uint index = indexOf(pixel.x, pixel.y, width);
    float4 mean = sums[index] / (float)samples;
    if (guides[GUIDE_FOOTPRINT * places + place] > 0.0f && light[LIGHT_VARIANCE * places + place] >= 0.0f) {
        mean.x = light[place] * guides[GUIDE_ALBEDO * places + place];
        mean.y = light[places + place] * guides[(GUIDE_ALBEDO + 1) * places + place];
        mean.z = light[2 * places + place] * guides[(GUIDE_ALBEDO + 2) * places + place];
    }
    pixels[index] = mean;
}
