#include "core/bvh/bvh.h"

#include "core/bvh/sah_split.h"

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>

namespace prizma {
namespace {

constexpr std::uint32_t blockSize = 8192;   ///< Larger nodes are worked on by several threads, in blocks.
constexpr std::uint32_t subtreeSize = 4096; ///< Smaller subtrees are one task.

SahCosts costsOf(const BvhBuildOptions& options) {
    const auto width = std::bit_ceil(std::max(options.leafWidth, 1u));
    return {options.traversalCost, options.intersectionCost,
            static_cast<std::uint32_t>(std::countr_zero(width))};
}

std::uint32_t blocksOf(std::uint32_t count) {
    return (count + blockSize - 1) / blockSize;
}

template <class Work>
void forEachBlock(std::uint32_t count, const Work& work) {
    const auto run = [&](std::uint32_t block) {
        work(block, block * blockSize, std::min(count, (block + 1) * blockSize));
    };
    if (blocksOf(count) == 1)
        run(0);
    else
        tbb::parallel_for(0u, blocksOf(count), run);
}

bool isUsable(const Bounds& box) {
    // Comparisons with NaN are false; the sum is finite only if all of it is.
    return !box.isEmpty() && std::isfinite(box.low.x) && std::isfinite(box.low.y) &&
           std::isfinite(box.low.z) && std::isfinite(box.high.x) && std::isfinite(box.high.y) &&
           std::isfinite(box.high.z);
}

/// Fragments go back and forth between two arrays, from level to level. A range of them keeps its place, so
/// that a leaf's range is also its range in `Bvh::primitives`.
class Builder {
  public:
    Builder(const BvhBuildOptions& options, Progress& progress)
        : options_(options), costs_(costsOf(options)), progress_(progress) {
        options_.maxLeafSize = std::max(options_.maxLeafSize, 1u);
    }

    /// Takes the boxes in; `boxOf(i)` gives the i-th.
    template <class BoxOf>
    void load(std::uint32_t count, const BoxOf& boxOf);

    Result<Bvh> build();

  private:
    /// A node that is still to be made: fragments [first, first + count) of one of the arrays.
    struct Job {
        Box4 box;
        Box4 centres; ///< Of half centroids.
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        int depth = 0;
        int array = 0;
    };
    struct Children {
        Job left, right;
    };
    /// A part of the tree: a finished subtree, or an inner node with two more parts.
    struct Branch {
        Bounds bounds;
        std::vector<BvhNode> nodes; ///< [0] is the subtree's root; empty for an inner node.
        std::unique_ptr<Branch> left, right;
        int depth = 0; ///< Of the deepest leaf.
    };

    std::span<const Fragment> fragments(const Job& job) const {
        return {arrays_[job.array].get() + job.first, job.count};
    }

    std::unique_ptr<Branch> buildBranch(const Job& job);
    void buildSubtree(const Job& root, Branch& branch);
    void makeLeaf(const Job& job, BvhNode& node);
    bool divide(const Job& job, BinSet& bins, Children& children);
    void divideAt(const Split& split, const Job& job, const BinMapping& mapping,
                  const std::vector<BinSet>& blocks, Children& children);
    void divideInHalves(const Job& job, Children& children);
    int levelsFor(std::uint32_t count) const;
    bool fits(const Job& job, std::uint32_t childCount) const {
        return job.depth + 1 + levelsFor(childCount) <= options_.maxDepth;
    }

    BvhBuildOptions options_;
    SahCosts costs_;
    Progress& progress_;
    std::uint32_t count_ = 0;
    std::unique_ptr<Fragment[]> arrays_[2];
    Job root_;
    std::vector<std::uint32_t> primitives_;
    std::atomic<std::uint32_t> finished_{0};
};

template <class BoxOf>
void Builder::load(std::uint32_t count, const BoxOf& boxOf) {
    arrays_[0] = std::make_unique_for_overwrite<Fragment[]>(count);
    std::vector<Job> blocks(blocksOf(count));
    forEachBlock(count, [&](std::uint32_t block, std::uint32_t first, std::uint32_t end) {
        Job& job = blocks[block];
        job.first = first;
        for (std::uint32_t i = first; i < end; ++i) {
            const Bounds box = boxOf(i);
            if (!isUsable(box))
                continue;
            const Fragment fragment = Fragment::of(box, i);
            arrays_[0][first + job.count++] = fragment;
            job.box.add(fragment.low, fragment.high);
            job.centres.add(fragment.halfCentre(), fragment.halfCentre());
        }
    });
    for (const Job& job : blocks) { // closes the gaps where boxes were left out
        if (root_.count != job.first)
            std::copy_n(&arrays_[0][job.first], job.count, &arrays_[0][root_.count]);
        root_.count += job.count;
        root_.box.add(job.box);
        root_.centres.add(job.centres);
    }
    count_ = root_.count;
    arrays_[1] = std::make_unique_for_overwrite<Fragment[]>(count_);
}

Result<Bvh> Builder::build() {
    Bvh bvh;
    if (count_ == 0)
        return bvh;
    options_.maxDepth = std::max(options_.maxDepth, levelsFor(count_));
    primitives_.resize(count_);
    const std::unique_ptr<Branch> top = buildBranch(root_);
    if (progress_.isCancelled())
        return failure("Building the tree was cancelled.");

    // Concatenates the subtrees depth first, each with its children's indices moved.
    struct Step {
        const Branch* branch;
        std::uint32_t place;
    };
    std::vector<Step> steps{{top.get(), 0}};
    bvh.nodes.emplace_back();
    while (!steps.empty()) {
        const auto [branch, place] = steps.back();
        steps.pop_back();
        const auto next = static_cast<std::uint32_t>(bvh.nodes.size());
        bvh.depth = std::max(bvh.depth, branch->depth);
        if (branch->left) {
            bvh.nodes[place] = {branch->bounds, next, 0};
            bvh.nodes.resize(next + 2);
            steps.push_back({branch->right.get(), next + 1});
            steps.push_back({branch->left.get(), next});
            continue;
        }
        bvh.nodes.insert(bvh.nodes.end(), branch->nodes.begin() + 1, branch->nodes.end());
        bvh.nodes[place] = branch->nodes.front();
        const auto shift = [next](BvhNode& node) { node.first += node.isLeaf() ? 0 : next - 1; };
        shift(bvh.nodes[place]);
        std::for_each(bvh.nodes.begin() + next, bvh.nodes.end(), shift);
    }
    bvh.primitives = std::move(primitives_);
    progress_.set(1.0);
    return bvh;
}

std::unique_ptr<Builder::Branch> Builder::buildBranch(const Job& job) {
    auto branch = std::make_unique<Branch>();
    branch->bounds = job.box.bounds();
    Children children;
    BinSet bins;
    if (job.count <= subtreeSize || progress_.isCancelled() || !divide(job, bins, children)) {
        buildSubtree(job, *branch);
        return branch;
    }
    tbb::task_group group;
    group.run([&] { branch->right = buildBranch(children.right); });
    branch->left = buildBranch(children.left);
    group.wait();
    return branch;
}

void Builder::buildSubtree(const Job& root, Branch& branch) {
    struct Step {
        Job job;
        std::uint32_t place;
    };
    branch.nodes.reserve(root.count / 2 + 1);
    branch.nodes.emplace_back();
    if (progress_.isCancelled())
        return;
    std::vector<Step> steps{{root, 0}};
    BinSet bins;
    Children children;
    while (!steps.empty()) {
        const Step step = steps.back();
        steps.pop_back();
        branch.depth = std::max(branch.depth, step.job.depth);
        if (!divide(step.job, bins, children)) {
            makeLeaf(step.job, branch.nodes[step.place]);
            continue;
        }
        const auto next = static_cast<std::uint32_t>(branch.nodes.size());
        branch.nodes[step.place] = {step.job.box.bounds(), next, 0};
        branch.nodes.resize(next + 2);
        steps.push_back({children.right, next + 1});
        steps.push_back({children.left, next});
    }
    const std::uint32_t finished = finished_.fetch_add(root.count) + root.count;
    progress_.set(static_cast<double>(finished) / count_);
}

void Builder::makeLeaf(const Job& job, BvhNode& node) {
    node = {job.box.bounds(), job.first, job.count};
    std::uint32_t place = job.first;
    for (const Fragment& fragment : fragments(job))
        primitives_[place++] = fragment.primitive();
}

/// Splits a node in two; false if it shall be a leaf.
bool Builder::divide(const Job& job, BinSet& bins, Children& children) {
    const bool mayBeLeaf = job.count <= options_.maxLeafSize;
    const float leafCost = costs_.intersection * costs_.leafSteps(job.count);
    if (job.count == 1 || (mayBeLeaf && leafCost <= costs_.traversal))
        return false;
    const BinMapping mapping(job.centres, job.count);
    if (mapping.isDegenerate()) {
        if (!mayBeLeaf)
            divideInHalves(job, children);
        return !mayBeLeaf;
    }

    std::vector<BinSet> blocks(job.count > blockSize ? blocksOf(job.count) : 0);
    if (blocks.empty()) {
        bins.clear(mapping.bins());
        bins.add(fragments(job), mapping);
    } else {
        forEachBlock(job.count, [&](std::uint32_t block, std::uint32_t first, std::uint32_t end) {
            blocks[block].clear(mapping.bins());
            blocks[block].add(fragments(job).subspan(first, end - first), mapping);
        });
        bins = blocks.front();
        for (std::size_t i = 1; i < blocks.size(); ++i)
            bins.add(blocks[i], mapping.bins());
    }

    const Split split = findBestSplit(bins, mapping, job.box, costs_);
    if (mayBeLeaf && (!split.isValid() || leafCost <= split.cost))
        return false;
    const std::uint32_t leftCount = split.isValid() ? bins.countBelow(split.axis, split.bin) : 0;
    if (!split.isValid() || !fits(job, leftCount) || !fits(job, job.count - leftCount)) {
        // A leaf rather than halves below the depth that was asked for.
        if (mayBeLeaf)
            return false;
        divideInHalves(job, children);
        return true;
    }
    children.left.count = leftCount;
    children.left.box = children.right.box = Box4{};
    for (std::uint32_t bin = 0; bin < mapping.bins(); ++bin)
        (bin < split.bin ? children.left : children.right).box.add(bins.boxes[split.axis][bin]);
    divideAt(split, job, mapping, blocks, children);
    return true;
}

/// Sorts the fragments into the other array. The left child's count and both boxes are known already.
void Builder::divideAt(const Split& split, const Job& job, const BinMapping& mapping,
                       const std::vector<BinSet>& blocks, Children& children) {
    Job& left = children.left;
    Job& right = children.right;
    left.depth = right.depth = job.depth + 1;
    left.array = right.array = 1 - job.array;
    left.first = job.first;
    right.first = job.first + left.count;
    right.count = job.count - left.count;
    Fragment* const leftPlace = arrays_[left.array].get() + left.first;
    Fragment* const rightPlace = arrays_[right.array].get() + right.first;
    if (blocks.empty()) {
        const PartitionBounds bounds = partition(fragments(job), mapping, split, leftPlace, rightPlace);
        left.centres = bounds.leftCentres;
        right.centres = bounds.rightCentres;
        return;
    }
    std::vector<std::uint32_t> before(blocks.size(), 0); // how many go left in earlier blocks
    for (std::size_t i = 1; i < blocks.size(); ++i)
        before[i] = before[i - 1] + blocks[i - 1].countBelow(split.axis, split.bin);
    std::vector<PartitionBounds> bounds(blocks.size());
    forEachBlock(job.count, [&](std::uint32_t block, std::uint32_t first, std::uint32_t end) {
        bounds[block] = partition(fragments(job).subspan(first, end - first), mapping, split,
                                  leftPlace + before[block], rightPlace + (first - before[block]));
    });
    left.centres = right.centres = Box4{};
    for (const PartitionBounds& part : bounds) {
        left.centres.add(part.leftCentres);
        right.centres.add(part.rightCentres);
    }
}

/// The way out where no plane helps: coincident centroids, or a tree that would get too deep. The left side
/// gets whole leaves, so that `levelsFor` shrinks by one a level.
void Builder::divideInHalves(const Job& job, Children& children) {
    const std::uint32_t leaves = (job.count + options_.maxLeafSize - 1) / options_.maxLeafSize;
    const std::uint32_t leftCount = leaves > 1 ? leaves / 2 * options_.maxLeafSize : job.count / 2;
    int array = job.array;
    const Float4 extent = job.centres.high - job.centres.low;
    const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : (extent[1] >= extent[2] ? 1 : 2);
    if (extent[axis] > 0.0f) {
        std::vector<std::pair<float, std::uint32_t>> order(
            job.count); // pairs, so that ties do not depend on luck
        const std::span<const Fragment> from = fragments(job);
        for (std::uint32_t i = 0; i < job.count; ++i)
            order[i] = {from[i].halfCentre()[axis], i};
        std::nth_element(order.begin(), order.begin() + leftCount, order.end());
        array = 1 - array;
        for (std::uint32_t i = 0; i < job.count; ++i)
            arrays_[array][job.first + i] = from[order[i].second];
    }
    const auto child = [&](std::uint32_t first, std::uint32_t count) {
        Job result;
        result.first = job.first + first;
        result.count = count;
        result.depth = job.depth + 1;
        result.array = array;
        for (const Fragment& fragment : fragments(result)) {
            result.box.add(fragment.low, fragment.high);
            result.centres.add(fragment.halfCentre(), fragment.halfCentre());
        }
        return result;
    };
    children.left = child(0, leftCount);
    children.right = child(leftCount, job.count - leftCount);
}

/// Levels that a node of `count` primitives needs at least below itself.
int Builder::levelsFor(std::uint32_t count) const {
    const std::uint32_t leaves = (count + options_.maxLeafSize - 1) / options_.maxLeafSize;
    return leaves <= 1 ? 0 : static_cast<int>(std::bit_width(leaves - 1));
}

template <class BoxOf>
Result<Bvh> buildFrom(std::size_t count, const BoxOf& boxOf, const BvhBuildOptions& options,
                      Progress& progress) {
    if (count > Fragment::maxPrimitives)
        return failure("There are too many primitives for one tree.");
    if (progress.isCancelled())
        return failure("Building the tree was cancelled.");
    try {
        Builder builder(options, progress);
        builder.load(static_cast<std::uint32_t>(count), boxOf);
        return builder.build();
    } catch (const std::bad_alloc&) {
        return failure("There is not enough memory to build the tree.");
    }
}

} // namespace

Result<Bvh> buildBvh(std::span<const Bounds> primitives, const BvhBuildOptions& options, Progress& progress) {
    return buildFrom(
        primitives.size(), [primitives](std::uint32_t i) { return primitives[i]; }, options, progress);
}

Result<Bvh> buildBvh(const Mesh& mesh, const BvhBuildOptions& options, Progress& progress) {
    const auto boxOf = [&mesh](std::uint32_t i) { return triangleBounds(mesh, i); };
    return buildFrom(mesh.triangles.size(), boxOf, options, progress);
}

Bounds triangleBounds(const Mesh& mesh, std::uint32_t triangle) {
    const glm::uvec3 corners = mesh.triangles[triangle];
    const glm::vec3 a = mesh.positions[corners.x];
    const glm::vec3 b = mesh.positions[corners.y];
    const glm::vec3 c = mesh.positions[corners.z];
    // min and max may drop a NaN; x - x is 0 for all finite x and NaN for the rest.
    const glm::vec3 fault = (a - a) + (b - b) + (c - c);
    return {glm::min(a, glm::min(b, c)) + fault, glm::max(a, glm::max(b, c)) + fault};
}

double sahCost(const Bvh& bvh, const BvhBuildOptions& options) {
    if (bvh.nodes.empty())
        return 0.0;
    const SahCosts costs = costsOf(options);
    const auto areaOf = [](const BvhNode& node) {
        return DBounds{node.bounds.low, node.bounds.high}.halfArea();
    };
    double sum = 0.0;
    for (std::size_t i = 1; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        sum += areaOf(node) * (node.isLeaf() ? double(costs.intersection) * costs.leafSteps(node.count)
                                             : double(costs.traversal));
    }
    const BvhNode& root = bvh.nodes.front();
    const double rootCost =
        root.isLeaf() ? double(costs.intersection) * costs.leafSteps(root.count) : double(costs.traversal);
    const double rootArea = areaOf(root);
    return rootArea > 0.0 ? rootCost + sum / rootArea : rootCost;
}

} // namespace prizma
