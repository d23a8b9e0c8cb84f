// VertexShader alone: vertices and normals as the device computed them against skinning in double precision
// that shares nothing with core/animation.
#include "core/render/posed_mesh.h"
#include "core/scene/properties.h"
#include "tests/support/test_scenes.h"

#include <QtTest>

#include <algorithm>

using namespace prizma;
using namespace prizma::test;

namespace {

struct MeshOptions {
    int vertices = 500;
    int bones = 20;
    int mostWeights = 4; ///< A vertex; each has from none to this many.
    int morphTargets = 0;
    bool mirrors = false; ///< Some bones scale by negative numbers.
};

class RandomModel {
  public:
    explicit RandomModel(unsigned seed) : random_(seed) {}

    Object make(const MeshOptions& options) {
        Object object;
        object.name = "random";
        object.dynamic = true;
        object.materials = {noId};
        auto mesh = std::make_shared<Mesh>();
        addVertices(*mesh, options);
        if (options.bones > 0) {
            mesh->skeleton = makeSkeleton(options);
            addInfluences(*mesh, options);
            object.clips = {makeClip(options)};
            object.clip = "random";
        }
        addMorphs(*mesh, options);
        updateBounds(*mesh);
        for (const MorphTarget& target : mesh->morphTargets)
            if (random_() % 3 != 0)
                object.morphWeights[target.name] = normal_(random_);
        object.mesh = mesh;
        return object;
    }

  private:
    glm::vec3 vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }
    glm::vec3 direction() { return glm::normalize(vector() + glm::vec3(1e-6f)); }

    BonePose pose(bool mirrors) {
        BonePose bone;
        bone.translation = 0.3f * vector();
        bone.rotation = glm::angleAxis(normal_(random_), direction());
        bone.scale = glm::clamp(glm::vec3(1.0f) + 0.2f * vector(), 0.5f, 1.5f);
        if (mirrors && random_() % 4 == 0)
            bone.scale.y = -bone.scale.y;
        return bone;
    }

    void addVertices(Mesh& mesh, const MeshOptions& options) {
        mesh.slots = {"slot"};
        for (int i = 0; i < options.vertices; ++i) {
            mesh.positions.push_back(vector());
            mesh.normals.push_back(direction());
            mesh.triangles.emplace_back(i, (i + 1) % options.vertices, random_() % options.vertices);
            mesh.triangleSlots.push_back(0);
        }
    }

    SkeletonPtr makeSkeleton(const MeshOptions& options) {
        auto skeleton = std::make_shared<Skeleton>();
        std::vector<glm::dmat4> toObject;
        for (int i = 0; i < options.bones; ++i) {
            Bone bone{"bone", i == 0 ? -1 : static_cast<int>(random_() % i), pose(false), {}};
            const glm::dmat4 local = matrixOf(bone.bind);
            toObject.push_back(bone.parent < 0 ? local
                                               : toObject[static_cast<std::size_t>(bone.parent)] * local);
            bone.inverseBind = glm::mat4(glm::inverse(toObject.back()));
            skeleton->bones.push_back(bone);
        }
        return skeleton;
    }

    void addInfluences(Mesh& mesh, const MeshOptions& options) {
        mesh.firstInfluence = {0};
        for (int i = 0; i < options.vertices; ++i) {
            const int count =
                i == 0 ? options.mostWeights : static_cast<int>(random_() % (options.mostWeights + 1));
            std::vector<float> weights;
            float sum = 0.0f;
            for (int k = 0; k < count; ++k) {
                weights.push_back(0.05f + std::abs(normal_(random_)));
                sum += weights.back();
            }
            for (const float weight : weights)
                mesh.influences.push_back(
                    {static_cast<std::uint32_t>(random_() % options.bones), weight / sum});
            mesh.firstInfluence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
        }
    }

    void addMorphs(Mesh& mesh, const MeshOptions& options) {
        for (int t = 0; t < options.morphTargets; ++t) {
            MorphTarget target;
            target.name = "target " + std::to_string(t);
            for (int i = 0; i < options.vertices; ++i)
                if (random_() % 5 == 0) {
                    target.vertices.push_back(static_cast<std::uint32_t>(i));
                    target.positionOffsets.push_back(0.2f * vector());
                    target.normalOffsets.push_back(0.2f * vector());
                }
            mesh.morphTargets.push_back(std::move(target));
        }
    }

    ClipPtr makeClip(const MeshOptions& options) {
        auto clip = std::make_shared<Clip>();
        clip->name = "random";
        clip->frameCount = 8;
        for (int bone = 0; bone < options.bones; ++bone) {
            BoneTrack track{bone, {}};
            for (int frame = 0; frame < clip->frameCount; ++frame)
                track.frames.push_back(pose(options.mirrors));
            clip->tracks.push_back(std::move(track));
        }
        return clip;
    }

  public:
    static glm::dmat4 matrixOf(const BonePose& bone) {
        const glm::dquat q = glm::normalize(glm::dquat(bone.rotation));
        const glm::dmat3 turn = glm::mat3_cast(q);
        glm::dmat4 matrix(1.0);
        for (int axis = 0; axis < 3; ++axis)
            matrix[axis] = glm::dvec4(turn[axis] * static_cast<double>(bone.scale[axis]), 0.0);
        matrix[3] = glm::dvec4(glm::dvec3(bone.translation), 1.0);
        return matrix;
    }

  private:
    std::mt19937 random_;
    std::normal_distribution<float> normal_;
};

struct Truth {
    std::vector<glm::dvec3> positions, normals;
    std::vector<bool> hasNormal; ///< False where it is too short to have a direction worth comparing.
};

/// The object at a whole frame of its clip.
Truth computeTruth(const Object& object, std::size_t frame) {
    const Mesh& mesh = *object.mesh;
    std::vector<glm::dmat4> skinning;
    if (mesh.skeleton)
        for (std::size_t i = 0; i < mesh.skeleton->bones.size(); ++i) {
            const Bone& bone = mesh.skeleton->bones[i];
            const glm::dmat4 local = RandomModel::matrixOf(object.clips[0]->tracks[i].frames[frame]);
            skinning.push_back(bone.parent < 0 ? local
                                               : skinning[static_cast<std::size_t>(bone.parent)] * local);
        }
    for (std::size_t i = 0; i < skinning.size(); ++i)
        skinning[i] = skinning[i] * glm::dmat4(mesh.skeleton->bones[i].inverseBind);
    Truth truth;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::dvec3 position(mesh.positions[v]);
        glm::dvec3 normal(mesh.normals[v]);
        for (const MorphTarget& target : mesh.morphTargets) {
            const auto weight = object.morphWeights.find(target.name);
            for (std::size_t i = 0; weight != object.morphWeights.end() && i < target.vertices.size(); ++i)
                if (target.vertices[i] == v) {
                    position += weight->second * glm::dvec3(target.positionOffsets[i]);
                    normal += weight->second * glm::dvec3(target.normalOffsets[i]);
                }
        }
        double strength = glm::length(normal);
        if (mesh.isSkinned() && mesh.firstInfluence[v] != mesh.firstInfluence[v + 1]) {
            glm::dmat4 sum(0.0);
            for (auto k = mesh.firstInfluence[v]; k < mesh.firstInfluence[v + 1]; ++k)
                sum += static_cast<double>(mesh.influences[k].weight) * skinning[mesh.influences[k].bone];
            position = glm::dvec3(sum * glm::dvec4(position, 1.0));
            // Blends of opposite rotations can lose a dimension: there is no normal then.
            strength *= std::abs(glm::determinant(glm::dmat3(sum)));
            normal = glm::inverse(glm::transpose(glm::dmat3(sum))) * normal;
        }
        truth.positions.push_back(position);
        truth.normals.push_back(glm::normalize(normal));
        truth.hasNormal.push_back(strength > 0.02);
    }
    return truth;
}

/// The largest errors: of positions as a share of the model's size, of normals as a distance.
std::pair<double, double> errorsOf(const PosedMesh& posed, const Truth& truth) {
    DBounds bounds;
    for (const glm::dvec3& position : truth.positions)
        bounds.add(position);
    double position = 0.0;
    double normal = 0.0;
    for (std::size_t i = 0; i < truth.positions.size(); ++i) {
        position = std::max(position, glm::length(glm::dvec3(posed.positions[i]) - truth.positions[i]));
        if (truth.hasNormal[i])
            normal = std::max(normal, glm::length(glm::dvec3(posed.normals[i]) - truth.normals[i]));
    }
    return {position / glm::length(bounds.extent()), normal};
}

} // namespace

class VertexShaderTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void agreesWithDoublePrecision_data();
    void agreesWithDoublePrecision();
    void manyObjectsAtOnce();
    void morphWeightsChangeAlone();
    void holdFrameIsExact();
    void staticObjectsKeepTheirShape();
    void csvAndObjHoldTheMesh();
};

void VertexShaderTest::agreesWithDoublePrecision_data() {
    QTest::addColumn<int>("bones");
    QTest::addColumn<int>("mostWeights");
    QTest::addColumn<int>("morphTargets");
    QTest::addColumn<bool>("mirrors");
    QTest::addColumn<int>("layout");
    const int wide = static_cast<int>(TreeLayout::Wide8);
    const int binary = static_cast<int>(TreeLayout::Binary2);
    QTest::newRow("one bone a vertex") << 1 << 1 << 0 << false << wide;
    QTest::newRow("up to four weights") << 20 << 4 << 0 << false << wide;
    QTest::newRow("up to 19 weights") << 60 << 19 << 0 << false << wide;
    QTest::newRow("mirroring bones") << 20 << 6 << 0 << true << wide;
    QTest::newRow("morph targets only") << 0 << 0 << 7 << false << wide;
    QTest::newRow("bones and morph targets") << 20 << 9 << 12 << false << wide;
    QTest::newRow("everything, binary tree") << 20 << 9 << 12 << true << binary;
}

void VertexShaderTest::agreesWithDoublePrecision() {
    QFETCH(int, bones);
    QFETCH(int, mostWeights);
    QFETCH(int, morphTargets);
    QFETCH(bool, mirrors);
    QFETCH(int, layout);
    const auto renderer = makeRenderer(static_cast<TreeLayout>(layout));
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    RandomModel model(static_cast<unsigned>(bones * 100 + morphTargets));
    // Full blocks, partly filled ones, and less than one.
    for (const int vertices : {3, 64, 65, 500, 1024}) {
        Scene scene;
        const Id id = addObject(scene, model.make({vertices, bones, mostWeights, morphTargets, mirrors}));
        for (const std::size_t frame : {std::size_t(0), std::size_t(3), std::size_t(7)}) {
            if (bones > 0)
                scene.objects.edit()[0] = *holdFrame(scene.objects[0], "random", static_cast<double>(frame));
            const auto posed = computePosedMesh(*renderer, scene, id);
            QVERIFY2(posed, posed ? "" : posed.error().message.c_str());
            const auto [position, normal] = errorsOf(*posed, computeTruth(scene.objects[0], frame));
            QVERIFY2(position < 1e-6, std::to_string(position).c_str());
            QVERIFY2(normal < 1e-3, std::to_string(normal).c_str());
        }
    }
}

void VertexShaderTest::manyObjectsAtOnce() {
    const auto renderer = makeRenderer();
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene;
    RandomModel model(5);
    const Object shared = model.make({700, 12, 5, 4, false});
    for (int i = 0; i < 40; ++i) {
        Object object = i % 3 == 0   ? shared
                        : i % 3 == 1 ? model.make({50 + 31 * i, 3 + i, 7, i % 4, false})
                                     : model.make({20 + i, 0, 0, 3, false});
        if (object.mesh->isSkinned())
            object = *holdFrame(object, "random", i % 8);
        addObject(scene, object);
    }
    // Some of them move on, again and again: the others stay as they are, and so does all that is shared.
    std::vector<std::size_t> frames;
    for (int i = 0; i < 40; ++i)
        frames.push_back(static_cast<std::size_t>(i % 8));
    std::mt19937 random(6);
    for (int round = 0; round < 6; ++round) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const auto posed = computePosedMesh(*renderer, scene, scene.objects[i].id);
            QVERIFY(posed);
            const auto [position, normal] = errorsOf(*posed, computeTruth(scene.objects[i], frames[i]));
            QVERIFY(position < 1e-6);
            QVERIFY(normal < 1e-3);
        }
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (random() % 4 == 0 && scene.objects[i].mesh->isSkinned()) {
                frames[i] = random() % 8;
                scene.objects.edit()[i] =
                    *holdFrame(scene.objects[i], "random", static_cast<double>(frames[i]));
            }
    }
}

void VertexShaderTest::morphWeightsChangeAlone() {
    const auto renderer = makeRenderer();
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene;
    RandomModel model(9);
    const Id id = addObject(scene, *holdFrame(model.make({300, 8, 4, 3, false}), "random", 2.0));
    addObject(scene, model.make({300, 8, 4, 3, false}));
    for (const double weight : {0.0, 1.0, -0.7, 0.0}) {
        scene.objects.edit()[0].morphWeights.clear();
        QVERIFY(prizma::setProperty(scene, {EntityKind::Object, id}, "morph:target 1", weight));
        const RenderPlan plan = renderer->plan(renderer->drawable(scene), 1, 1);
        if (weight != 0.0)
            QCOMPARE(plan.find(Stage::VertexShader)->objects, std::vector<Id>{id});
        const auto posed = computePosedMesh(*renderer, scene, id);
        QVERIFY(posed);
        const auto [position, normal] = errorsOf(*posed, computeTruth(scene.objects[0], 2));
        QVERIFY(position < 1e-6);
        QVERIFY(normal < 1e-3);
    }
}

void VertexShaderTest::holdFrameIsExact() {
    const Object bender = bendingObject();
    for (int frame = 0; frame < 20; ++frame) {
        const auto held = holdFrame(bender, "bend", frame);
        QVERIFY(held);
        QCOMPARE(poseKeyOf(*held, 123.4).now.frame, static_cast<double>(frame));
    }
    QVERIFY(holdFrame(bender, "bend", 7.25));
    QVERIFY(!holdFrame(bender, "bend", 20.0));
    QVERIFY(!holdFrame(bender, "bend", -1.0));
    QVERIFY(!holdFrame(bender, "bend", std::nan("")));
    QVERIFY(!holdFrame(bender, "walk", 0.0));
    QCOMPARE(poseKeyOf(*holdFrame(bender, "", 5.0), 1.0), PoseKey{});
}

void VertexShaderTest::staticObjectsKeepTheirShape() {
    const auto renderer = makeRenderer();
    if (!renderer)
        QSKIP("There is no OpenCL device here.");
    Scene scene;
    const Id cube = addObject(scene, primitiveObject(PrimitiveType::Cube, 2.0, noId));
    Object still = bendingObject();
    still.dynamic = false;
    const Id bender = addObject(scene, still);
    for (const Id id : {cube, bender}) {
        const auto posed = computePosedMesh(*renderer, scene, id);
        QVERIFY(posed);
        QCOMPARE(posed->positions, scene.findObject(id)->mesh->positions);
        QCOMPARE(posed->normals, scene.findObject(id)->mesh->normals);
    }
    scene.objects.edit()[0].visible = false;
    QVERIFY(!computePosedMesh(*renderer, scene, cube));
    QVERIFY(!computePosedMesh(*renderer, scene, 999));
}

void VertexShaderTest::csvAndObjHoldTheMesh() {
    PosedMesh posed;
    posed.mesh = makePrimitive(PrimitiveType::Cube, 2.0);
    posed.positions = posed.mesh->positions;
    posed.normals = posed.mesh->normals;
    const QStringList rows = QString::fromStdString(formatCsv(posed, glm::dmat4(2.0))).split('\n');
    QCOMPARE(rows.size(), static_cast<qsizetype>(3 * posed.mesh->triangles.size() + 1));
    for (std::size_t i = 0; i < 3 * posed.mesh->triangles.size(); ++i) {
        const auto fields = rows[static_cast<qsizetype>(i)].split(',');
        const glm::vec3 p = posed.positions[posed.mesh->triangles[i / 3][static_cast<int>(i % 3)]];
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(fields[axis].toDouble(), 2.0 * static_cast<double>(p[axis]));
    }
    const QString obj = QString::fromStdString(formatObj(posed, "cube"));
    QCOMPARE(obj.count("\nv "), static_cast<qsizetype>(posed.positions.size()));
    QCOMPARE(obj.count("\nvn "), static_cast<qsizetype>(posed.positions.size()));
    QCOMPARE(obj.count("\nf "), static_cast<qsizetype>(posed.mesh->triangles.size()));
}

QTEST_GUILESS_MAIN(VertexShaderTest)
#include "tst_vertex_shader.moc"
