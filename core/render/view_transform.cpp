#include "core/render/view_transform.h"

#include "core/scene/srgb.h"
#include "kernels/device_types.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace prizma {
namespace {

constexpr double middleGrey = 0.18;
constexpr double stopsBelow = 10.0, stopsAbove = 6.5;
constexpr double pivot = stopsBelow / (stopsBelow + stopsAbove); // middle grey's place in the range
constexpr double slope = 2.4;                                    // there
constexpr double bend = 1.5;                                     // how tightly toe and shoulder turn
constexpr double displayPower = 2.4; // what the sigmoid gives is encoded with this

/// Wrensch's matrix, with rows that add up to 1 to the last digit: greys stay grey and white is white.
glm::dmat3 makeInset() {
    constexpr double rows[3][3] = {{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                                   {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                                   {0.0423756549057051, 0.0784336000000000, 0.879142973793104}};
    glm::dmat3 matrix;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix[column][row] = rows[row][column] / (rows[row][0] + rows[row][1] + rows[row][2]);
    return matrix;
}

/// How far the sigmoid reaches on one side of the pivot, so that it ends in the corner of its square.
double reach(double across, double upward) {
    return std::pow(std::pow(slope * across, -bend) * (std::pow(slope * across / upward, bend) - 1.0),
                    -1.0 / bend);
}

double turned(double x) {
    return x / std::pow(1.0 + std::pow(x, bend), 1.0 / bend);
}

/// Radiance of one channel after the inset to linear light.
double sigmoid(double radiance) {
    const double stops = radiance > 0.0 ? std::log2(radiance / middleGrey) : -stopsBelow;
    if (stops <= -stopsBelow)
        return 0.0;
    const double place = (std::min(stops, stopsAbove) + stopsBelow) / (stopsBelow + stopsAbove);
    const double height = std::pow(middleGrey, 1.0 / displayPower);
    double encoded = height;
    if (place < pivot) {
        const double scale = reach(pivot, height);
        encoded -= scale * turned(slope * (pivot - place) / scale);
    } else {
        const double scale = reach(1.0 - pivot, 1.0 - height);
        encoded += scale * turned(slope * (place - pivot) / scale);
    }
    return std::pow(std::clamp(encoded, 0.0, 1.0), displayPower);
}

std::uint32_t binOf(float value) {
    return std::bit_cast<std::uint32_t>(value) >> 16;
}

} // namespace

glm::dvec3 displayColor(const glm::dvec3& radiance, ViewTransform transform) {
    glm::dvec3 light;
    for (int i = 0; i < 3; ++i)
        light[i] = radiance[i] > 0.0 ? std::min(radiance[i], 1e30) : 0.0;
    if (transform == ViewTransform::Filmic) {
        const glm::dmat3 inset = makeInset();
        light = inset * light;
        light = glm::inverse(inset) * glm::dvec3(sigmoid(light.x), sigmoid(light.y), sigmoid(light.z));
    }
    return glm::clamp(light, 0.0, 1.0);
}

std::vector<std::uint32_t> srgbEncoding() {
    std::vector<float> limits(256, 0.0f);
    for (std::size_t byte = 1; byte < limits.size(); ++byte)
        limits[byte] = static_cast<float>(decodeSrgb((static_cast<double>(byte) - 0.5) / 255.0));
    std::vector<std::uint32_t> table;
    for (const float limit : limits)
        table.push_back(std::bit_cast<std::uint32_t>(limit));
    std::uint32_t byte = 0;
    for (std::uint32_t bin = binOf(PRIZMA_SRGB_SMALLEST); bin <= binOf(1.0f); ++bin) {
        while (byte < 255 && std::bit_cast<float>(bin << 16) >= limits[byte + 1])
            ++byte;
        table.push_back(byte);
    }
    return table;
}

std::vector<float> filmicTable() {
    std::vector<float> table;
    const glm::dmat3 inset = makeInset();
    for (const glm::dmat3& matrix : {inset, glm::inverse(inset)})
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                table.push_back(static_cast<float>(matrix[column][row]));
    for (std::uint32_t bin = binOf(PRIZMA_FILMIC_SMALLEST); bin <= binOf(PRIZMA_FILMIC_LARGEST); ++bin)
        table.push_back(static_cast<float>(sigmoid(std::bit_cast<float>(bin << 16))));
    return table;
}

} // namespace prizma
