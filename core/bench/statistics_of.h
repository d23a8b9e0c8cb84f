#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
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

/// TBB's workers look for more work for a while after Embree is done, on a core that the device would use,
/// and a driver's threads may do so too. Each side is measured on a machine at rest.
inline void letWorkersRest() {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

} // namespace prizma::bench
