#pragma once

#include "core/scene/image.h"

#include <cstdint>
#include <vector>

namespace prizma {

/// An equirectangular picture as a piecewise constant density over the sphere, laid out as
/// kernels/environment.clh reads it.
struct EnvironmentTable {
    static constexpr std::uint32_t mostColumns = 1024;
    static constexpr std::uint32_t mostRows = 512;

    std::uint32_t width = 0, height = 0; ///< Cells; 0 for a picture without light.
    std::vector<float> cumulative;       ///< height + 1 numbers of the rows, then width + 1 for each row.
    double mean = 0.0;                   ///< Of all channels over the sphere.
};

/// The cells' weights are means of the bilinearly filtered picture, so that a cell has none exactly if all of
/// it is black. Values below 0 and what is no number count as 0.
EnvironmentTable makeEnvironmentTable(const Image& image);

} // namespace prizma
