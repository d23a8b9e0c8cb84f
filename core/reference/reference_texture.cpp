#include "core/reference/reference_texture.h"

#include "core/scene/srgb.h"

#include <cmath>

namespace prizma::reference {
namespace {

/// Row 0 is the top one; any column and row, repeated.
glm::dvec4 texel(const Image& image, long column, long row, Reading reading) {
    const auto inside = [](long i, long size) { return ((i % size) + size) % size; };
    const auto first =
        static_cast<std::size_t>(4 * (inside(row, image.height) * image.width + inside(column, image.width)));
    glm::dvec4 value(0.0);
    for (int c = 0; c < 4; ++c) {
        const auto i = first + static_cast<std::size_t>(c);
        if (image.bytes.empty()) {
            value[c] = static_cast<double>(image.floats[i]);
            continue;
        }
        value[c] = image.bytes[i] / 255.0;
        if (reading != Reading::Data && c < 3)
            value[c] = decodeSrgb(value[c]);
    }
    return value;
}

} // namespace

glm::dvec4 sampleImage(const Image& image, const glm::dvec2& texCoord, Reading reading) {
    const double across = texCoord.x * image.width - 0.5;
    const double down = (1.0 - texCoord.y) * image.height - 0.5;
    const auto column = static_cast<long>(std::floor(across));
    const auto row = static_cast<long>(std::floor(down));
    glm::dvec4 sum(0.0);
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1;
        const int below = corner >> 1;
        const double shareAcross = 1.0 - std::abs(across - static_cast<double>(column + right));
        const double shareDown = 1.0 - std::abs(down - static_cast<double>(row + below));
        glm::dvec4 value = texel(image, column + right, row + below, reading);
        if (reading == Reading::CoveredColor)
            value = glm::dvec4(glm::dvec3(value) * value.w, value.w);
        sum += value * (shareAcross * shareDown);
    }
    if (reading == Reading::CoveredColor && sum.w > 0.0)
        sum = glm::dvec4(glm::dvec3(sum) / sum.w, sum.w);
    return sum;
}

} // namespace prizma::reference
