#include "core/reference/reference_tracer.h"
#include "core/reference/thesis_triangle.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace prizma;
using reference::Ray;
using reference::Tracer;

namespace {

using Real = long double;
using RealVector = glm::vec<3, Real>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Object soup(std::size_t triangles, unsigned seed, float edgeLength) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const glm::vec3 a{place(random), place(random), place(random)};
        for (int corner = 0; corner < 3; ++corner)
            mesh->positions.push_back(a +
                                      edgeLength * glm::vec3(place(random), place(random), place(random)));
        mesh->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    updateBounds(*mesh);
    Object object;
    object.mesh = mesh;
    return object;
}

struct BruteHit {
    Real t = std::numeric_limits<Real>::infinity();
    Real second = std::numeric_limits<Real>::infinity(); ///< The next hit behind it.
    std::uint32_t object = 0, primitive = 0;
    Real u = 0, v = 0;
    Real closeness = 1; ///< How near any triangle's edge came to deciding otherwise.
};

/// Every triangle, in long double, by signed volumes: another formula than the tracer's.
BruteHit bruteForce(const Scene& scene, const Ray& ray) {
    BruteHit best;
    const RealVector origin(ray.origin);
    const RealVector direction(ray.direction);
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const Object& object = scene.objects[o];
        if (!object.visible || !object.mesh)
            continue;
        const glm::dmat4 matrix = object.transform.matrix();
        for (std::uint32_t p = 0; p < object.mesh->triangles.size(); ++p) {
            RealVector c[3];
            for (int i = 0; i < 3; ++i)
                c[i] =
                    RealVector(glm::dvec3(
                        matrix *
                        glm::dvec4(glm::dvec3(object.mesh->positions[object.mesh->triangles[p][i]]), 1.0))) -
                    origin;
            const Real a = glm::dot(direction, glm::cross(c[1], c[2]));
            const Real b = glm::dot(direction, glm::cross(c[2], c[0]));
            const Real d = glm::dot(direction, glm::cross(c[0], c[1]));
            const Real sum = a + b + d;
            if (sum == 0)
                continue;
            const Real lowest = std::min({a / sum, b / sum, d / sum});
            const RealVector point = (a * c[0] + b * c[1] + d * c[2]) / sum;
            const Real t = glm::dot(point, direction) / glm::dot(direction, direction);
            if (t < Real(ray.tMin) || t > Real(ray.tMax))
                continue;
            best.closeness = std::min(best.closeness, std::abs(lowest));
            if (lowest < 0)
                continue;
            if (t < best.t) {
                best.second = best.t;
                best = {t, best.second, o, p, b / sum, d / sum, best.closeness};
            } else {
                best.second = std::min(best.second, t);
            }
        }
    }
    return best;
}

Ray randomRay(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> place(-size, size);
    std::uniform_real_distribution<double> target(-0.7, 0.7);
    Ray ray;
    ray.origin = {place(random), place(random), place(random)};
    ray.direction = glm::dvec3(target(random), target(random), target(random)) - ray.origin;
    return ray;
}

} // namespace

class TestReferenceTracer : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void agreesWithBruteForce_data();
    void agreesWithBruteForce();
    void measuresEdgeDistance();
    void judgesOneTriangle();
    void staysWithinTheRange();
    void ignoresWhatHasNoArea();
    void ignoresRaysThatAreNotFinite();
    void skipsHiddenObjects();
    void copesWithDeepScenes();
    void thesisTestAgreesOnOrdinaryHits();
    void thesisTestLosesSmallTriangles();
};

void TestReferenceTracer::agreesWithBruteForce_data() {
    QTest::addColumn<int>("triangles");
    QTest::addColumn<float>("edge");
    QTest::newRow("one") << 1 << 1.0f;
    QTest::newRow("a few large ones") << 20 << 1.0f;
    QTest::newRow("many") << 1500 << 0.1f;
    QTest::newRow("many slivers of all sizes") << 800 << 0.6f;
}

void TestReferenceTracer::agreesWithBruteForce() {
    QFETCH(int, triangles);
    QFETCH(float, edge);
    Scene scene;
    addObject(scene, soup(static_cast<std::size_t>(triangles), 3, edge));
    Object turned = soup(static_cast<std::size_t>(triangles), 4, edge);
    turned.transform.rotation = rotationFromEulerDegrees({20, 50, -70});
    turned.transform.scale = {0.5, -2.0, 1.5};
    turned.transform.translation = {0.1, 0.2, 0.3};
    addObject(scene, turned);
    const Tracer tracer(scene);
    std::mt19937 random(99);
    int hits = 0, decided = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray = randomRay(random, 3.0);
        const BruteHit expected = bruteForce(scene, ray);
        // Leaves out what no double can decide: edges, and hits at the same place.
        if (expected.closeness < 1e-10L || expected.second - expected.t < 1e-10L)
            continue;
        ++decided;
        const auto found = tracer.closestHit(ray);
        QCOMPARE(found.has_value(), std::isfinite(expected.t));
        QCOMPARE(tracer.occluded(ray), std::isfinite(expected.t));
        if (!found)
            continue;
        ++hits;
        QCOMPARE(found->object, expected.object);
        QCOMPARE(found->primitive, expected.primitive);
        QVERIFY(std::abs(found->t - static_cast<double>(expected.t)) < 1e-10);
        QVERIFY(std::abs(found->u - static_cast<double>(expected.u)) < 1e-8);
        QVERIFY(std::abs(found->v - static_cast<double>(expected.v)) < 1e-8);
        QVERIFY(found->edgeDistance > 0.0);
    }
    QVERIFY(decided > 390);
    QVERIFY(hits > (triangles > 1 ? 50 : 5));
}

void TestReferenceTracer::measuresEdgeDistance() {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{0, 0, 0}, {8, 0, 0}, {0, 4, 0}};
    mesh->triangles = {{0, 1, 2}};
    Scene scene;
    Object object;
    object.mesh = mesh;
    addObject(scene, object);
    const Tracer tracer(scene);
    const double longest = std::sqrt(80.0);
    const auto at = [&](double x, double y) {
        return tracer.intersectTriangle({{x, y, 5}, {0, 0, -1}}, 0, 0)->edgeDistance * longest;
    };
    const auto fromHypotenuse = [](double x, double y) { return (8.0 - x - 2.0 * y) / std::sqrt(5.0); };
    QVERIFY(std::abs(at(4.0, 0.25) - 0.25) < 1e-12);
    QVERIFY(std::abs(at(0.5, 1.5) - 0.5) < 1e-12);
    QVERIFY(std::abs(at(4.0, 1.9) - fromHypotenuse(4.0, 1.9)) < 1e-12);
    QVERIFY(std::abs(at(4.0, -0.25) + 0.25) < 1e-12); // outside
    QVERIFY(std::abs(at(6.0, 6.0) - fromHypotenuse(6.0, 6.0)) < 1e-12);
}

void TestReferenceTracer::judgesOneTriangle() {
    Scene scene;
    addObject(scene, soup(300, 5, 0.3f));
    addObject(scene, Object{}); // no mesh
    addObject(scene, soup(300, 6, 0.3f));
    const Tracer tracer(scene);
    std::mt19937 random(7);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray = randomRay(random, 2.0);
        const auto closest = tracer.closestHit(ray);
        if (!closest)
            continue;
        ++hits;
        const auto same = tracer.intersectTriangle(ray, closest->object, closest->primitive);
        QVERIFY(same.has_value());
        QCOMPARE(same->t, closest->t);
        QCOMPARE(same->object, closest->object);
        QCOMPARE(same->primitive, closest->primitive);
    }
    QVERIFY(hits > 50);
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    QVERIFY(!tracer.intersectTriangle(ray, 0, 300).has_value());
    QVERIFY(!tracer.intersectTriangle(ray, 1, 0).has_value());
    QVERIFY(!tracer.intersectTriangle(ray, 3, 0).has_value());
}

void TestReferenceTracer::staysWithinTheRange() {
    auto mesh = std::make_shared<Mesh>();
    for (const float z : {0.0f, -1.0f, -2.0f}) {
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        mesh->positions.insert(mesh->positions.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
        mesh->triangles.emplace_back(first, first + 1, first + 2);
    }
    Scene scene;
    Object object;
    object.mesh = mesh;
    addObject(scene, object);
    const Tracer tracer(scene);
    const auto primitive = [&](double tMin, double tMax) {
        const auto hit = tracer.closestHit({{0, 0, 1}, {0, 0, -1}, tMin, tMax});
        return hit ? static_cast<int>(hit->primitive) : -1;
    };
    QCOMPARE(primitive(0, 10), 0);
    QCOMPARE(primitive(1.5, 10), 1);
    QCOMPARE(primitive(2.5, 10), 2);
    QCOMPARE(primitive(0, 0.5), -1);
    QCOMPARE(primitive(1.25, 1.75), -1);
    QCOMPARE(primitive(3.5, 10), -1);
    QVERIFY(!tracer.occluded({{0, 0, 1}, {0, 0, -1}, 1.25, 1.75}));
}

void TestReferenceTracer::ignoresWhatHasNoArea() {
    auto mesh = std::make_shared<Mesh>();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {nan, 0, 0}, {0, 1, 0}};
    mesh->triangles = {{0, 0, 0}, {0, 1, 2}, {0, 1, 1}, {0, 1, 3}, {3, 3, 3}, {0, 1, 4}};
    Scene scene;
    Object object;
    object.mesh = mesh;
    addObject(scene, object);
    const Tracer tracer(scene);
    for (const double x : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0}) {
        const auto hit = tracer.closestHit({{x, 0.0, 3}, {0, 0, -1}});
        QCOMPARE(hit.has_value(), x <= 1.0);
        if (hit)
            QCOMPARE(hit->primitive, 5u);
    }
    for (std::uint32_t i = 0; i < 5; ++i)
        QVERIFY(!tracer.intersectTriangle({{0.5, 0.0, 3}, {0, 0, -1}}, 0, i).has_value());
}

void TestReferenceTracer::ignoresRaysThatAreNotFinite() {
    Scene scene;
    addObject(scene, soup(100, 8, 1.0f));
    const Tracer tracer(scene);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
        for (int i = 0; i < 6; ++i) {
            Ray ray{{0.1, 0.2, 0.3}, {0.3, 0.2, -1.0}};
            (i < 3 ? ray.origin : ray.direction)[i % 3] = bad;
            QVERIFY(!tracer.closestHit(ray).has_value());
            QVERIFY(!tracer.occluded(ray));
        }
    QVERIFY(!tracer.closestHit({{0, 0, 0}, {0, 0, 0}}).has_value());
    QVERIFY(!Tracer(Scene{}).closestHit({{0, 0, 0}, {0, 0, -1}}).has_value());
}

void TestReferenceTracer::skipsHiddenObjects() {
    Scene scene;
    Object hidden = soup(200, 9, 1.0f);
    hidden.visible = false;
    addObject(scene, hidden);
    addObject(scene, soup(200, 10, 1.0f));
    const Tracer tracer(scene);
    std::mt19937 random(11);
    int hits = 0;
    for (int i = 0; i < 200; ++i)
        if (const auto hit = tracer.closestHit(randomRay(random, 3.0))) {
            QCOMPARE(hit->object, 1u);
            ++hits;
        }
    QVERIFY(hits > 100);
}

void TestReferenceTracer::copesWithDeepScenes() {
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t i = 0; i < 3000;
         ++i) { // positions that grow exponentially make halving by place useless
        const float x = std::pow(1.05f, static_cast<float>(i % 1500));
        mesh->positions.insert(mesh->positions.end(), {{x, -1, -1}, {x, 1, -1}, {x, 0, 1}});
        mesh->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    Scene scene;
    Object object;
    object.mesh = mesh;
    addObject(scene, object);
    const Tracer tracer(scene);
    for (int i = 0; i < 1500; i += 7) {
        const double x = static_cast<double>(mesh->positions[3 * static_cast<std::size_t>(i)].x);
        const auto hit = tracer.closestHit({{x * 0.999, 0, 0}, {1, 0, 0}});
        QVERIFY(hit.has_value());
        QCOMPARE(hit->primitive % 1500, static_cast<std::uint32_t>(i));
    }
}

void TestReferenceTracer::thesisTestAgreesOnOrdinaryHits() {
    Scene scene;
    addObject(scene, soup(500, 12, 1.0f));
    const Tracer tracer(scene);
    const Mesh& mesh = *scene.objects[0].mesh;
    std::mt19937 random(13);
    std::uniform_int_distribution<std::uint32_t> pick(0, 499);
    int agreed = 0, compared = 0;
    for (int i = 0; i < 5000; ++i) {
        Ray ray = randomRay(random, 3.0);
        ray.direction = glm::normalize(ray.direction);
        const std::uint32_t triangle = pick(random);
        const glm::uvec3 t = mesh.triangles[triangle];
        const auto exact = tracer.intersectTriangle(ray, 0, triangle);
        if (!exact || exact->t < 0.01 || std::abs(exact->edgeDistance) < 1e-3)
            continue;
        const auto thesis =
            reference::intersectAsInThesis(glm::vec3(ray.origin), glm::vec3(ray.direction),
                                           mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
        ++compared;
        agreed += thesis.has_value() == (exact->edgeDistance > 0.0) ? 1 : 0;
        if (thesis && exact->edgeDistance > 0.0) {
            QVERIFY(std::abs(double(thesis->t) - exact->t) < 0.02);
            QVERIFY(std::abs(double(thesis->u + thesis->v + thesis->w) - 1.0) < 2e-4);
        }
    }
    QVERIFY(compared > 2000);
    QVERIFY2(agreed >= compared * 0.99, qPrintable(QString("%1 of %2").arg(agreed).arg(compared)));
}

void TestReferenceTracer::thesisTestLosesSmallTriangles() {
    // The same scene a ten-thousandth as large: the absolute epsilons take hold.
    Scene scene;
    Object object = soup(1, 14, 1.0f);
    const Mesh& mesh = *object.mesh;
    object.transform.scale = glm::dvec3(1e-4);
    addObject(scene, object);
    const Tracer tracer(scene);
    const auto corner = [&](int i) { return glm::vec3(glm::dvec3(mesh.positions[i]) * 1e-4); };
    const glm::dvec3 middle = (glm::dvec3(corner(0)) + glm::dvec3(corner(1)) + glm::dvec3(corner(2))) / 3.0;
    const glm::dvec3 normal =
        glm::normalize(glm::cross(glm::dvec3(corner(1) - corner(0)), glm::dvec3(corner(2) - corner(0))));
    const Ray ray{middle + normal * 3e-4, -normal};
    QVERIFY(tracer.closestHit(ray).has_value());
    QVERIFY(!reference::intersectAsInThesis(glm::vec3(ray.origin), glm::vec3(ray.direction), corner(0),
                                            corner(1), corner(2))
                 .has_value());
}

QTEST_GUILESS_MAIN(TestReferenceTracer)
#include "tst_reference_tracer.moc"
