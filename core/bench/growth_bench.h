#pragma once

#include "core/bench/build_bench.h"
#include "core/bench/refit_bench.h"
#include "core/bench/trace_bench.h"

#include <string>
#include <vector>

namespace prizma::bench {

struct GrowthBenchOptions {
    std::string deviceId; ///< Empty: the default device.
    std::size_t mostTriangles = 10'000'000;
    int repeats = 3;
};

/// Everything measured for one size of the procedural scene, as one mesh.
struct GrowthRow {
    BuildReport build;
    RefitReport refit;
    TraceReport trace;
};

struct GrowthReport {
    std::string device;
    std::vector<GrowthRow> rows; ///< From about 1,000 triangles on, each about ten times as large.
};

/// Measures how the cost of everything grows with the number of triangles. Errors: no device, no memory.
Result<GrowthReport> benchGrowth(const GrowthBenchOptions& options);

} // namespace prizma::bench
