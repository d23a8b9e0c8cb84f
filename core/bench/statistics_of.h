#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace prizma::bench {

/// The middle one of a few measurements, which outliers do not move; 0 for none.
inline double median(std::vector<double> values) {
    if (values.empty())
        return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 != 0 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Milliseconds that `work` takes.
template <class Work>
double measure(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace prizma::bench
