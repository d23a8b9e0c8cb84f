#include "core/render/environment_table.h"

#include "core/scene/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prizma {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Numbers on a grid, rows from the top.
struct Grid {
    std::size_t width = 0, height = 0;
    std::vector<double> values;

    double& at(std::size_t x, std::size_t y) { return values[y * width + x]; }
    double at(std::size_t x, std::size_t y) const { return values[y * width + x]; }
};

/// Means of the channels.
Grid brightnessOf(const Image& image) {
    Grid grid{static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), {}};
    std::array<double, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = decodeSrgb(static_cast<double>(i) / 255.0);
    grid.values.resize(grid.width * grid.height);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += image.bytes.empty() ? static_cast<double>(image.floats[4 * i + c])
                                       : linear[image.bytes[4 * i + c]];
        grid.values[i] = std::isfinite(sum) ? std::max(sum / 3.0, 0.0) : 0.0;
    }
    return grid;
}

/// Means of the bilinear interpolation over each texel: around, the picture repeats; at the poles it ends.
Grid filtered(const Grid& in) {
    Grid across = in;
    for (std::size_t y = 0; y < in.height; ++y)
        for (std::size_t x = 0; x < in.width; ++x)
            across.at(x, y) = 0.75 * in.at(x, y) + 0.125 * (in.at((x + 1) % in.width, y) +
                                                            in.at((x + in.width - 1) % in.width, y));
    Grid out = across;
    for (std::size_t y = 0; y < in.height; ++y)
        for (std::size_t x = 0; x < in.width; ++x)
            out.at(x, y) = 0.75 * across.at(x, y) + 0.125 * (across.at(x, std::min(y + 1, in.height - 1)) +
                                                             across.at(x, y == 0 ? 0 : y - 1));
    return out;
}

/// The `index`-th of `parts` equal parts of [0, size): calls `use` with each whole number it touches and how
/// much of it.
template <class Use>
void forEachIn(std::size_t index, std::size_t parts, std::size_t size, const Use& use) {
    const double scale = static_cast<double>(size) / static_cast<double>(parts);
    const double first = static_cast<double>(index) * scale;
    const double end = first + scale;
    for (auto i = static_cast<std::size_t>(first); i < size && static_cast<double>(i) < end; ++i)
        use(i, std::min(end, static_cast<double>(i + 1)) - std::max(first, static_cast<double>(i)));
}

/// Means over the cells of a coarser grid; at the finest, `in` itself.
Grid coarsened(const Grid& in, std::size_t width, std::size_t height) {
    if (width == in.width && height == in.height)
        return in;
    Grid across{width, in.height, std::vector<double>(width * in.height)};
    for (std::size_t y = 0; y < in.height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            forEachIn(x, width, in.width,
                      [&](std::size_t i, double share) { across.at(x, y) += share * in.at(i, y); });
    Grid out{width, height, std::vector<double>(width * height)};
    for (std::size_t y = 0; y < height; ++y)
        forEachIn(y, height, in.height, [&](std::size_t i, double share) {
            for (std::size_t x = 0; x < width; ++x)
                out.at(x, y) += share * across.at(x, i);
        });
    const double cell = static_cast<double>(in.width * in.height) / static_cast<double>(width * height);
    for (double& value : out.values)
        value /= cell;
    return out;
}

/// Cumulative probabilities of `weights` to `out`, which ends in 1. No weight above 0 gets a part that floats
/// cannot tell from none.
template <class WeightOf>
double accumulate(std::size_t count, const WeightOf& weightOf, float* out) {
    constexpr double leastShare = 1e-6;
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        sum += weightOf(i);
    const auto raised = [&](std::size_t i) {
        return weightOf(i) > 0.0 ? std::max(weightOf(i), sum * leastShare) : 0.0;
    };
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        total += raised(i);
    double running = 0.0;
    bool open = total > 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = open ? static_cast<float>(std::min(running / total, 1.0)) : 0.0f;
        running += raised(i);
    }
    out[count] = 1.0f;
    for (std::size_t i = count; open && i > 0 && raised(i - 1) == 0.0; --i)
        out[i - 1] = 1.0f; // rounding must not give a part to what comes after the last weight
    return sum;
}

} // namespace

EnvironmentTable makeEnvironmentTable(const Image& image) {
    EnvironmentTable table;
    if (image.width <= 0 || image.height <= 0)
        return table;
    const Grid fine = filtered(brightnessOf(image));
    const auto width = std::min<std::size_t>(fine.width, EnvironmentTable::mostColumns);
    const auto height = std::min<std::size_t>(fine.height, EnvironmentTable::mostRows);
    const Grid cells = coarsened(fine, width, height);
    table.cumulative.resize((height + 1) + height * (width + 1));
    std::vector<double> rows(height);
    for (std::size_t y = 0; y < height; ++y) {
        const double upper = std::cos(pi * static_cast<double>(y) / static_cast<double>(height));
        const double lower = std::cos(pi * static_cast<double>(y + 1) / static_cast<double>(height));
        float* columns = table.cumulative.data() + (height + 1) + y * (width + 1);
        rows[y] = accumulate(
                      width, [&](std::size_t x) { return cells.at(x, y); }, columns) *
                  (upper - lower) / static_cast<double>(width);
    }
    const double sum = accumulate(
        height, [&](std::size_t y) { return rows[y]; }, table.cumulative.data());
    if (!(sum > 0.0))
        return {};
    table.mean = 0.5 * sum; // the rows' heights add up to 2
    table.width = static_cast<std::uint32_t>(width);
    table.height = static_cast<std::uint32_t>(height);
    return table;
}

} // namespace prizma
