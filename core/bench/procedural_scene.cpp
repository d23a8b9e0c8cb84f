#include "core/bench/procedural_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace prizma::bench {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t thingCount = 9;
constexpr double columnsARow = 300.0 / 149.0; ///< Of each thing's grid.

/// A thing's grid of quadrilaterals, two triangles each.
struct Grid {
    std::uint32_t columns = 1, rows = 1;
};

Grid gridFor(std::size_t sceneTriangles) {
    const double quads = static_cast<double>(sceneTriangles) / (2.0 * thingCount);
    const double columns = std::max(3.0, std::round(std::sqrt(quads * columnsARow)));
    const double rows = std::max(2.0, std::round(quads / columns));
    return {static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows)};
}

/// A surface over [0, 1] x [0, 1].
using Surface = std::function<glm::dvec3(double u, double v)>;

/// Layers of waves, each finer and fainter: bumps of all sizes.
double bumps(const glm::dvec3& p, double frequency, int layers) {
    double sum = 0.0;
    double strength = 1.0;
    for (int i = 0; i < layers; ++i) {
        const glm::dvec3 q = p * frequency + glm::dvec3(1.7, 4.1, 2.3) * static_cast<double>(i);
        sum += strength * std::sin(q.x + std::sin(q.y)) * std::sin(q.y + std::sin(q.z)) * std::cos(q.z);
        frequency *= 2.1;
        strength *= 0.45;
    }
    return sum;
}

glm::dvec3 spherePoint(double u, double v) {
    const double azimuth = 2.0 * pi * u;
    const double polar = pi * v;
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

glm::dvec3 boulder(double u, double v) {
    const glm::dvec3 p = spherePoint(u, v);
    return p * (0.85 + 0.14 * bumps(p, 2.3, 5));
}

/// A sphere that waves of its own height fold into petals.
glm::dvec3 coral(double u, double v) {
    const glm::dvec3 p = spherePoint(u, v);
    const double petals = std::sin(11.0 * 2.0 * pi * u + 3.0 * std::sin(4.0 * pi * v)) * std::sin(pi * v);
    return p * (0.7 + 0.2 * petals + 0.08 * bumps(p, 5.0, 3));
}

/// A tube along a (2, 3) torus knot.
glm::dvec3 knot(double u, double v) {
    const auto curve = [](double s) {
        const double a = 2.0 * pi * s;
        const double radius = 0.6 + 0.22 * std::cos(3.0 * a);
        return glm::dvec3(radius * std::cos(2.0 * a), 0.28 * std::sin(3.0 * a), radius * std::sin(2.0 * a));
    };
    const glm::dvec3 centre = curve(u);
    const glm::dvec3 along = glm::normalize(curve(u + 1e-4) - curve(u - 1e-4));
    const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(side, along);
    const glm::dvec3 around = side * std::cos(2.0 * pi * v) + up * std::sin(2.0 * pi * v);
    return centre + around * (0.13 + 0.03 * bumps(centre * 2.0 + around, 4.0, 3));
}

std::shared_ptr<Mesh> emptyMesh() {
    auto mesh = std::make_shared<Mesh>();
    mesh->slots = {"surface"};
    return mesh;
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangleSlots.push_back(0);
}

/// Normals from the triangles about each vertex, weighted by area.
void finish(Mesh& mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 normal =
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        for (int i = 0; i < 3; ++i)
            mesh.normals[t[i]] += normal;
    }
    for (glm::vec3& normal : mesh.normals) {
        const float length = glm::length(normal);
        normal = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    updateBounds(mesh);
}

MeshPtr gridMesh(const Surface& surface, const Grid& grid) {
    auto mesh = emptyMesh();
    for (std::uint32_t row = 0; row <= grid.rows; ++row)
        for (std::uint32_t column = 0; column <= grid.columns; ++column)
            mesh->positions.emplace_back(surface(column / double(grid.columns), row / double(grid.rows)));
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const std::uint32_t a = row * (grid.columns + 1) + column;
            const std::uint32_t b = a + grid.columns + 1;
            addTriangle(*mesh, a, a + 1, b);
            addTriangle(*mesh, a + 1, b + 1, b);
        }
    finish(*mesh);
    return mesh;
}

/// Six walls that face inwards, from -halfSize to halfSize, standing on y = 0.
MeshPtr roomMesh(const glm::vec3& halfSize) {
    auto mesh = emptyMesh();
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const int next = (axis + 1) % 3;
            const int last = (axis + 2) % 3;
            const auto first = static_cast<std::uint32_t>(mesh->positions.size());
            for (const auto& [s, t] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                glm::vec3 corner;
                corner[axis] = side * halfSize[axis];
                corner[next] = s * halfSize[next];
                corner[last] = t * halfSize[last];
                mesh->positions.push_back(corner + glm::vec3(0.0f, halfSize.y, 0.0f));
            }
            if (side < 0.0f) { // the order of the corners decides which side a wall faces
                addTriangle(*mesh, first, first + 1, first + 2);
                addTriangle(*mesh, first, first + 2, first + 3);
            } else {
                addTriangle(*mesh, first, first + 2, first + 1);
                addTriangle(*mesh, first, first + 3, first + 2);
            }
        }
    finish(*mesh);
    return mesh;
}

void append(Mesh& mesh, const Object& object) {
    const glm::dmat4 matrix = object.transform.matrix();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& position : object.mesh->positions)
        mesh.positions.emplace_back(matrix * glm::dvec4(glm::dvec3(position), 1.0));
    for (const glm::uvec3& t : object.mesh->triangles)
        addTriangle(mesh, first + t.x, first + t.y, first + t.z);
}

Object placed(const std::string& name, const MeshPtr& mesh, const Transform& transform, Id material) {
    Object object;
    object.name = name;
    object.mesh = mesh;
    object.transform = transform;
    object.materials = {material};
    return object;
}

} // namespace

Scene makeProceduralScene(ProceduralForm form, std::size_t triangles) {
    const Grid grid = gridFor(triangles);
    Scene scene;
    Material surface;
    surface.name = "surface";
    const Id material = addMaterial(scene, surface);
    std::vector<Object> objects{placed("room", roomMesh({5.0f, 2.0f, 4.0f}), {}, material)};
    const std::pair<const char*, MeshPtr> things[] = {{"boulder", gridMesh(boulder, grid)},
                                                      {"coral", gridMesh(coral, grid)},
                                                      {"knot", gridMesh(knot, grid)}};
    for (int i = 0; i < static_cast<int>(thingCount); ++i) {
        const auto& [name, mesh] = things[i % 3];
        Transform transform;
        transform.translation = {2.6 * (i % 3 - 1) + 0.4 * (i / 3 - 1), 0.9 + 0.35 * (i / 3),
                                 1.2 - 1.7 * (i / 3)};
        transform.rotation = rotationFromEulerDegrees({17.0 * i, 41.0 * i, 23.0 * i});
        transform.scale = glm::dvec3(0.85 + 0.05 * i);
        objects.push_back(placed(name, mesh, transform, material));
    }
    if (form == ProceduralForm::Instances) {
        for (const Object& object : objects)
            addObject(scene, object);
    } else {
        auto merged = emptyMesh();
        for (const Object& object : objects)
            append(*merged, object);
        finish(*merged);
        addObject(scene, placed("room with nine things", merged, {}, material));
    }
    scene.camera.position = {0.0, 2.1, 3.8};
    scene.camera.target = {0.0, 1.2, 0.0};
    scene.camera.fovY = 60.0;
    return scene;
}

} // namespace prizma::bench
