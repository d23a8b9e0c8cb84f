// RefitTreeShader: new boxes for the inner children of nodes, level by level, over the trees of all Dynamic objects
// that moved. Levels run one after the other, those next to the leaves first, so that children are done before
// parents. TriangleShader has done the boxes of leaves.
#include "refit.clh"

// `costs` of a node, beside `nodes`: the sum of the areas of all boxes below it; TriangleShader put those of its
// leaves there.
inline void refitNode(global TreeNode* nodes, global float* costs, DeviceRefitEntry entry) {
    global TreeNode* node = nodes + entry.node;
    float cost = costs[entry.node];
    for (int i = 0; i < TREE_WIDTH; ++i) {
        uint child = node->child[i];
        if (child & PRIZMA_LEAF_BIT) // or no child at all
            continue;
        Box box = boxOfNode(nodes + entry.nodeBase + child);
        storeChildBox(node, i, box);
        cost += halfArea(box) + costs[entry.nodeBase + child];
    }
    costs[entry.node] = cost;
}

// One large level; the in-order queue keeps the levels apart.
kernel void refitTreeShader(global TreeNode* nodes, global float* costs, const global DeviceRefitEntry* entries,
                            uint firstEntry, uint entryCount) {
    uint index = get_global_id(0);
    if (index < entryCount)
        refitNode(nodes, costs, entries[firstEntry + index]);
}

// All the small levels near the roots, by one work group. Level i ends before entry levelEnds[i].
kernel void refitSmallLevels(global TreeNode* nodes, global float* costs, const global DeviceRefitEntry* entries,
                             uint firstEntry, const global uint* levelEnds, uint firstLevel, uint levelCount) {
    uint begin = firstEntry;
    for (uint level = firstLevel; level < levelCount; ++level) {
        uint end = levelEnds[level];
        for (uint i = begin + (uint)get_local_id(0); i < end; i += (uint)get_local_size(0))
            refitNode(nodes, costs, entries[i]);
        begin = end;
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}

// Of whole trees: the box (lowX, lowY, lowZ, highX, highY, highZ) and the cost.
kernel void gatherRoots(const global TreeNode* nodes, const global float* costs, const global uint* roots,
                        global float* measures, uint rootCount) {
    uint index = get_global_id(0);
    if (index >= rootCount)
        return;
    Box box = boxOfNode(nodes + roots[index]);
    vstore3(box.low, 0, measures + 7 * index);
    vstore3(box.high, 1, measures + 7 * index);
    measures[7 * index + 6] = costs[roots[index]];
}
