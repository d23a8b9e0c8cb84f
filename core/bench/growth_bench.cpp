#include "core/bench/growth_bench.h"

#include "core/bench/procedural_scene.h"

namespace prizma::bench {
namespace {

Result<GrowthRow> measureSize(std::size_t triangles, const GrowthBenchOptions& options) {
    const Scene scene = makeProceduralScene(ProceduralForm::OneMesh, triangles);
    // One after the other: each holds its own copy of the scene.
    TraceBenchOptions traceOptions;
    traceOptions.deviceId = options.deviceId;
    traceOptions.repeats = options.repeats;
    auto trace = benchTrace(scene, traceOptions);
    if (!trace)
        return std::unexpected(trace.error());
    auto build = benchBuild(scene, {trace->layout, options.repeats});
    if (!build)
        return std::unexpected(build.error());
    auto refit = benchRefit(scene, {options.deviceId, std::nullopt, options.repeats});
    if (!refit)
        return std::unexpected(refit.error());
    return GrowthRow{std::move(*build), std::move(*refit), std::move(*trace)};
}

} // namespace

Result<GrowthReport> benchGrowth(const GrowthBenchOptions& options) {
    GrowthReport report;
    for (std::size_t triangles = 1000; triangles <= options.mostTriangles; triangles *= 10) {
        auto row = measureSize(triangles, options);
        if (!row)
            return std::unexpected(row.error());
        report.device = row->trace.device;
        report.rows.push_back(std::move(*row));
    }
    return report;
}

} // namespace prizma::bench
