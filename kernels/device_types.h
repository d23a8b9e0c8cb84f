// The structs that kernels and C++ share, byte for byte. Read by both compilers: plain scalars only, no float3,
// and every size is checked below on the C++ side.
#ifndef PRIZMA_DEVICE_TYPES_H
#define PRIZMA_DEVICE_TYPES_H

#ifdef __OPENCL_VERSION__
typedef uint DeviceUint;
typedef int DeviceInt;
#else
#include <cstdint>
namespace prizma {
typedef std::uint32_t DeviceUint;
typedef std::int32_t DeviceInt;
#endif

// A child reference in a tree: an inner node's index, or a leaf (LEAF_BIT set), or no child at all.
#define PRIZMA_LEAF_BIT 0x80000000u
#define PRIZMA_NO_CHILD 0xFFFFFFFFu
// Binary2: LEAF_BIT | (count - 1) << 28 | first triangle.
#define PRIZMA_LEAF_COUNT_SHIFT 28u
#define PRIZMA_LEAF_FIRST_MASK 0x0FFFFFFFu

// No device tree is deeper, which bounds the traversal stack.
#define PRIZMA_MAX_TREE_DEPTH 64

#define PRIZMA_NO_HIT 0xFFFFFFFFu

// Linear values up to here (2^-13) are byte 0 in sRGB.
#define PRIZMA_SRGB_SMALLEST 0.0001220703125f

// Between these (2^-13 and 2^5) the filmic curve goes from black to white.
#define PRIZMA_FILMIC_SMALLEST 0.0001220703125f
#define PRIZMA_FILMIC_LARGEST 32.0f

// Places beside a row of the denoiser's planes: as far as its widest step reads.
#define PRIZMA_DENOISE_MARGIN 32

// Wide8: boxes of eight children as lowX, highX, lowY, highY, lowZ, highZ. A missing child has an inside-out box.
typedef struct {
    float bounds[6][8];
    DeviceUint child[8]; // a leaf child is LEAF_BIT | index of a WideLeaf (top level: of an instance)
} WideNode;

// Wide8: corners A, B, C of eight triangles as Ax[8], Ay[8], Az[8], Bx[8] ... Cz[8]. Places beyond the last triangle
// repeat it.
typedef struct {
    float corner[9][8];
    DeviceUint primitive[8]; // index into the mesh's triangles
} WideLeaf;

// Binary2 (Aila and Laine 2009): both children's boxes in one 64-byte node. A missing child has an inside-out box.
typedef struct {
    float box0xy[4]; // lowX, highX, lowY, highY of child 0
    float box1xy[4]; // the same of child 1
    float boxesZ[4]; // lowZ, highZ of child 0, lowZ, highZ of child 1
    DeviceUint child[2];
    DeviceUint padding[2];
} BinaryNode;

typedef struct {
    float a[3];
    DeviceUint primitive; // index into the mesh's triangles
    float b[3];
    float padding1;
    float c[3];
    float padding2;
} BinaryTriangle;

// World space means: relative to the scene's anchor, a point near the camera.
typedef struct {
    float origin[3];
    float tMin;
    float direction[3];
    float tMax;
} DeviceRay;

// The point is (1 - u - v) A + u B + v C. instance is NO_HIT for a miss; t is then infinite.
typedef struct {
    float t;
    float u;
    float v;
    DeviceUint instance;
    DeviceUint primitive;
} DeviceHit;

// An object placed in the world. Matrices are 3x4, row by row.
typedef struct {
    float worldToObject[12];
    float objectToWorld[12];
    DeviceUint nodeBase;     // first node of its bottom level
    DeviceUint leafBase;     // first leaf (Wide8) or leaf triangle (Binary2)
    DeviceUint vertexBase;   // first vertex in the vertex arrays
    DeviceUint triangleBase; // first DeviceTriangle
    DeviceUint slotBase;     // first of its material slots in the slot table
    DeviceUint hasTexCoords;
    DeviceUint padding[2];
} DeviceInstance;

// A triangle as shading sees it: vertex indices relative to vertexBase, material slot relative to slotBase.
typedef struct {
    DeviceUint a, b, c;
    DeviceUint slot;
} DeviceTriangle;

#define PRIZMA_NO_TEXTURE 0xFFFFFFFFu

#define PRIZMA_ALPHA_BLEND 0u
#define PRIZMA_ALPHA_MASK 1u
#define PRIZMA_ALPHA_OPAQUE 2u

typedef struct {
    float baseColor[3];
    float alpha;
    float emission[3]; // times its strength
    float specular;
    float metallic;
    float roughness;
    float transmission;
    float ior;
    float specularColor[3];
    float normalScale;
    float absorption[3]; // Beer-Lambert coefficients, per unit of length
    float alphaCutoff;
    DeviceUint baseColorTexture; // colour and alpha
    DeviceUint emissionTexture;
    DeviceUint specularTexture;          // alpha
    DeviceUint metallicRoughnessTexture; // data: green is roughness, blue metallic
    DeviceUint transmissionTexture;      // data: red
    DeviceUint normalTexture;            // data
    DeviceUint alphaMode;                // PRIZMA_ALPHA_...
    DeviceUint doubleSided;
} DeviceMaterial;

// A picture inside the texel buffer: 8-bit sRGB RGBA (one uint a texel) or four linear floats a texel. Its mip levels
// follow it in the table.
typedef struct {
    DeviceUint offset; // in 4-byte words
    DeviceInt width;
    DeviceInt height;
    DeviceUint isFloat;
} DeviceTexture;

#define PRIZMA_LIGHT_POINT 0u
#define PRIZMA_LIGHT_SPOT 1u
#define PRIZMA_LIGHT_DIRECTIONAL 2u
#define PRIZMA_LIGHT_RECTANGLE 3u
#define PRIZMA_LIGHT_SPHERE 4u

typedef struct {
    float position[3]; // relative to the anchor
    DeviceUint type;
    float direction[3]; // unit; where it travels (rectangle: its normal)
    float cosInner;
    float strength[3]; // colour times intensity, irradiance or radiance
    float cosOuter;
    float halfU[3]; // rectangle: from the centre to the middle of an edge
    float radius;
    float halfV[3];
    DeviceUint visible; // rectangle, sphere: to the camera
} DeviceLight;

#define PRIZMA_LIGHT_TWO_SIDED 1u // something here shines to both sides
#define PRIZMA_LIGHT_MOVES 2u     // something here is posed: it may be anywhere and shine anywhere
#define PRIZMA_LIGHT_IS_MET 4u    // rays can meet a rectangle or sphere light here

// A node of the tree over the lights and emissive triangles (Conty Estevez and Kulla 2018): where they are and which way
// they shine. Node 0 is the root; the two children of a node are neighbours, the first at an odd place.
typedef struct {
    float low[3];
    DeviceUint child; // the first one; in a leaf LEAF_BIT | emitter: a light, or lightCount + place of a DeviceEmitter
    float high[3];
    float power;   // sum of the greatest radiant intensities
    float axis[3]; // of a cone that holds the normals of all emitters
    float cosCone;
    float cosEmission; // how far from its normal an emitter shines
    DeviceUint parent;
    DeviceUint flags; // PRIZMA_LIGHT_...
    DeviceUint padding;
} DeviceLightNode;

// A triangle that shines.
typedef struct {
    DeviceUint object;    // among those that shine
    DeviceUint primitive; // index into the mesh's triangles
} DeviceEmitter;

#define PRIZMA_CHOICE_BACKGROUND 0xFFFFFFFFu

// A light from outside the scene, which is in no tree: a directional light, or the background.
typedef struct {
    float end; // of its part of [0, 1), which begins where that of the one before ends
    float probability;
    DeviceUint light; // in the light table, or PRIZMA_CHOICE_BACKGROUND
} DeviceFarLight;

// How lights are chosen.
typedef struct {
    DeviceUint nodeCount;    // of the tree
    DeviceUint emitterCount; // emissive triangles
    DeviceUint farCount;
    float farIrradiance; // about what all far lights give together
    DeviceUint environmentWidth; // cells of the background's table; 0: there is none
    DeviceUint environmentHeight;
} DeviceLightSet;

// What one pass looks at: the camera relative to the anchor, the picture, and which of its pixels this launch does.
typedef struct {
    float origin[3];
    float forward[3];   // unit
    float right[3];     // from the picture's middle to its right edge, at distance 1
    float up[3];        // from the middle to the upper edge
    float jitter[2];    // place inside the pixel, [0, 1)
    DeviceInt width;
    DeviceInt height;
    DeviceUint firstPixel; // of this launch; pixels are numbered as pixel_order.clh says
    DeviceUint pixelCount; // of this launch
    DeviceUint sample;     // how many samples the pixels hold already
    DeviceUint seed;
    float lensRadius;
    float focusDistance; // along `forward`
    DeviceUint scattered; // each pixel has a place inside it of its own instead of `jitter`
} DeviceView;

// What RayShader needs to know beside the scene.
typedef struct {
    float background[3]; // radiance, or the factor of the image
    float ambient[3];    // the background's mean radiance
    DeviceUint backgroundTexture;
    float backgroundTurn[2]; // cosine and sine of the image's rotation about +Y
    DeviceInt maxDepth;
    float sceneRadius; // for the depth view
    float fireflyClamp; // 0: none
    DeviceUint transparentShadows;
} DeviceShading;

// A vertex of a mesh that can be posed, in the bind pose. Its lists end where those of the next vertex begin.
typedef struct {
    float position[3];
    DeviceUint firstQuad; // DeviceInfluenceQuad
    float normal[3];
    DeviceUint firstOffset; // DeviceMorphOffset
} DeviceSkinVertex;

// Four bones' influences on a vertex. Places that are left have weight 0.
typedef struct {
    DeviceUint bone[4]; // of the object's
    float weight[4];
} DeviceInfluenceQuad;

// How far a morph target moves a vertex at weight 1.
typedef struct {
    float position[3];
    DeviceUint target;
    float normal[3];
    float padding;
} DeviceMorphOffset;

#define PRIZMA_VERTICES_A_BLOCK 64u
#define PRIZMA_NO_WEIGHTS 0xFFFFFFFFu

// Neighbouring vertices of one object: what a work group of VertexShader does.
typedef struct {
    DeviceUint bindVertex;  // first DeviceSkinVertex
    DeviceUint posedVertex; // first in the vertex arrays
    DeviceUint count;
    DeviceUint boneBase;   // the object's first matrix
    DeviceUint weightBase; // its first morph weight; NO_WEIGHTS if all are 0
} DeviceVertexBlock;

// Neighbouring nodes of one posed object's tree: what a work group of TriangleShader does.
typedef struct {
    DeviceUint node; // the first one
    DeviceUint count;
    DeviceUint leafBase;
    DeviceUint triangleBase;
    DeviceUint vertexBase;
} DeviceTreeBlock;

// A node to refit, and the first node of its tree, which its children count from.
typedef struct {
    DeviceUint node;
    DeviceUint nodeBase;
} DeviceRefitEntry;

// How a ray was traced that record_rays.clh wrote down: in a packet or by itself, to its nearest hit or to any.
#define PRIZMA_RECORDED_PACKET 0u
#define PRIZMA_RECORDED_ANY_PACKET 1u
#define PRIZMA_RECORDED_CLOSEST 2u
#define PRIZMA_RECORDED_ANY 3u

typedef struct {
    DeviceRay ray;
    DeviceUint kind;
} DeviceRecordedRay;

// What a work group of RayShader (or a packet of sixteen pixels) did in one pass. `times` are in ticks of the processor's
// clock, of the few packets that look at it: see packet_work.clh.
typedef struct {
    DeviceUint shadowRays;
    DeviceUint secondaryRays;
    DeviceUint nonFinite; // pixels whose sample was not a number or infinite: counted, and left out of the sum
    DeviceUint times[7];
} DeviceWork;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(WideNode) == 224);
static_assert(sizeof(WideLeaf) == 320);
static_assert(sizeof(BinaryNode) == 64);
static_assert(sizeof(BinaryTriangle) == 48);
static_assert(sizeof(DeviceRay) == 32);
static_assert(sizeof(DeviceHit) == 20);
static_assert(sizeof(DeviceInstance) == 128);
static_assert(sizeof(DeviceTriangle) == 16);
static_assert(sizeof(DeviceMaterial) == 112);
static_assert(sizeof(DeviceTexture) == 16);
static_assert(sizeof(DeviceLight) == 80);
static_assert(sizeof(DeviceLightNode) == 64);
static_assert(sizeof(DeviceEmitter) == 8);
static_assert(sizeof(DeviceFarLight) == 12);
static_assert(sizeof(DeviceLightSet) == 24);
static_assert(sizeof(DeviceView) == 92);
static_assert(sizeof(DeviceShading) == 52);
static_assert(sizeof(DeviceSkinVertex) == 32);
static_assert(sizeof(DeviceInfluenceQuad) == 32);
static_assert(sizeof(DeviceMorphOffset) == 32);
static_assert(sizeof(DeviceVertexBlock) == 20);
static_assert(sizeof(DeviceTreeBlock) == 20);
static_assert(sizeof(DeviceRefitEntry) == 8);
static_assert(sizeof(DeviceWork) == 40);
static_assert(sizeof(DeviceRecordedRay) == 36);
} // namespace prizma
#endif

#endif
