#include "core/bvh/tree_store.h"

#include "core/bvh/reinsertion.h"

#include <algorithm>
#include <set>

namespace prizma {

BvhBuildOptions buildOptionsFor(TreeLayout layout) {
    BvhBuildOptions options;
    if (layout == TreeLayout::Binary2)
        options.leafWidth = 1; // a thread tests one triangle after the other
    return options;
}

Result<Bvh> buildBottomLevel(const Mesh& mesh, TreeLayout layout, Progress& progress) {
    constexpr double buildShare = 0.9; // of the time
    const BvhBuildOptions options = buildOptionsFor(layout);
    progress.beginPart(0.0, buildShare);
    auto bvh = buildBvh(mesh, options, progress);
    progress.beginPart(buildShare, 1.0);
    ReinsertionOptions reinsertion;
    reinsertion.maxDepth = options.maxDepth;
    if (bvh && !reinsertNodes(*bvh, reinsertion, progress))
        return failure("Building the tree was cancelled.");
    return bvh;
}

DeviceTreePtr buildTree(const Mesh& mesh, TreeLayout layout, Progress& progress) {
    const auto bvh = buildBottomLevel(mesh, layout, progress);
    if (!bvh)
        return nullptr;
    return std::make_shared<const DeviceTree>(layOutBottomLevel(*bvh, mesh, layout));
}

TreeStore::TreeStore(TreeLayout layout, std::function<void()> treeReady)
    : layout_(layout),
      treeReady_(std::move(treeReady)),
      builder_([this](const std::stop_token& stop) { buildLoop(stop); }) {}

TreeStore::~TreeStore() {
    keepOnly({});
    builder_.request_stop();
    changed_.notify_all();
}

DeviceTreePtr TreeStore::request(const MeshPtr& mesh) {
    const std::lock_guard lock(mutex_);
    auto& entry = entries_[mesh.get()];
    if (!entry) {
        entry = std::make_shared<Entry>();
        entry->mesh = mesh;
        changed_.notify_all();
    }
    return entry->tree;
}

DeviceTreePtr TreeStore::wait(const MeshPtr& mesh) {
    request(mesh);
    std::unique_lock lock(mutex_);
    const auto entry = entries_.at(mesh.get());
    changed_.wait(lock, [&] { return entry->tree || entry->progress->isCancelled(); });
    return entry->tree;
}

void TreeStore::keepOnly(const std::vector<MeshPtr>& meshes) {
    std::set<const Mesh*> kept;
    for (const MeshPtr& mesh : meshes)
        kept.insert(mesh.get());
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [&](const auto& item) {
        if (kept.contains(item.first))
            return false;
        item.second->progress->cancel();
        return true;
    });
    changed_.notify_all();
}

bool TreeStore::isBuilding() const {
    const std::lock_guard lock(mutex_);
    return std::any_of(entries_.begin(), entries_.end(), [](const auto& item) { return !item.second->tree; });
}

std::shared_ptr<TreeStore::Entry> TreeStore::nextEntry() {
    for (const auto& [mesh, entry] : entries_)
        if (!entry->tree)
            return entry;
    return nullptr;
}

void TreeStore::buildLoop(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::shared_ptr<Entry> entry;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return (entry = nextEntry()) != nullptr; }))
                return;
        }
        DeviceTreePtr tree = buildTree(*entry->mesh, layout_, *entry->progress);
        {
            const std::lock_guard lock(mutex_);
            entry->tree = std::move(tree);
        }
        changed_.notify_all();
        if (treeReady_)
            treeReady_();
    }
}

} // namespace prizma
