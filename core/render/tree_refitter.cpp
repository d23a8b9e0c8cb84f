#include "core/render/tree_refitter.h"

#include <algorithm>

namespace prizma {
namespace {

constexpr std::uint32_t groupSize = 64;
/// Levels with fewer nodes cost less in one work group than in launches of their own.
constexpr std::uint32_t smallLevel = 512;
constexpr std::size_t measuresATree = 7; ///< Box and cost.

} // namespace

Result<void> TreeRefitter::shadeTriangles(Context& context, KernelSet& kernels, const GeometryStore& geometry,
                                          const std::vector<Id>& objects) {
    if (auto ok = costs_.reserve(context, geometry.nodeCapacity(), "tree's costs"); !ok)
        return ok;
    if (auto ok = loadTable(context, geometry, objects); !ok)
        return ok;
    Kernel& kernel = kernels.triangleShader;
    kernel.setArguments(geometry.nodes(), costs_, table_.blocks, geometry.leaves(), geometry.triangles(),
                        geometry.positions());
    if (const auto launched = kernel.launch(context, table_.blockCount * groupSize, groupSize); !launched)
        return std::unexpected(launched.error());
    return {};
}

Result<void> TreeRefitter::refit(Context& context, KernelSet& kernels, GeometryStore& geometry,
                                 const std::vector<Id>& objects) {
    if (auto ok = loadTable(context, geometry, objects); !ok)
        return ok;
    if (auto ok = launchLevels(context, kernels, geometry); !ok)
        return ok;
    return readRoots(context, kernels, geometry);
}

Result<void> TreeRefitter::loadBlocks(Context& context, const GeometryStore& geometry,
                                      const std::vector<Id>& objects) {
    std::vector<DeviceTreeBlock> blocks;
    for (const Id id : objects) {
        const ObjectPlace place = geometry.placeOf(id);
        const auto count = static_cast<std::uint32_t>(nodeCount(*place.posed->tree));
        for (std::uint32_t first = 0; first < count; first += groupSize)
            blocks.push_back({place.posed->nodeBase + first, std::min(count - first, groupSize),
                              place.posed->leafBase, place.mesh->triangleBase, place.posed->vertexBase});
    }
    table_.blockCount = blocks.size();
    return table_.blocks.assign(context, blocks, "list of nodes");
}

Result<void> TreeRefitter::loadTable(Context& context, const GeometryStore& geometry,
                                     const std::vector<Id>& objects) {
    if (table_.objects == objects && table_.placesRevision == geometry.posedRevision())
        return {};
    table_.objects.clear(); // should something below fail
    table_.levelEnds.clear();
    if (auto ok = loadBlocks(context, geometry, objects); !ok)
        return ok;
    std::vector<DeviceRefitEntry> entries;
    std::vector<std::uint32_t> roots;
    for (const Id id : objects)
        roots.push_back(geometry.placeOf(id).posed->nodeBase);
    // Level 0 holds the nodes without inner children: TriangleShader does those.
    for (std::size_t level = 1;; ++level) {
        const std::size_t before = entries.size();
        for (const Id id : objects) {
            const PosedPlace& posed = *geometry.placeOf(id).posed;
            if (level < posed.tree->refitLevels.size())
                for (const std::uint32_t node : posed.tree->refitLevels[level])
                    entries.push_back({posed.nodeBase + node, posed.nodeBase});
        }
        if (entries.size() == before)
            break;
        table_.levelEnds.push_back(static_cast<std::uint32_t>(entries.size()));
    }
    if (auto ok = table_.entries.assign(context, entries, "refit levels"); !ok)
        return ok;
    if (auto ok = table_.deviceLevelEnds.assign(context, table_.levelEnds, "refit levels"); !ok)
        return ok;
    if (auto ok = table_.roots.assign(context, roots, "refit levels"); !ok)
        return ok;
    table_.objects = objects;
    table_.placesRevision = geometry.posedRevision();
    return {};
}

Result<void> TreeRefitter::launchLevels(Context& context, KernelSet& kernels, const GeometryStore& geometry) {
    const auto levels = static_cast<std::uint32_t>(table_.levelEnds.size());
    std::uint32_t first = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        const std::uint32_t count = table_.levelEnds[level] - first;
        if (count < smallLevel) { // so are all levels above: a node has a child in the level below its own
            Kernel& kernel = kernels.refitSmallLevels;
            kernel.setArguments(geometry.nodes(), costs_, table_.entries, first, table_.deviceLevelEnds,
                                level, levels);
            if (const auto launched = kernel.launch(context, groupSize, groupSize); !launched)
                return std::unexpected(launched.error());
            break;
        }
        Kernel& kernel = kernels.refitTreeShader;
        kernel.setArguments(geometry.nodes(), costs_, table_.entries, first, count);
        if (const auto launched = kernel.launch(context, count, groupSize); !launched)
            return std::unexpected(launched.error());
        first += count;
    }
    return {};
}

Result<void> TreeRefitter::readRoots(Context& context, KernelSet& kernels, GeometryStore& geometry) {
    const std::size_t trees = table_.objects.size();
    if (auto ok = measures_.reserve(context, measuresATree * trees, "bounds"); !ok)
        return ok;
    Kernel& kernel = kernels.gatherRoots;
    kernel.setArguments(geometry.nodes(), costs_, table_.roots, measures_, static_cast<std::uint32_t>(trees));
    if (const auto launched = kernel.launch(context, trees, groupSize); !launched)
        return std::unexpected(launched.error());
    std::vector<float> values(measuresATree * trees);
    if (auto ok = measures_.read(context, values, 0, "bounds"); !ok)
        return ok;
    for (std::size_t i = 0; i < trees; ++i) {
        const float* v = &values[measuresATree * i];
        PosedPlace& posed = *geometry.posedPlaceOf(table_.objects[i]);
        posed.bounds = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
        posed.cost = static_cast<double>(v[6]);
    }
    return {};
}

} // namespace prizma
