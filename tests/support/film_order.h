#pragma once

#include <cstddef>

namespace prizma::test {

/// Place of a pixel in the film: tiles of 8 x 8, Morton order inside (kernels/pixel_order.clh).
inline std::size_t placeInFilm(int x, int y, int width) {
    const int tile = (y / 8) * ((width + 7) / 8) + x / 8;
    int inside = 0;
    for (int bit = 0; bit < 3; ++bit)
        inside |= ((x >> bit) & 1) << (2 * bit) | ((y >> bit) & 1) << (2 * bit + 1);
    return static_cast<std::size_t>(tile) * 64 + static_cast<std::size_t>(inside);
}

} // namespace prizma::test
