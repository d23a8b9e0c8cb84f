#include "core/scene/primitives.h"

#include <QTest>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

using namespace prizma;

namespace {

using Point = std::array<float, 3>;

Point pointOf(const Mesh& mesh, std::uint32_t vertex) {
    const glm::vec3& p = mesh.positions[vertex];
    return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
}

/// How often each directed edge occurs, by position.
std::map<std::pair<Point, Point>, int> edgesOf(const Mesh& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            ++edges[{pointOf(mesh, t[i]), pointOf(mesh, t[(i + 1) % 3])}];
    return edges;
}

double volumeOf(const Mesh& mesh) {
    double volume = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += glm::dot(glm::dvec3(mesh.positions[t.x]),
                           glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
                  6.0;
    return volume;
}

} // namespace

class TestPrimitives : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void primitives_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("volume");
        const double pi = std::numbers::pi;
        for (const double size : {0.001, 1.0, 250.0}) {
            const double cube = size * size * size;
            const auto row = [&](const char* name, PrimitiveType type, double volume) {
                QTest::addRow("%s %g", name, size) << static_cast<int>(type) << size << volume * cube;
            };
            row("plane", PrimitiveType::Plane, 0.0);
            row("cube", PrimitiveType::Cube, 1.0);
            row("sphere", PrimitiveType::Sphere, pi / 6.0);
            row("cylinder", PrimitiveType::Cylinder, pi / 4.0);
            row("torus", PrimitiveType::Torus, 2.0 * pi * pi * 0.35 * 0.15 * 0.15);
        }
    }
    void primitives() {
        QFETCH(int, type);
        QFETCH(double, size);
        QFETCH(double, volume);
        const auto kind = static_cast<PrimitiveType>(type);
        const MeshPtr mesh = makePrimitive(kind, size);
        QCOMPARE(findFault(*mesh), std::string());
        QVERIFY(std::abs(glm::length(mesh->bounds.centre())) < 1e-6 * size);
        QVERIFY(std::abs(mesh->bounds.extent().x - size) < 1e-5 * size);
        if (kind == PrimitiveType::Plane)
            QVERIFY(mesh->normals[0] == glm::vec3(0, 1, 0));
        else
            for (const auto& [edge, count] :
                 edgesOf(*mesh)) { // closed: each edge is met once from either side
                QCOMPARE(count, 1);
                QVERIFY(edge.first != edge.second);
            }
        QVERIFY(std::abs(volumeOf(*mesh) - volume) <= 0.01 * volume + 1e-12);
        for (const glm::vec3& normal : mesh->normals)
            QVERIFY(std::abs(glm::length(normal) - 1.0F) < 1e-5F);
        for (const glm::uvec3& t : mesh->triangles) {
            const glm::vec3 face =
                glm::cross((mesh->positions[t.y] - mesh->positions[t.x]) / static_cast<float>(size),
                           (mesh->positions[t.z] - mesh->positions[t.x]) / static_cast<float>(size));
            QVERIFY(glm::length(face) > 0.0F);
            for (int i = 0; i < 3; ++i)
                QVERIFY(glm::dot(glm::normalize(face), mesh->normals[t[i]]) > 0.9F);
        }
        QCOMPARE(mesh->texCoords.size(), mesh->positions.size());
        for (const glm::vec2& uv : mesh->texCoords)
            QVERIFY(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F);
    }

    void edgesHaveTheirOpposites() {
        for (const auto type :
             {PrimitiveType::Cube, PrimitiveType::Sphere, PrimitiveType::Cylinder, PrimitiveType::Torus}) {
            const auto edges = edgesOf(*makePrimitive(type, 2.0));
            for (const auto& [edge, count] : edges)
                QVERIFY(edges.contains({edge.second, edge.first}));
        }
    }

    void equalArgumentsGiveEqualMeshes() {
        const MeshPtr a = makePrimitive(PrimitiveType::Torus, 1.25);
        const MeshPtr b = makePrimitive(PrimitiveType::Torus, 1.25);
        QVERIFY(a->positions == b->positions && a->normals == b->normals && a->triangles == b->triangles);
    }
};

QTEST_GUILESS_MAIN(TestPrimitives)
#include "tst_primitives.moc"
