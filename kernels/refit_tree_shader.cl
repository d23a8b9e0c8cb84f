// RefitTreeShader: new boxes for one level of the trees of all Dynamic objects that moved. Levels run one after the
// other, those next to the leaves first (the in-order queue sees to it), so that children are done before parents.
#include "scene.clh"
#include "math.clh"

#ifdef PRIZMA_WIDE8

inline float lowest(float8 v) {
    float4 a = min(v.lo, v.hi);
    float2 b = min(a.lo, a.hi);
    return min(b.x, b.y);
}

inline float highest(float8 v) {
    float4 a = max(v.lo, v.hi);
    float2 b = max(a.lo, a.hi);
    return max(b.x, b.y);
}

kernel void refitTreeShader(global WideNode* nodes, const global WideLeaf* leaves,
                            const global DeviceRefitEntry* entries, uint firstEntry, uint entryCount) {
    uint index = get_global_id(0);
    if (index >= entryCount)
        return;
    DeviceRefitEntry entry = entries[firstEntry + index];
    global WideNode* node = nodes + entry.nodeBase + entry.node;
    for (int lane = 0; lane < 8; ++lane) {
        uint child = node->child[lane];
        if (child == PRIZMA_NO_CHILD)
            continue;
        for (int axis = 0; axis < 3; ++axis) {
            float low, high;
            if (child & PRIZMA_LEAF_BIT) {
                const global WideLeaf* leaf = leaves + entry.leafBase + (child & ~PRIZMA_LEAF_BIT);
                float8 a = vload8(0, leaf->corner[axis]);
                float8 b = vload8(0, leaf->corner[3 + axis]);
                float8 c = vload8(0, leaf->corner[6 + axis]);
                low = lowest(min(a, min(b, c)));
                high = highest(max(a, max(b, c)));
            } else {
                const global WideNode* inner = nodes + entry.nodeBase + child;
                low = lowest(vload8(0, inner->bounds[2 * axis]));
                high = highest(vload8(0, inner->bounds[2 * axis + 1]));
            }
            node->bounds[2 * axis][lane] = low;
            node->bounds[2 * axis + 1][lane] = high;
        }
    }
}

// The whole tree's box: lowX, lowY, lowZ, highX, highY, highZ.
kernel void gatherRootBounds(const global WideNode* nodes, const global uint* roots, global float* bounds,
                             uint rootCount) {
    uint index = get_global_id(0);
    if (index >= rootCount)
        return;
    const global WideNode* node = nodes + roots[index];
    for (int axis = 0; axis < 3; ++axis) {
        bounds[6 * index + axis] = lowest(vload8(0, node->bounds[2 * axis]));
        bounds[6 * index + 3 + axis] = highest(vload8(0, node->bounds[2 * axis + 1]));
    }
}

#else

typedef struct {
    float3 low, high;
} Box;

inline Box childBox(const global BinaryNode* node, int child) {
    Box box;
    const global float* xy = child == 0 ? node->box0xy : node->box1xy;
    box.low = (float3)(xy[0], xy[2], node->boxesZ[2 * child]);
    box.high = (float3)(xy[1], xy[3], node->boxesZ[2 * child + 1]);
    return box;
}

inline Box leafBox(const global BinaryTriangle* triangles, uint count) {
    Box box;
    box.low = (float3)(INFINITY);
    box.high = (float3)(-INFINITY);
    for (uint i = 0; i < count; ++i) {
        float3 a = loadFloat3(triangles[i].a);
        float3 b = loadFloat3(triangles[i].b);
        float3 c = loadFloat3(triangles[i].c);
        box.low = min(box.low, min(a, min(b, c)));
        box.high = max(box.high, max(a, max(b, c)));
    }
    return box;
}

kernel void refitTreeShader(global BinaryNode* nodes, const global BinaryTriangle* leaves,
                            const global DeviceRefitEntry* entries, uint firstEntry, uint entryCount) {
    uint index = get_global_id(0);
    if (index >= entryCount)
        return;
    DeviceRefitEntry entry = entries[firstEntry + index];
    global BinaryNode* node = nodes + entry.nodeBase + entry.node;
    for (int side = 0; side < 2; ++side) {
        uint child = node->child[side];
        if (child == PRIZMA_NO_CHILD)
            continue;
        Box box;
        if (child & PRIZMA_LEAF_BIT) {
            uint count = ((child & ~PRIZMA_LEAF_BIT) >> PRIZMA_LEAF_COUNT_SHIFT) + 1;
            box = leafBox(leaves + entry.leafBase + (child & PRIZMA_LEAF_FIRST_MASK), count);
        } else {
            const global BinaryNode* inner = nodes + entry.nodeBase + child;
            Box box0 = childBox(inner, 0);
            Box box1 = childBox(inner, 1);
            box.low = min(box0.low, box1.low);
            box.high = max(box0.high, box1.high);
        }
        global float* xy = side == 0 ? node->box0xy : node->box1xy;
        xy[0] = box.low.x;
        xy[1] = box.high.x;
        xy[2] = box.low.y;
        xy[3] = box.high.y;
        node->boxesZ[2 * side] = box.low.z;
        node->boxesZ[2 * side + 1] = box.high.z;
    }
}

kernel void gatherRootBounds(const global BinaryNode* nodes, const global uint* roots, global float* bounds,
                             uint rootCount) {
    uint index = get_global_id(0);
    if (index >= rootCount)
        return;
    Box box0 = childBox(nodes + roots[index], 0);
    Box box1 = childBox(nodes + roots[index], 1);
    vstore3(min(box0.low, box1.low), 2 * index, bounds);
    vstore3(max(box0.high, box1.high), 2 * index + 1, bounds);
}

#endif
