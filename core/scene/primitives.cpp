#include "core/scene/primitives.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace prizma {
namespace {

constexpr int turnSegments = 96; ///< Around the axis of everything round.
constexpr int arcSegments = 48;  ///< From pole to pole, or around a torus' tube.

/// Cosine and sine of `step` of `steps` in a full turn; the last step is exactly the first, so that seams
/// close.
glm::vec2 onCircle(int step, int steps) {
    const double angle = 2.0 * std::numbers::pi * (step % steps) / steps;
    return {std::cos(angle), std::sin(angle)};
}

float fraction(int step, int steps) {
    return static_cast<float>(step) / static_cast<float>(steps);
}

std::uint32_t addVertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal,
                        const glm::vec2& texCoord) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.texCoords.push_back(texCoord);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// A flat square with corners centre ± u ± v that faces `cross(u, v)`.
void addSquare(Mesh& mesh, const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v) {
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const std::uint32_t first = addVertex(mesh, centre - u - v, normal, {0, 0});
    addVertex(mesh, centre + u - v, normal, {1, 0});
    addVertex(mesh, centre + u + v, normal, {1, 1});
    addVertex(mesh, centre - u + v, normal, {0, 1});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

struct SurfacePoint {
    glm::vec3 position, normal;
};

/// A grid of (columns + 1) × (rows + 1) vertices; `surface` gives the point of a column and row. Columns run
/// counter-clockwise about the outside's normal when rows run upwards. Quads that shrink to an edge at the
/// first or last row (`poles`) become one triangle.
void addGrid(Mesh& mesh, int columns, int rows, bool poles,
             const std::function<SurfacePoint(int, int)>& surface) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const SurfacePoint point = surface(column, row);
            addVertex(mesh, point.position, point.normal, {fraction(column, columns), fraction(row, rows)});
        }
    const auto width = static_cast<std::uint32_t>(columns + 1);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a =
                first + static_cast<std::uint32_t>(row) * width + static_cast<std::uint32_t>(column);
            if (!poles || row > 0)
                mesh.triangles.push_back({a, a + 1, a + width + 1});
            if (!poles || row + 1 < rows)
                mesh.triangles.push_back({a, a + width + 1, a + width});
        }
}

void makePlane(Mesh& mesh, float half) {
    addSquare(mesh, {0, 0, 0}, {half, 0, 0}, {0, 0, -half});
}

void makeCube(Mesh& mesh, float half) {
    const glm::vec3 x{half, 0, 0};
    const glm::vec3 y{0, half, 0};
    const glm::vec3 z{0, 0, half};
    addSquare(mesh, z, x, y);
    addSquare(mesh, -z, -x, y);
    addSquare(mesh, x, -z, y);
    addSquare(mesh, -x, z, y);
    addSquare(mesh, y, x, -z);
    addSquare(mesh, -y, x, z);
}

void makeSphere(Mesh& mesh, float radius) {
    addGrid(mesh, turnSegments, arcSegments, true, [radius](int column, int row) {
        const glm::vec2 around = onCircle(column, turnSegments);
        // Poles exactly on the axis, or the fan of triangles there would leave a hole.
        const bool pole = row == 0 || row == arcSegments;
        const double latitude = std::numbers::pi * (static_cast<double>(row) / arcSegments - 0.5);
        const auto ring = pole ? 0.0F : static_cast<float>(std::cos(latitude));
        const glm::vec3 normal{ring * around.x, static_cast<float>(std::sin(latitude)), -ring * around.y};
        return SurfacePoint{normal * radius, normal};
    });
}

void addDisc(Mesh& mesh, float radius, float height, bool up) {
    const glm::vec3 normal{0, up ? 1 : -1, 0};
    const std::uint32_t centre = addVertex(mesh, {0, height, 0}, normal, {0.5F, 0.5F});
    for (int step = 0; step <= turnSegments; ++step) {
        const glm::vec2 p = onCircle(step, turnSegments);
        addVertex(mesh, {radius * p.x, height, -radius * p.y}, normal,
                  {0.5F + 0.5F * p.x, 0.5F + 0.5F * p.y});
    }
    for (std::uint32_t step = 1; step <= turnSegments; ++step) {
        const std::uint32_t a = centre + step;
        mesh.triangles.push_back(up ? glm::uvec3(centre, a, a + 1) : glm::uvec3(centre, a + 1, a));
    }
}

void makeCylinder(Mesh& mesh, float radius) {
    addGrid(mesh, turnSegments, 1, false, [radius](int column, int row) {
        const glm::vec2 around = onCircle(column, turnSegments);
        const glm::vec3 normal{around.x, 0, -around.y};
        return SurfacePoint{{radius * around.x, row == 0 ? -radius : radius, -radius * around.y}, normal};
    });
    addDisc(mesh, radius, radius, true);
    addDisc(mesh, radius, -radius, false);
}

void makeTorus(Mesh& mesh, float radius) {
    const float tube = radius * 0.3F;
    const float ring = radius - tube;
    addGrid(mesh, turnSegments, arcSegments, false, [ring, tube](int column, int row) {
        const glm::vec2 around = onCircle(column, turnSegments);
        const glm::vec2 across = onCircle(row, arcSegments);
        const glm::vec3 outwards{around.x, 0, -around.y};
        const glm::vec3 normal = outwards * across.x + glm::vec3(0, across.y, 0);
        return SurfacePoint{outwards * ring + normal * tube, normal};
    });
}

} // namespace

MeshPtr makePrimitive(PrimitiveType type, double size) {
    auto mesh = std::make_shared<Mesh>();
    const auto half = static_cast<float>(size * 0.5);
    switch (type) {
    case PrimitiveType::Plane:
        makePlane(*mesh, half);
        break;
    case PrimitiveType::Cube:
        makeCube(*mesh, half);
        break;
    case PrimitiveType::Sphere:
        makeSphere(*mesh, half);
        break;
    case PrimitiveType::Cylinder:
        makeCylinder(*mesh, half);
        break;
    case PrimitiveType::Torus:
        makeTorus(*mesh, half);
        break;
    }
    mesh->slots = {"surface"};
    mesh->triangleSlots.assign(mesh->triangles.size(), 0);
    updateBounds(*mesh);
    return mesh;
}

} // namespace prizma
