#include "core/bench/build_bench.h"

#include "core/bench/embree_peer.h"
#include "core/bench/statistics_of.h"
#include "core/bvh/tree_store.h"
#include "core/scene/hierarchy.h"

#include <algorithm>
#include <set>

namespace prizma::bench {
namespace {

std::set<MeshPtr> meshesOf(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    std::set<MeshPtr> meshes;
    for (const Object& object : scene.objects)
        if (object.mesh && hierarchy.isShown(object))
            meshes.insert(object.mesh);
    return meshes;
}

std::size_t bytesOf(const DeviceTree& tree) {
    return tree.wideNodes.size() * sizeof(WideNode) + tree.wideLeaves.size() * sizeof(WideLeaf) +
           tree.binaryNodes.size() * sizeof(BinaryNode) +
           tree.binaryTriangles.size() * sizeof(BinaryTriangle);
}

struct Times {
    double build = 0.0, layout = 0.0;
    std::optional<double> embree;
};

/// Builds all meshes once. Adds what does not change from round to round to `report` in the first one.
Result<Times> runOnce(const std::set<MeshPtr>& meshes, TreeLayout layout, bool first, BuildReport& report) {
    Times times;
    for (const MeshPtr& mesh : meshes) {
        Progress progress;
        Result<Bvh> bvh;
        DeviceTree tree;
        times.build += measure([&] { bvh = buildBvh(*mesh, buildOptionsFor(layout), progress); });
        if (!bvh)
            return std::unexpected(bvh.error());
        times.layout += measure([&] { tree = layOutBottomLevel(*bvh, *mesh, layout); });
        if (const auto embree = embreeBuildMilliseconds(*mesh))
            times.embree = times.embree.value_or(0.0) + *embree;
        if (!first)
            continue;
        const auto triangles = static_cast<double>(mesh->triangles.size());
        report.triangles += mesh->triangles.size();
        report.bytesPerTriangle += static_cast<double>(bytesOf(tree)); // divided by the triangles in the end
        report.sahCost += sahCost(*bvh, buildOptionsFor(layout)) * triangles;
        report.depth = std::max(report.depth, tree.depth);
    }
    return times;
}

} // namespace

Result<BuildReport> benchBuild(const Scene& scene, const BuildBenchOptions& options) {
    const std::set<MeshPtr> meshes = meshesOf(scene);
    if (meshes.empty())
        return failure("There is no mesh in the scene.");
    BuildReport report;
    std::vector<double> build, layout, sum, embree;
    for (int i = 0; i < options.repeats; ++i) {
        const auto times = runOnce(meshes, options.layout, i == 0, report);
        if (!times)
            return std::unexpected(times.error());
        build.push_back(times->build);
        layout.push_back(times->layout);
        sum.push_back(times->build + times->layout);
        if (times->embree)
            embree.push_back(*times->embree);
    }
    const double triangles = std::max(static_cast<double>(report.triangles), 1.0);
    report.bytesPerTriangle /= triangles;
    report.sahCost /= triangles;
    report.buildMilliseconds = median(build);
    report.layoutMilliseconds = median(layout);
    report.milliseconds = median(sum);
    if (!embree.empty()) {
        report.embreeMedium = median(embree);
        report.ratio = report.milliseconds / std::max(*report.embreeMedium, 1e-6);
    }
    return report;
}

} // namespace prizma::bench
