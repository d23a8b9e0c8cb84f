#pragma once

#include "core/bvh/device_layout.h"
#include "core/progress.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace prizma {

using DeviceTreePtr = std::shared_ptr<const DeviceTree>;

/// What a build has to know of the device: how many triangles a leaf's test takes at a time.
BvhBuildOptions buildOptionsFor(TreeLayout layout);

/// Builds the tree over a mesh's triangles that suits a layout: binned SAH, then the largest nodes
/// reinserted. Errors: cancelled, no memory.
Result<Bvh> buildBottomLevel(const Mesh& mesh, TreeLayout layout, Progress& progress);

/// Builds and lays out the bottom-level tree of a mesh. Null only if cancelled.
DeviceTreePtr buildTree(const Mesh& mesh, TreeLayout layout, Progress& progress);

/// Bottom-level trees by mesh, built in the background, one after the other (each build uses all cores). Safe
/// from any thread.
class TreeStore {
  public:
    /// `treeReady` is called on the building thread after each build.
    explicit TreeStore(TreeLayout layout, std::function<void()> treeReady = {});
    ~TreeStore();

    TreeStore(const TreeStore&) = delete;
    TreeStore& operator=(const TreeStore&) = delete;

    TreeLayout layout() const { return layout_; }

    /// The mesh's tree, or null while it is being built; the first call starts the build.
    DeviceTreePtr request(const MeshPtr& mesh);

    /// The mesh's tree, waiting for it if need be.
    DeviceTreePtr wait(const MeshPtr& mesh);

    /// Forgets the trees of all other meshes and cancels their builds.
    void keepOnly(const std::vector<MeshPtr>& meshes);

    bool isBuilding() const;

  private:
    struct Entry {
        MeshPtr mesh;
        DeviceTreePtr tree;
        std::shared_ptr<Progress> progress = std::make_shared<Progress>();
    };

    void buildLoop(const std::stop_token& stop);
    std::shared_ptr<Entry> nextEntry();

    const TreeLayout layout_;
    const std::function<void()> treeReady_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::map<const Mesh*, std::shared_ptr<Entry>> entries_;
    std::jthread builder_; ///< Last: it uses everything above.
};

} // namespace prizma
