// Hit by hit: the kernels against the reference tracer in double precision.
#include "core/animation/posed_bounds.h"
#include "core/import/model_importer.h"
#include "core/reference/reference_tracer.h"
#include "core/render/ray_query.h"
#include "core/scene/primitives.h"

#include <QtTest>

#include <cmath>
#include <filesystem>
#include <random>

using namespace prizma;

namespace {

/// A hit this close to an edge, as a share of the triangle's longest one, can go to either side in single
/// precision.
constexpr double clearOfEdges = 1e-5;

std::filesystem::path assets() {
    const char* folder = std::getenv("PRIZMA_ASSETS");
    return folder != nullptr ? std::filesystem::path(folder)
                             : std::filesystem::path(PRIZMA_SOURCE_DIR) / ".." / "shared" / "assets";
}

Object objectOf(MeshPtr mesh, const Transform& transform = {}) {
    Object object;
    object.name = "object";
    object.mesh = std::move(mesh);
    object.transform = transform;
    return object;
}

MeshPtr soupMesh() {
    std::mt19937 random(71);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    auto mesh = std::make_shared<Mesh>();
    mesh->slots = {"soup"};
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const glm::vec3 a{place(random), place(random), place(random)};
        const float size = i % 10 == 0 ? 0.8f : 0.08f;
        for (int corner = 0; corner < 3; ++corner) {
            mesh->positions.push_back(a + size * glm::vec3(place(random), place(random), place(random)));
            mesh->normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
        mesh->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        mesh->triangleSlots.push_back(0);
    }
    updateBounds(*mesh);
    return mesh;
}

/// A scene by name; without objects if a model file is absent.
Scene makeScene(const QString& name) {
    Scene scene;
    if (name == "soup") {
        addObject(scene, objectOf(soupMesh()));
    } else if (name == "torus") {
        addObject(scene, objectOf(makePrimitive(PrimitiveType::Torus, 2.0)));
    } else if (name == "sphere") {
        addObject(scene, objectOf(makePrimitive(PrimitiveType::Sphere, 2.0)));
    } else if (name == "instances") {
        const MeshPtr meshes[] = {makePrimitive(PrimitiveType::Torus, 1.0), soupMesh(),
                                  makePrimitive(PrimitiveType::Cube, 1.0),
                                  makePrimitive(PrimitiveType::Sphere, 1.0)};
        for (int i = 0; i < 24; ++i) {
            Transform transform;
            transform.translation = {1.5 * (i % 4) - 2.0, 1.3 * (i / 4 % 3) - 1.0, 1.7 * (i / 12) + 10.0};
            transform.rotation = rotationFromEulerDegrees({17.0 * i, -31.0 * i, 59.0 * i});
            transform.scale = {0.3 + 0.05 * i, i % 5 == 0 ? -0.7 : 0.7, 1.1 - 0.03 * i};
            Object object = objectOf(meshes[i % 4], transform);
            object.visible = i % 7 != 3; // instances are counted without the hidden ones
            addObject(scene, object);
        }
    } else {
        const auto file = assets() / "obj" / name.toStdString();
        if (!std::filesystem::exists(file))
            return scene;
        Progress progress;
        const auto model = importModel(file.string(), {}, progress);
        if (model)
            addModel(scene, *model, {});
    }
    return scene;
}

DeviceRay makeRay(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::vec3 o(origin);
    const glm::vec3 d(direction);
    return {{o.x, o.y, o.z}, 0.0f, {d.x, d.y, d.z}, std::numeric_limits<float>::infinity()};
}

/// Rays from all around towards random places in the scene's box, rays from inside, and a picture's camera
/// rays.
std::vector<DeviceRay> makeRays(const Scene& scene, const glm::dvec3& anchor) {
    const DBounds bounds = worldBounds(scene);
    const double radius = glm::length(bounds.extent());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    const auto inside = [&] {
        return bounds.low + bounds.extent() * glm::dvec3(unit(random), unit(random), unit(random));
    };
    std::vector<DeviceRay> rays;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 outward = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const glm::dvec3 origin = i % 4 == 0 ? inside() : bounds.centre() + outward * radius;
        rays.push_back(makeRay(origin - anchor, inside() - origin));
    }
    Camera camera;
    camera.position = bounds.centre() + glm::dvec3(0.4, 0.3, 1.0) * radius;
    camera.target = bounds.centre();
    const CameraFrame frame = frameOf(camera);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            rays.push_back(
                makeRay(camera.position - anchor,
                        frame.forward + frame.right * ((x - 64) / 150.0) + frame.up * ((y - 64) / 150.0)));
    return rays;
}

reference::Ray exactRay(const DeviceRay& ray, const glm::dvec3& anchor) {
    reference::Ray exact;
    for (int axis = 0; axis < 3; ++axis) {
        exact.origin[axis] = anchor[axis] + double(ray.origin[axis]);
        exact.direction[axis] = double(ray.direction[axis]);
    }
    return exact;
}

/// Compares hits with what the reference says and counts what differs.
class Comparison {
  public:
    Comparison(const Scene& scene, const glm::dvec3& anchor)
        : scene_(scene), anchor_(anchor), tracer_(scene) {
        for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
            if (scene.objects[i].visible && scene.objects[i].mesh)
                objectOf_.push_back(i);
        const DBounds bounds = worldBounds(scene);
        size_ = glm::length(bounds.extent()) + glm::length(bounds.centre() - anchor);
    }

    void add(const DeviceRay& deviceRay, const DeviceHit& hit, bool anyHit) {
        const reference::Ray ray = exactRay(deviceRay, anchor_);
        const auto exact = tracer_.closestHit(ray);
        ++rays;
        hits += exact ? 1 : 0;
        const bool isHit = !std::isinf(hit.t);
        if (std::isnan(hit.t) || (isHit && !anyHit && hit.instance >= objectOf_.size())) {
            note("not a hit at all", hit);
            return;
        }
        if (!isHit) { // a miss is a fault if the reference hits something clearly
            if (exact && isClear(ray, *exact))
                note("lost", hit, &*exact);
            return;
        }
        if (anyHit) {
            if (!exact && !passesNearAnEdge(ray))
                note("found where nothing is", hit);
            return;
        }
        checkClosest(ray, hit, exact ? &*exact : nullptr);
    }

    int rays = 0, hits = 0, faults = 0;
    double largestError = 0.0; ///< Of t, as a share of what single precision allows.
    QString first;

  private:
    /// How far t may be off: the error of a point, seen along the ray under its angle to the triangle.
    double tolerance(const reference::Ray& ray, const reference::Hit& hit) const {
        const double length = glm::length(ray.direction);
        const double cosine = std::abs(glm::dot(normalOf(hit), ray.direction)) / length;
        const double place = 32.0 * 6e-8 * (size_ + hit.t * length);
        return place / (length * std::max(cosine, 1e-6));
    }

    glm::dvec3 normalOf(const reference::Hit& hit) const {
        const Object& object = scene_.objects[hit.object];
        const glm::dmat4 matrix = object.transform.matrix();
        const glm::uvec3 t = object.mesh->triangles[hit.primitive];
        glm::dvec3 c[3];
        for (int i = 0; i < 3; ++i)
            c[i] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(object.mesh->positions[t[i]]), 1.0));
        return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
    }

    /// Edge-on triangles are in doubt as well: there an error across the ray moves the hit far along the
    /// triangle.
    bool isClear(const reference::Ray& ray, const reference::Hit& hit) const {
        const double cosine = std::abs(glm::dot(normalOf(hit), ray.direction)) / glm::length(ray.direction);
        return hit.edgeDistance > clearOfEdges / std::max(cosine, 1e-6);
    }

    /// Whether a ray that misses would hit something if it were a little elsewhere.
    bool passesNearAnEdge(reference::Ray ray) const {
        const glm::dvec3 origin = ray.origin;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 side{(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                                  (i & 4) != 0 ? 1.0 : -1.0};
            ray.origin = origin + side * (1e-5 * size_);
            if (tracer_.occluded(ray))
                return true;
        }
        return false;
    }

    void checkClosest(const reference::Ray& ray, const DeviceHit& hit, const reference::Hit* exact) {
        const auto claimed = tracer_.intersectTriangle(ray, objectOf_[hit.instance], hit.primitive);
        if (!claimed || (claimed->edgeDistance < 0.0 && isClear(ray, outside(*claimed)))) {
            note("claims a triangle that the ray clearly misses", hit, exact);
            return;
        }
        const double allowed = tolerance(ray, *claimed);
        const double error = std::abs(double(hit.t) - claimed->t) / allowed;
        largestError = std::max(largestError, error);
        if (error > 1.0)
            note("wrong distance", hit, &*claimed);
        const glm::dvec2 weights = glm::dvec2(hit.u, hit.v) - glm::dvec2(claimed->u, claimed->v);
        if (isClear(ray, *claimed) && glm::length(weights) > 0.02)
            note("wrong weights", hit, &*claimed);
        // Something clearly nearer was passed over. At equal distance either triangle is right.
        if (exact && isClear(ray, *exact) && claimed->t > exact->t + allowed + tolerance(ray, *exact))
            note("not the nearest", hit, exact);
    }

    static reference::Hit outside(reference::Hit hit) {
        hit.edgeDistance = -hit.edgeDistance;
        return hit;
    }

    void note(const char* what, const DeviceHit& hit, const reference::Hit* exact = nullptr) {
        ++faults;
        if (first.isEmpty())
            first =
                QString(
                    "%1: t %2 u %3 v %4 instance %5 primitive %6, exact t %7 primitive %8 edge distance %9")
                    .arg(what)
                    .arg(double(hit.t), 0, 'g', 9)
                    .arg(double(hit.u))
                    .arg(double(hit.v))
                    .arg(hit.instance)
                    .arg(hit.primitive)
                    .arg(exact ? exact->t : -1.0, 0, 'g', 9)
                    .arg(exact ? int(exact->primitive) : -1)
                    .arg(exact ? exact->edgeDistance : 0.0);
    }

    const Scene& scene_;
    glm::dvec3 anchor_;
    reference::Tracer tracer_;
    std::vector<std::uint32_t> objectOf_; ///< By instance.
    double size_ = 0.0;
};

} // namespace

class TestKernelHits : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void agreesWithTheReference_data();
    void agreesWithTheReference();
};

void TestKernelHits::agreesWithTheReference_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("layout");
    for (const char* name : {"soup", "torus", "sphere", "instances", "common/spot.obj", "common/teapot.obj",
                             "cornell/CornellBox-Original.obj"})
        for (const TreeLayout layout : {TreeLayout::Wide8, TreeLayout::Binary2})
            QTest::addRow("%s, %s", name, layout == TreeLayout::Wide8 ? "8-wide" : "binary")
                << QString(name) << static_cast<int>(layout);
}

void TestKernelHits::agreesWithTheReference() {
    QFETCH(QString, name);
    QFETCH(int, layout);
    const Scene scene = makeScene(name);
    if (scene.objects.empty() && name.endsWith(".obj"))
        QSKIP("the model is absent; PRIZMA_ASSETS names the folder of test models");
    auto query = RayQuery::create(scene, {}, static_cast<TreeLayout>(layout));
    QVERIFY2(query.has_value(), query ? "" : query.error().message.c_str());
    const std::vector<DeviceRay> rays = makeRays(scene, query->origin());
    QVERIFY(query->setRays(rays).has_value());
    for (const RayQueryMode mode :
         {RayQueryMode::Closest, RayQueryMode::ClosestPacket, RayQueryMode::Any, RayQueryMode::AnyPacket}) {
        QVERIFY(query->trace(mode).has_value());
        const auto hits = query->hits();
        QVERIFY(hits.has_value());
        QCOMPARE(hits->size(), rays.size());
        Comparison comparison(scene, query->origin());
        for (std::size_t i = 0; i < rays.size(); ++i)
            comparison.add(rays[i], (*hits)[i], isOcclusion(mode));
        QVERIFY2(comparison.faults == 0, qPrintable(QString("mode %1: %2 of %3 rays, the first: %4")
                                                        .arg(int(mode))
                                                        .arg(comparison.faults)
                                                        .arg(comparison.rays)
                                                        .arg(comparison.first)));
        QVERIFY(comparison.hits > comparison.rays / 20);
    }
}

QTEST_GUILESS_MAIN(TestKernelHits)
#include "tst_kernel_hits.moc"
