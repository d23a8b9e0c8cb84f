#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace prizma::test {

/// Upper tail of the chi-squared distribution: the chance of `value` or more with `freedom` degrees of
/// freedom. The regularised incomplete gamma function, by its series or Lentz's continued fraction.
inline double chiSquaredTail(double value, double freedom) {
    const double a = freedom / 2;
    const double x = value / 2;
    if (x <= 0)
        return 1;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a;
        double sum = term;
        for (double n = a + 1; term > sum * 1e-16; ++n)
            sum += term *= x / n;
        return 1 - sum * scale;
    }
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double fraction = d;
    for (int i = 1; i < 100'000; ++i) {
        const double numerator = -i * (i - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= d * c;
        if (std::abs(d * c - 1) < 1e-15)
            break;
    }
    return fraction * scale;
}

/// Level of one of `count` independent tests that keeps the chance of any false alarm at `level` (Šidák).
inline double sidak(double level, double count) {
    return -std::expm1(std::log1p(-level) / count);
}

/// How many standard deviations a normal variable exceeds on either side with probability `tail`.
inline double twoSidedLimit(double tail) {
    double low = 0;
    double high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
    }
    return high;
}

struct Mean {
    double value = 0, standardError = 0;
};

inline Mean meanOf(std::span<const double> values) {
    Mean mean;
    for (const double value : values)
        mean.value += value;
    const auto count = static_cast<double>(values.size());
    mean.value /= count;
    double squares = 0;
    for (const double value : values)
        squares += (value - mean.value) * (value - mean.value);
    mean.standardError = std::sqrt(squares / (count - 1) / count);
    return mean;
}

/// P-value of observed counts against expected ones. Cells are pooled, the emptiest first, until each expects
/// 5 at least.
inline double chiSquaredTest(std::span<const double> observed, std::span<const double> expected) {
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return expected[i]; });
    double statistic = 0;
    int cells = 0;
    double pooledObserved = 0;
    double pooledExpected = 0;
    for (const std::size_t i : order) {
        pooledObserved += observed[i];
        pooledExpected += expected[i];
        if (pooledExpected < 5)
            continue;
        statistic += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
        ++cells;
        pooledObserved = pooledExpected = 0;
    }
    return cells > 1 ? chiSquaredTail(statistic, cells - 1) : 1;
}

} // namespace prizma::test
