#pragma once

#include "core/render/geometry_store.h"
#include "core/render/kernel_set.h"

#include <vector>

namespace prizma {

/// The stages TriangleShader and RefitTreeShader: brings the trees of posed objects to their vertices.
class TreeRefitter {
  public:
    /// TriangleShader: corners into the leaves, the leaves' boxes into the nodes above them.
    Result<void> shadeTriangles(Context& context, KernelSet& kernels, const GeometryStore& geometry,
                                const std::vector<Id>& objects);

    /// RefitTreeShader: all other boxes. Follows shadeTriangles of the same objects. Waits for the device and
    /// notes the boxes and costs of the whole trees in their PosedPlace.
    Result<void> refit(Context& context, KernelSet& kernels, GeometryStore& geometry,
                       const std::vector<Id>& objects);

  private:
    /// What refitting a set of objects needs to know. It stays on the device while they stay where they are.
    struct Table {
        std::vector<Id> objects;
        std::uint64_t placesRevision = 0;
        std::vector<std::uint32_t> levelEnds; ///< Entries of a level end here; the next begins here.
        std::size_t blockCount = 0;
        Buffer<DeviceTreeBlock> blocks;
        Buffer<DeviceRefitEntry> entries;
        Buffer<std::uint32_t> deviceLevelEnds;
        Buffer<std::uint32_t> roots;
    };

    Result<void> loadTable(Context& context, const GeometryStore& geometry, const std::vector<Id>& objects);
    Result<void> loadBlocks(Context& context, const GeometryStore& geometry, const std::vector<Id>& objects);
    Result<void> launchLevels(Context& context, KernelSet& kernels, const GeometryStore& geometry);
    Result<void> readRoots(Context& context, KernelSet& kernels, GeometryStore& geometry);

    Table table_;
    Buffer<float> costs_; ///< One a node, beside GeometryStore::nodes(): the areas of all boxes below it.
    Buffer<float> measures_;
};

} // namespace prizma
