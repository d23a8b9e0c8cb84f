#pragma once

#include "core/bvh/tree_store.h"
#include "core/compute/arena.h"
#include "core/render/skin_store.h"
#include "core/scene/object.h"

#include <map>
#include <set>

namespace prizma {

/// Where a mesh lies in the device's buffers.
struct MeshPlace {
    MeshPtr mesh;
    DeviceTreePtr tree;
    std::uint32_t vertexBase = 0, triangleBase = 0, nodeBase = 0, leafBase = 0;
    SkinPlace skin; ///< Of a mesh that can be posed.
    int users = 0;
};

/// A Dynamic object's own copy of what moves: posed vertices, leaves and nodes.
struct PosedPlace {
    DeviceTreePtr tree;
    std::uint32_t vertexBase = 0, nodeBase = 0, leafBase = 0;
    std::uint32_t nodeRoom = 0, leafRoom = 0; ///< A tree of the same triangles takes a little more or less.
    Bounds bounds;                            ///< Object space, of the pose it is in.
    double cost = 0.0;                        ///< Of the tree in that pose, as treeCost says.
    double builtCost = 0.0;                   ///< In the pose that it was built for.

    /// By how much refitting has made the tree worse: 1 is as good as built.
    double wear() const { return builtCost > 0.0 ? cost / builtCost : 1.0; }
};

/// An object's vertices, in object space.
struct ObjectVertices {
    std::vector<glm::vec3> positions, normals;
};

/// What an instance refers to.
struct ObjectPlace {
    const MeshPlace* mesh = nullptr;
    const PosedPlace* posed = nullptr; ///< Null unless the object is posed on the device.
};

/// All meshes and bottom-level trees on the device. Objects with the same mesh share it; a posed object has a
/// copy of what moves, beside the shared bind pose.
class GeometryStore {
  public:
    explicit GeometryStore(TreeLayout layout) : layout_(layout) {}

    /// Puts an object's geometry on the device, replacing what it had. `tree` belongs to the object's mesh.
    Result<void> add(Context& context, const Object& object, const DeviceTreePtr& tree);
    void remove(Id object);
    void removeAllBut(const std::set<Id>& objects);

    /// Gives a posed object another tree over its triangles. Its boxes and corners are to be brought to the
    /// vertices after this. False: there is no room for it, the old one stays.
    Result<bool> replaceTree(Context& context, Id object, const DeviceTreePtr& tree);

    ObjectPlace placeOf(Id object) const;
    PosedPlace* posedPlaceOf(Id object);
    const std::map<Id, PosedPlace>& posedPlaces() const { return posed_; }

    /// The vertices of an object's pose; waits for the device. Errors: the object is not posed.
    Result<std::vector<glm::vec3>> readPosedPositions(Context& context, Id object) const;

    /// The vertices of an object as they are on the device, in its pose if it is posed; waits for the device.
    /// Errors: its geometry is not there.
    Result<ObjectVertices> readVertices(Context& context, Id object) const;

    /// Buffers exist even without geometry, so that kernels can be given them.
    Result<void> ensure(Context& context);

    const Buffer<float>& positions() const { return positions_.buffer(); } ///< Three floats a vertex.
    const Buffer<float>& normals() const { return normals_.buffer(); }
    const Buffer<float>& texCoords() const { return texCoords_.buffer(); } ///< Two floats a vertex.
    const Buffer<DeviceTriangle>& triangles() const { return triangles_.buffer(); }
    const SkinStore& skins() const { return skins_; }
    cl_mem nodes() const;
    cl_mem leaves() const;
    std::size_t nodeCapacity() const; ///< Nodes that the buffer has room for.

    /// Changes whenever a posed place comes, goes or moves.
    std::uint64_t posedRevision() const { return posedRevision_; }

  private:
    Result<MeshPlace*> addMesh(Context& context, const MeshPtr& mesh, const DeviceTreePtr& tree);
    Result<void> uploadMesh(Context& context, MeshPlace& place);
    Result<void> addPosed(Context& context, Id object, const MeshPlace& place);
    void releaseMesh(const MeshPlace& place);
    void releasePosed(const PosedPlace& posed, const MeshPlace& place);
    void releaseVertices(std::uint32_t first, std::size_t count);
    void releaseTree(std::uint32_t nodeBase, std::size_t nodes, std::uint32_t leafBase, std::size_t leaves);
    Result<void> placeTree(Context& context, PosedPlace& posed, const DeviceTree& tree);
    Result<void> writeTree(Context& context, const PosedPlace& posed, const DeviceTree& tree);

    /// Vertices in step: positions, normals and texture coordinates of a vertex have the same number.
    Result<std::uint32_t> addVertices(Context& context, const Mesh& mesh);
    Result<std::uint32_t> addNodes(Context& context, const DeviceTree& tree);
    Result<std::uint32_t> addLeaves(Context& context, const DeviceTree& tree);

    const TreeLayout layout_;
    Arena<float> positions_{"vertices"};
    Arena<float> normals_{"normals"};
    Arena<float> texCoords_{"texture coordinates"};
    Arena<DeviceTriangle> triangles_{"triangles"};
    SkinStore skins_;
    Arena<WideNode> wideNodes_{"tree"};
    Arena<WideLeaf> wideLeaves_{"tree's leaves"};
    Arena<BinaryNode> binaryNodes_{"tree"};
    Arena<BinaryTriangle> binaryTriangles_{"tree's leaves"};

    std::map<const Mesh*, MeshPlace> meshes_;
    std::map<Id, MeshPlace*> objects_;
    std::map<Id, PosedPlace> posed_;
    std::uint64_t posedRevision_ = 0;
};

} // namespace prizma
