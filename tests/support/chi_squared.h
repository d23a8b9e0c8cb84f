#pragma once

#include <cmath>
#include <vector>

namespace prizma::test {

/// Probability that a chi-squared variable of that many degrees of freedom exceeds `statistic`: the upper
/// regularised incomplete gamma function, as series or continued fraction (Lentz 1976).
inline double chiSquaredTail(double statistic, double degrees) {
    const double a = 0.5 * degrees;
    const double x = 0.5 * statistic;
    if (!(x > 0.0) || a <= 0.0)
        return 1.0;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int n = 1; n < 100000 && term > sum * 1e-16; ++n) {
            term *= x / (a + n);
            sum += term;
        }
        return 1.0 - scale * sum;
    }
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double fraction = d;
    for (int n = 1; n < 100000; ++n) {
        const double an = -n * (n - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        fraction *= c * d;
        if (std::abs(c * d - 1.0) < 1e-15)
            break;
    }
    return scale * fraction;
}

/// p-value of Pearson's test that `counts` come from a distribution that expects `expected`. Cells that
/// expect fewer than five are pooled; what falls where nothing is expected is counted in the pool.
inline double chiSquaredTest(const std::vector<double>& counts, const std::vector<double>& expected) {
    double statistic = 0.0;
    double pooledCount = 0.0, pooledExpected = 0.0;
    int cells = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 5.0) {
            pooledCount += counts[i];
            pooledExpected += expected[i];
            continue;
        }
        const double difference = counts[i] - expected[i];
        statistic += difference * difference / expected[i];
        ++cells;
    }
    if (pooledExpected >= 5.0 || pooledCount >= 5.0) {
        const double difference = pooledCount - pooledExpected;
        statistic += difference * difference / std::max(pooledExpected, 1.0);
        ++cells;
    }
    return cells > 1 ? chiSquaredTail(statistic, cells - 1) : 1.0;
}

/// The level at which each of `tests` independent tests is to be rejected so that all of them together are
/// wrongly rejected with probability `level` (Sidak 1967).
inline double sidakLevel(double level, int tests) {
    return 1.0 - std::pow(1.0 - level, 1.0 / tests);
}

} // namespace prizma::test
