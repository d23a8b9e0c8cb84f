// Writes bsdf_tables.clh, run by the build: how much of the light that a GGX surface meets leaves it again
// after one bounce off its facets (its directional albedo), in double precision. What is missing from 1 has
// bounced several times; bsdf.clh gives it back (Kulla and Conty 2017, "Revisiting Physically Based Shading
// at Imageworks").
//
//   specularAlbedo     reflection with the exact Fresnel equations, by cosine, roughness and index of
//   refraction glassAlbedoIn/Out  reflection and refraction together, met from outside and from inside
//   metalAlbedo        reflection of all light (reflectance 1), by cosine and roughness
//   ...Mean            the same times 2 cosine, integrated over the cosine: what of diffuse light leaves
//
// Nodes are even in the root of the cosine, in roughness and in the root of the reflectance at normal
// incidence. Means are those of the table as it is interpolated, not of the true function, so that energy is
// kept between the nodes as well.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr int cosines = 24;
constexpr int roughnesses = 17;
constexpr double leastRoughness = 0.08; // SMOOTH_ROUGHNESS of bsdf.clh
constexpr double roughnessPower = 4.0 / 3.0; // whose inverse, as that of the next, is made of square roots
constexpr int indices = 14;
constexpr double indexPower = 8.0 / 3.0;
constexpr double largestIor = 4.0;
constexpr int steps = 80; // of the integral, along each of its two axes

/// `eta`: the index beyond over the index on this side.
double fresnel(double cosine, double eta) {
    const double sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return 1;
    const double beyond = std::sqrt(1 - sine2);
    const double parallel = (eta * cosine - beyond) / (eta * cosine + beyond);
    const double perpendicular = (cosine - eta * beyond) / (cosine + eta * beyond);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
}

/// Smith's term of one direction.
double lambda(double cosine, double alpha) {
    const double tangent2 = 1 / (cosine * cosine) - 1;
    return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
}

/// Share of the facets' light that is not shadowed on its way out, given that the viewer sees them.
double unshadowed(double cosineO, double cosineI, double alpha) {
    const double o = lambda(cosineO, alpha);
    return (1 + o) / (1 + o + lambda(cosineI, alpha));
}

enum class Kind { Specular, Glass, Metal };

/// The albedo towards a direction whose cosine is `cosine`: a mean over the facets that are visible from
/// there, in their own density (Dupuy and Benyoub 2023).
double albedo(Kind kind, double cosine, double roughness, double eta) {
    cosine = std::max(cosine, 1e-5);
    const double alpha = roughness * roughness;
    if (alpha == 0)
        return kind == Kind::Specular ? fresnel(cosine, eta) : 1;
    const double sine = std::sqrt(1 - cosine * cosine);
    const double length = std::hypot(alpha * sine, cosine);
    const double x = alpha * sine / length;
    const double z = cosine / length;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double phi = std::numbers::pi * (i + 0.5) / steps; // the other half is its mirror image
            const double height = (1 - (j + 0.5) / steps) * (1 + z) - z;
            const double ring = std::sqrt(std::max(1 - height * height, 0.0));
            double hx = (ring * std::cos(phi) + x) * alpha;
            double hy = ring * std::sin(phi) * alpha;
            double hz = height + z;
            const double norm = std::sqrt(hx * hx + hy * hy + hz * hz);
            hx /= norm, hy /= norm, hz /= norm;
            const double met = sine * hx + cosine * hz;
            const double reflectance = kind == Kind::Metal ? 1 : fresnel(met, eta);
            if (const double reflected = 2 * met * hz - cosine; reflected > 0)
                sum += reflectance * unshadowed(cosine, reflected, alpha);
            if (kind == Kind::Glass && reflectance < 1) {
                const double beyond = std::sqrt(1 - (1 - met * met) / (eta * eta));
                const double refracted = (met / eta - beyond) * hz - cosine / eta;
                if (refracted < 0)
                    sum += (1 - reflectance) * unshadowed(cosine, -refracted, alpha);
            }
        }
    return sum / (steps * steps);
}

/// 2 times the integral of the interpolated table times the cosine over the cosine: with cosine = t², 4 t³
/// dt.
double meanOf(const std::vector<double>& nodes) {
    const int intervals = static_cast<int>(nodes.size()) - 1;
    double sum = 0;
    for (int i = 0; i < intervals; ++i)
        for (const double place : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) { // Gauss: exact for this
            const double weight = (place == 0 ? 8.0 : 5.0) / 18;
            const double part = (1 + place) / 2;
            const double t = (i + part) / intervals;
            const double value =
                std::lerp(nodes[static_cast<std::size_t>(i)], nodes[static_cast<std::size_t>(i) + 1], part);
            sum += weight * value * 4 * t * t * t / intervals;
        }
    return sum;
}

double roughnessAt(int node) {
    if (node == 0)
        return 0;
    return std::lerp(leastRoughness, 1.0, std::pow((node - 1.0) / (roughnesses - 2), roughnessPower));
}

/// 16 bits a value keep the tables small enough for any device's constant memory.
void print(const char* name, const std::vector<double>& values) {
    std::printf("constant ushort %s[%zu] = {", name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        std::printf("%s%d", i == 0 ? "" : (i % 16 == 0 ? ",\n" : ","),
                    static_cast<int>(std::lround(values[i] * 65535)));
    std::printf("};\n");
}

/// One table: a row of cosines for each roughness, these for each index.
void printTable(const char* name, Kind kind, const std::vector<double>& etas) {
    std::vector<double> values;
    std::vector<double> means;
    for (const double eta : etas)
        for (int r = 0; r < roughnesses; ++r) {
            std::vector<double> row;
            for (int c = 0; c < cosines; ++c) {
                const double t = static_cast<double>(c) / (cosines - 1);
                row.push_back(albedo(kind, t * t, roughnessAt(r), eta));
            }
            values.insert(values.end(), row.begin(), row.end());
            means.push_back(meanOf(row));
        }
    print(name, values);
    print((std::string(name) + "Mean").c_str(), means);
}

} // namespace

int main() {
    std::vector<double> in;
    std::vector<double> out;
    const double farthest = (largestIor - 1) / (largestIor + 1);
    for (int i = 0; i < indices; ++i) {
        const double root = farthest * std::pow(static_cast<double>(i) / (indices - 1), indexPower);
        in.push_back((1 + root) / (1 - root));
        out.push_back(1 / in.back());
    }
    std::printf(
        "// Made by kernels/tables/make_bsdf_tables.cpp; see there.\n#ifndef PRIZMA_BSDF_TABLES\n"
        "#define PRIZMA_BSDF_TABLES\n#define ALBEDO_COSINES %d\n#define ALBEDO_ROUGHNESSES %d\n"
        "#define ALBEDO_LEAST_ROUGHNESS %.9ff\n"
        "#define ALBEDO_INDICES %d\n#define ALBEDO_FARTHEST_INDEX %.9ff\n",
        cosines, roughnesses, leastRoughness, indices, farthest);
    printTable("specularAlbedo", Kind::Specular, in);
    printTable("glassAlbedoIn", Kind::Glass, in);
    printTable("glassAlbedoOut", Kind::Glass, out);
    printTable("metalAlbedo", Kind::Metal, {1.0});
    std::printf("#endif\n");
}
