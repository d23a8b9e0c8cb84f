// VertexShader: poses the vertices of one Dynamic object: every vertex moves with the weighted sum of its bones'
// matrices, its normal with the inverse transpose of that sum's linear part.
#include "math.clh"
#include "device_types.h"

// Row by row 3x4, bind pose to posed object space. `bindBase` is the mesh's first vertex, `posedBase` the object's.
kernel void vertexShader(global float* positions, global float* normals, uint bindBase, uint posedBase,
                         uint vertexCount, const global uint* firstInfluence, uint firstInfluenceBase,
                         const global DeviceInfluence* influences, uint influenceBase, const global float* bones) {
    uint vertexIndex = get_global_id(0);
    if (vertexIndex >= vertexCount)
        return;
    float3 position = loadFloat3(positions + 3 * (bindBase + vertexIndex));
    float3 normal = loadFloat3(normals + 3 * (bindBase + vertexIndex));
    uint first = firstInfluence[firstInfluenceBase + vertexIndex];
    uint last = firstInfluence[firstInfluenceBase + vertexIndex + 1];
    if (first != last) {
        float4 row0 = 0.0f, row1 = 0.0f, row2 = 0.0f;
        for (uint i = first; i < last; ++i) {
            DeviceInfluence influence = influences[influenceBase + i];
            const global float* bone = bones + 12 * influence.bone;
            row0 += influence.weight * vload4(0, bone);
            row1 += influence.weight * vload4(1, bone);
            row2 += influence.weight * vload4(2, bone);
        }
        float4 p = (float4)(position, 1.0f);
        position = (float3)(dot(row0, p), dot(row1, p), dot(row2, p));
        // The rows of the inverse transpose are the cross products of the matrix's rows, up to the determinant.
        float3 c0 = cross(row1.xyz, row2.xyz);
        float3 c1 = cross(row2.xyz, row0.xyz);
        float3 c2 = cross(row0.xyz, row1.xyz);
        float side = dot(row0.xyz, c0) < 0.0f ? -1.0f : 1.0f;
        normal = unitOr(side * (float3)(dot(c0, normal), dot(c1, normal), dot(c2, normal)), normal);
    }
    vstore3(position, posedBase + vertexIndex, positions);
    vstore3(normal, posedBase + vertexIndex, normals);
}
