// VertexShader: poses the vertices of Dynamic objects. Morph targets first, then every vertex moves with the weighted
// sum of its bones' matrices, its normal with the inverse transpose of that sum's linear part.
#include "math.clh"
#include "device_types.h"

// Columns of a 4x4 matrix: bind pose to posed object space.
typedef float16 BoneMatrix;

typedef struct {
    float3 position, normal;
} Vertex;

inline Vertex bindVertex(const global DeviceSkinVertex* vertex) {
    float8 v = vload8(0, (const global float*)vertex);
    Vertex result = {v.s012, v.s456};
    return result;
}

inline Vertex morphed(Vertex vertex, const global DeviceMorphOffset* offsets, uint first, uint end,
                      const global float* weights) {
    for (uint i = first; i < end; ++i) {
        float8 offset = vload8(0, (const global float*)(offsets + i));
        float weight = weights[offsets[i].target];
        vertex.position = fma(weight, offset.s012, vertex.position);
        vertex.normal = fma(weight, offset.s456, vertex.normal);
    }
    return vertex;
}

inline BoneMatrix blended(const global DeviceInfluenceQuad* quads, uint first, uint end,
                          const global BoneMatrix* bones) {
    BoneMatrix sum = 0.0f;
    for (uint i = first; i < end; ++i) {
        uint4 bone = vload4(0, quads[i].bone);
        float4 weight = vload4(0, quads[i].weight);
        sum = fma((BoneMatrix)(weight.x), bones[bone.x], sum);
        sum = fma((BoneMatrix)(weight.y), bones[bone.y], sum);
        sum = fma((BoneMatrix)(weight.z), bones[bone.z], sum);
        sum = fma((BoneMatrix)(weight.w), bones[bone.w], sum);
    }
    return sum;
}

inline Vertex skinned(Vertex vertex, BoneMatrix m) {
    float3 p = vertex.position;
    float3 n = vertex.normal;
    vertex.position = fma(m.s012, p.x, fma(m.s456, p.y, fma(m.s89a, p.z, m.scde)));
    // The columns of the inverse transpose are the cross products of the matrix's columns, up to the determinant.
    float3 yz = cross(m.s456, m.s89a);
    float3 zx = cross(m.s89a, m.s012);
    float3 xy = cross(m.s012, m.s456);
    float side = dot(m.s012, yz) < 0.0f ? -1.0f : 1.0f;
    vertex.normal = side * fma(yz, n.x, fma(zx, n.y, xy * n.z));
    return vertex;
}

// One work group a block.
kernel void vertexShader(global float* positions, global float* normals, const global DeviceVertexBlock* blocks,
                         const global DeviceSkinVertex* vertices, const global DeviceInfluenceQuad* quads,
                         const global DeviceMorphOffset* offsets, const global BoneMatrix* bones,
                         const global float* weights) {
    DeviceVertexBlock block = blocks[get_group_id(0)];
    uint i = get_local_id(0);
    if (i < block.count) {
        const global DeviceSkinVertex* source = vertices + block.bindVertex + i;
        Vertex vertex = bindVertex(source);
        float3 bindNormal = vertex.normal;
        if (block.weightBase != PRIZMA_NO_WEIGHTS)
            vertex = morphed(vertex, offsets, source[0].firstOffset, source[1].firstOffset,
                             weights + block.weightBase);
        uint first = source[0].firstQuad;
        uint end = source[1].firstQuad;
        if (first != end)
            vertex = skinned(vertex, blended(quads, first, end, bones + block.boneBase));
        vstore3(vertex.position, block.posedVertex + i, positions);
        vstore3(unitOr(vertex.normal, bindNormal), block.posedVertex + i, normals);
    }
}
