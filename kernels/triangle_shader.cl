// TriangleShader: puts the posed corners of one Dynamic object's triangles into the leaves of its tree.
#include "scene.clh"
#include "math.clh"

// One work item a leaf place: eight a leaf in Wide8, one a triangle in Binary2.
kernel void triangleShader(global TreeLeaf* leaves, uint leafBase, uint placeCount,
                           const global DeviceTriangle* triangles, uint triangleBase, const global float* positions,
                           uint vertexBase) {
    uint place = get_global_id(0);
    if (place >= placeCount)
        return;
#ifdef PRIZMA_WIDE8
    global WideLeaf* leaf = leaves + leafBase + place / 8;
    uint lane = place % 8;
    DeviceTriangle triangle = triangles[triangleBase + leaf->primitive[lane]];
#else
    global BinaryTriangle* leaf = leaves + leafBase + place;
    DeviceTriangle triangle = triangles[triangleBase + leaf->primitive];
#endif
    const global float* a = positions + 3 * (vertexBase + triangle.a);
    const global float* b = positions + 3 * (vertexBase + triangle.b);
    const global float* c = positions + 3 * (vertexBase + triangle.c);
    for (int axis = 0; axis < 3; ++axis) {
#ifdef PRIZMA_WIDE8
        leaf->corner[axis][lane] = a[axis];
        leaf->corner[3 + axis][lane] = b[axis];
        leaf->corner[6 + axis][lane] = c[axis];
#else
        leaf->a[axis] = a[axis];
        leaf->b[axis] = b[axis];
        leaf->c[axis] = c[axis];
#endif
    }
}
