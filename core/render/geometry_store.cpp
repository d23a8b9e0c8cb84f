#include "core/render/geometry_store.h"

#include "core/bvh/tree_cost.h"
#include "core/render/render_plan.h"

namespace prizma {
namespace {

std::vector<DeviceTriangle> deviceTriangles(const Mesh& mesh) {
    std::vector<DeviceTriangle> triangles(mesh.triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        triangles[i] = {mesh.triangles[i].x, mesh.triangles[i].y, mesh.triangles[i].z, mesh.triangleSlots[i]};
    return triangles;
}

std::span<const float> floats(const std::vector<glm::vec3>& list) {
    return {reinterpret_cast<const float*>(list.data()), list.size() * 3};
}

/// Runs allocations one after the other until one fails.
class Steps {
  public:
    void run(std::uint32_t& place, auto&& allocate) {
        if (!ok_)
            return;
        const Result<std::uint32_t> allocated = allocate();
        if (allocated)
            place = *allocated;
        else
            ok_ = std::unexpected(allocated.error());
    }
    Result<void> result() const { return ok_; }

  private:
    Result<void> ok_;
};

} // namespace

Result<std::uint32_t> GeometryStore::addVertices(Context& context, const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    std::uint32_t first = 0;
    std::uint32_t ignored = 0;
    // The three arenas see the same sequence of requests in vertices, so their places stay in step.
    std::vector<float> texCoords(2 * count, 0.0f);
    for (std::size_t i = 0; i < mesh.texCoords.size(); ++i) {
        texCoords[2 * i] = mesh.texCoords[i].x;
        texCoords[2 * i + 1] = mesh.texCoords[i].y;
    }
    Steps steps;
    steps.run(first, [&] { return positions_.add(context, floats(mesh.positions)); });
    steps.run(ignored, [&] { return normals_.add(context, floats(mesh.normals)); });
    steps.run(ignored, [&] { return texCoords_.add(context, texCoords); });
    if (auto ok = steps.result(); !ok)
        return std::unexpected(ok.error());
    return first / 3;
}

Result<std::uint32_t> GeometryStore::addNodes(Context& context, const DeviceTree& tree) {
    return layout_ == TreeLayout::Wide8 ? wideNodes_.add(context, tree.wideNodes)
                                        : binaryNodes_.add(context, tree.binaryNodes);
}

Result<std::uint32_t> GeometryStore::addLeaves(Context& context, const DeviceTree& tree) {
    return layout_ == TreeLayout::Wide8 ? wideLeaves_.add(context, tree.wideLeaves)
                                        : binaryTriangles_.add(context, tree.binaryTriangles);
}

Result<void> GeometryStore::uploadMesh(Context& context, MeshPlace& place) {
    const Mesh& mesh = *place.mesh;
    Steps steps;
    steps.run(place.vertexBase, [&] { return addVertices(context, mesh); });
    steps.run(place.triangleBase, [&] { return triangles_.add(context, deviceTriangles(mesh)); });
    steps.run(place.nodeBase, [&] { return addNodes(context, *place.tree); });
    steps.run(place.leafBase, [&] { return addLeaves(context, *place.tree); });
    if (auto ok = steps.result(); !ok || !mesh.canBePosed())
        return ok;
    const auto skin = skins_.add(context, mesh);
    if (!skin)
        return std::unexpected(skin.error());
    place.skin = *skin;
    return {};
}

Result<MeshPlace*> GeometryStore::addMesh(Context& context, const MeshPtr& mesh, const DeviceTreePtr& tree) {
    if (const auto found = meshes_.find(mesh.get()); found != meshes_.end())
        return &found->second;
    MeshPlace place;
    place.mesh = mesh;
    place.tree = tree;
    if (auto ok = uploadMesh(context, place); !ok)
        return std::unexpected(ok.error());
    return &meshes_.emplace(mesh.get(), std::move(place)).first->second;
}

Result<void> GeometryStore::addPosed(Context& context, Id object, const MeshPlace& place) {
    PosedPlace posed;
    posed.tree = place.tree;
    posed.bounds = place.mesh->bounds;
    posed.cost = posed.builtCost = treeCost(*place.tree);
    Steps steps;
    steps.run(posed.vertexBase, [&] { return addVertices(context, *place.mesh); });
    if (auto ok = steps.result(); !ok)
        return ok;
    if (auto ok = placeTree(context, posed, *place.tree); !ok)
        return ok;
    posed_.insert_or_assign(object, posed);
    ++posedRevision_;
    return writeTree(context, posed, *place.tree);
}

/// Finds room for a tree and for somewhat larger ones after it.
Result<void> GeometryStore::placeTree(Context& context, PosedPlace& posed, const DeviceTree& tree) {
    const auto withSpare = [](std::size_t count) { return static_cast<std::uint32_t>(count + count / 8); };
    const std::uint32_t nodes = withSpare(nodeCount(tree));
    const std::uint32_t leaves = withSpare(leafCount(tree));
    const bool isWide = layout_ == TreeLayout::Wide8;
    const auto nodeBase =
        isWide ? wideNodes_.allocate(context, nodes) : binaryNodes_.allocate(context, nodes);
    if (!nodeBase)
        return std::unexpected(nodeBase.error());
    const auto leafBase =
        isWide ? wideLeaves_.allocate(context, leaves) : binaryTriangles_.allocate(context, leaves);
    if (!leafBase) {
        releaseTree(*nodeBase, nodes, 0, 0);
        return std::unexpected(leafBase.error());
    }
    posed.nodeBase = *nodeBase;
    posed.nodeRoom = nodes;
    posed.leafBase = *leafBase;
    posed.leafRoom = leaves;
    return {};
}

Result<void> GeometryStore::writeTree(Context& context, const PosedPlace& posed, const DeviceTree& tree) {
    if (layout_ == TreeLayout::Wide8) {
        if (auto ok = wideNodes_.write(context, tree.wideNodes, posed.nodeBase); !ok)
            return ok;
        return wideLeaves_.write(context, tree.wideLeaves, posed.leafBase);
    }
    if (auto ok = binaryNodes_.write(context, tree.binaryNodes, posed.nodeBase); !ok)
        return ok;
    return binaryTriangles_.write(context, tree.binaryTriangles, posed.leafBase);
}

Result<bool> GeometryStore::replaceTree(Context& context, Id object, const DeviceTreePtr& tree) {
    PosedPlace& posed = posed_.at(object);
    if (nodeCount(*tree) > posed.nodeRoom || leafCount(*tree) > posed.leafRoom) {
        PosedPlace larger = posed;
        if (!placeTree(context, larger, *tree))
            return false;
        releaseTree(posed.nodeBase, posed.nodeRoom, posed.leafBase, posed.leafRoom);
        posed = larger;
    }
    posed.tree = tree;
    posed.cost = posed.builtCost = treeCost(*tree);
    ++posedRevision_;
    if (auto ok = writeTree(context, posed, *tree); !ok)
        return std::unexpected(ok.error());
    return true;
}

Result<void> GeometryStore::add(Context& context, const Object& object, const DeviceTreePtr& tree) {
    const auto old = objects_.find(object.id);
    if (old != objects_.end() && old->second->mesh == object.mesh &&
        isPosed(object) == posed_.contains(object.id))
        return {};
    remove(object.id);
    const auto place = addMesh(context, object.mesh, tree);
    if (!place)
        return std::unexpected(place.error());
    ++(*place)->users;
    objects_[object.id] = *place;
    return isPosed(object) ? addPosed(context, object.id, **place) : Result<void>{};
}

void GeometryStore::remove(Id object) {
    const auto found = objects_.find(object);
    if (found == objects_.end())
        return;
    MeshPlace& place = *found->second;
    if (const auto posed = posed_.find(object); posed != posed_.end()) {
        releasePosed(posed->second, place);
        posed_.erase(posed);
        ++posedRevision_;
    }
    objects_.erase(found);
    if (--place.users == 0) {
        releaseMesh(place);
        meshes_.erase(place.mesh.get());
    }
}

void GeometryStore::removeAllBut(const std::set<Id>& objects) {
    std::vector<Id> gone;
    for (const auto& [id, place] : objects_)
        if (!objects.contains(id))
            gone.push_back(id);
    for (const Id id : gone)
        remove(id);
}

void GeometryStore::releaseVertices(std::uint32_t first, std::size_t count) {
    positions_.release(3 * first, 3 * count);
    normals_.release(3 * first, 3 * count);
    texCoords_.release(2 * first, 2 * count);
}

void GeometryStore::releaseTree(std::uint32_t nodeBase, std::size_t nodes, std::uint32_t leafBase,
                                std::size_t leaves) {
    if (layout_ == TreeLayout::Wide8) {
        wideNodes_.release(nodeBase, nodes);
        wideLeaves_.release(leafBase, leaves);
    } else {
        binaryNodes_.release(nodeBase, nodes);
        binaryTriangles_.release(leafBase, leaves);
    }
}

void GeometryStore::releasePosed(const PosedPlace& posed, const MeshPlace& place) {
    releaseVertices(posed.vertexBase, place.mesh->positions.size());
    releaseTree(posed.nodeBase, posed.nodeRoom, posed.leafBase, posed.leafRoom);
}

void GeometryStore::releaseMesh(const MeshPlace& place) {
    releaseVertices(place.vertexBase, place.mesh->positions.size());
    releaseTree(place.nodeBase, nodeCount(*place.tree), place.leafBase, leafCount(*place.tree));
    triangles_.release(place.triangleBase, place.mesh->triangles.size());
    skins_.release(place.skin);
}

ObjectPlace GeometryStore::placeOf(Id object) const {
    const auto found = objects_.find(object);
    if (found == objects_.end())
        return {};
    const auto posed = posed_.find(object);
    return {found->second, posed == posed_.end() ? nullptr : &posed->second};
}

PosedPlace* GeometryStore::posedPlaceOf(Id object) {
    const auto posed = posed_.find(object);
    return posed == posed_.end() ? nullptr : &posed->second;
}

Result<std::vector<glm::vec3>> GeometryStore::readPosedPositions(Context& context, Id object) const {
    const ObjectPlace place = placeOf(object);
    if (!place.posed)
        return failure("The object is not posed on the device.");
    std::vector<glm::vec3> vertices(place.mesh->mesh->positions.size());
    const std::span<float> values(reinterpret_cast<float*>(vertices.data()), 3 * vertices.size());
    if (auto ok = positions().read(context, values, std::size_t{3} * place.posed->vertexBase, "vertices");
        !ok)
        return std::unexpected(ok.error());
    return vertices;
}

Result<ObjectVertices> GeometryStore::readVertices(Context& context, Id object) const {
    const ObjectPlace place = placeOf(object);
    if (!place.mesh)
        return failure("The object is not on the device.");
    const std::size_t first = 3 * (place.posed ? place.posed->vertexBase : place.mesh->vertexBase);
    ObjectVertices vertices;
    const auto read = [&](const Buffer<float>& from, std::vector<glm::vec3>& to) {
        to.resize(place.mesh->mesh->positions.size());
        const std::span<float> values(reinterpret_cast<float*>(to.data()), 3 * to.size());
        return from.read(context, values, first, "vertices");
    };
    if (auto ok = read(positions(), vertices.positions); !ok)
        return std::unexpected(ok.error());
    if (auto ok = read(normals(), vertices.normals); !ok)
        return std::unexpected(ok.error());
    return vertices;
}

Result<void> GeometryStore::ensure(Context& context) {
    Result<void> ok;
    const auto ensureOne = [&](auto& arena) {
        if (ok)
            ok = arena.ensure(context);
    };
    ensureOne(positions_);
    ensureOne(normals_);
    ensureOne(texCoords_);
    ensureOne(triangles_);
    ensureOne(skins_);
    if (layout_ == TreeLayout::Wide8) {
        ensureOne(wideNodes_);
        ensureOne(wideLeaves_);
    } else {
        ensureOne(binaryNodes_);
        ensureOne(binaryTriangles_);
    }
    return ok;
}

std::size_t GeometryStore::nodeCapacity() const {
    return layout_ == TreeLayout::Wide8 ? wideNodes_.buffer().capacity() : binaryNodes_.buffer().capacity();
}

cl_mem GeometryStore::nodes() const {
    return layout_ == TreeLayout::Wide8 ? wideNodes_.buffer().get() : binaryNodes_.buffer().get();
}

cl_mem GeometryStore::leaves() const {
    return layout_ == TreeLayout::Wide8 ? wideLeaves_.buffer().get() : binaryTriangles_.buffer().get();
}

} // namespace prizma
