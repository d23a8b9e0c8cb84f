// TriangleShader: puts the posed corners of Dynamic objects' triangles into the leaves of their trees and, as the
// corners are at hand, the leaves' boxes into the nodes above them.
#include "refit.clh"

#ifdef PRIZMA_WIDE8

// Eight points, one a lane.
typedef struct {
    float8 x, y, z;
} Points8;

inline Points8 gatherPoints(const global float* positions, uint8 vertices) {
    float8 p04 = (float8)(vload3(vertices.s0, positions), 0.0f, vload3(vertices.s4, positions), 0.0f);
    float8 p15 = (float8)(vload3(vertices.s1, positions), 0.0f, vload3(vertices.s5, positions), 0.0f);
    float8 p26 = (float8)(vload3(vertices.s2, positions), 0.0f, vload3(vertices.s6, positions), 0.0f);
    float8 p37 = (float8)(vload3(vertices.s3, positions), 0.0f, vload3(vertices.s7, positions), 0.0f);
    float8 xy01 = (float8)(p04.s0, p15.s0, p04.s1, p15.s1, p04.s4, p15.s4, p04.s5, p15.s5);
    float8 xy23 = (float8)(p26.s0, p37.s0, p26.s1, p37.s1, p26.s4, p37.s4, p26.s5, p37.s5);
    Points8 points;
    points.x = (float8)(xy01.s01, xy23.s01, xy01.s45, xy23.s45);
    points.y = (float8)(xy01.s23, xy23.s23, xy01.s67, xy23.s67);
    points.z = (float8)(p04.s2, p15.s2, p26.s2, p37.s2, p04.s6, p15.s6, p26.s6, p37.s6);
    return points;
}

inline void storePoints(global float (*corner)[8], Points8 points) {
    vstore8(points.x, 0, corner[0]);
    vstore8(points.y, 0, corner[1]);
    vstore8(points.z, 0, corner[2]);
}

inline Box shadeLeaf(global WideLeaf* leaves, uint child, const global DeviceTriangle* triangles,
                     const global float* positions) {
    global WideLeaf* leaf = leaves + (child & ~PRIZMA_LEAF_BIT);
    uint8 p = vload8(0, leaf->primitive);
    const global DeviceTriangle *t0 = triangles + p.s0, *t1 = triangles + p.s1, *t2 = triangles + p.s2,
                                *t3 = triangles + p.s3, *t4 = triangles + p.s4, *t5 = triangles + p.s5,
                                *t6 = triangles + p.s6, *t7 = triangles + p.s7;
    Points8 a = gatherPoints(positions, (uint8)(t0->a, t1->a, t2->a, t3->a, t4->a, t5->a, t6->a, t7->a));
    Points8 b = gatherPoints(positions, (uint8)(t0->b, t1->b, t2->b, t3->b, t4->b, t5->b, t6->b, t7->b));
    Points8 c = gatherPoints(positions, (uint8)(t0->c, t1->c, t2->c, t3->c, t4->c, t5->c, t6->c, t7->c));
    storePoints(leaf->corner, a);
    storePoints(leaf->corner + 3, b);
    storePoints(leaf->corner + 6, c);
    Box box;
    box.low = (float3)(lowest(min(a.x, min(b.x, c.x))), lowest(min(a.y, min(b.y, c.y))),
                       lowest(min(a.z, min(b.z, c.z))));
    box.high = (float3)(highest(max(a.x, max(b.x, c.x))), highest(max(a.y, max(b.y, c.y))),
                        highest(max(a.z, max(b.z, c.z))));
    return box;
}

#else

inline Box shadeLeaf(global BinaryTriangle* leaves, uint child, const global DeviceTriangle* triangles,
                     const global float* positions) {
    Box box;
    box.low = (float3)(INFINITY);
    box.high = (float3)(-INFINITY);
    uint first = child & PRIZMA_LEAF_FIRST_MASK;
    uint end = first + ((child & ~PRIZMA_LEAF_BIT) >> PRIZMA_LEAF_COUNT_SHIFT) + 1;
    for (uint i = first; i < end; ++i) {
        global BinaryTriangle* place = leaves + i;
        const global DeviceTriangle* triangle = triangles + place->primitive;
        float3 a = vload3(triangle->a, positions);
        float3 b = vload3(triangle->b, positions);
        float3 c = vload3(triangle->c, positions);
        vstore3(a, 0, place->a);
        vstore3(b, 0, place->b);
        vstore3(c, 0, place->c);
        box.low = min(box.low, min(a, min(b, c)));
        box.high = max(box.high, max(a, max(b, c)));
    }
    return box;
}

#endif

// One work group a block, one work item a node: in memory, its leaves lie side by side. `costs` (one a node, beside
// `nodes`) gets the area of the leaves' boxes.
kernel void triangleShader(global TreeNode* nodes, global float* costs, const global DeviceTreeBlock* blocks,
                           global TreeLeaf* leaves, const global DeviceTriangle* triangles,
                           const global float* positions) {
    DeviceTreeBlock block = blocks[get_group_id(0)];
    uint index = get_local_id(0);
    if (index >= block.count)
        return;
    global TreeNode* node = nodes + block.node + index;
    float cost = 0.0f;
    for (int i = 0; i < TREE_WIDTH; ++i) {
        uint child = node->child[i];
        if (!(child & PRIZMA_LEAF_BIT) || child == PRIZMA_NO_CHILD)
            continue;
        Box box = shadeLeaf(leaves + block.leafBase, child, triangles + block.triangleBase,
                            positions + 3 * block.vertexBase);
        storeChildBox(node, i, box);
        cost += halfArea(box);
    }
    costs[block.node + index] = cost;
}
