#include "core/render/render_plan.h"
#include "core/scene/diff.h"
#include "tests/support/random_groups.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace prizma;
using namespace prizma::test;

namespace {

std::set<Id> objectsUnder(const Scene& scene, Id group) {
    const Hierarchy hierarchy(scene);
    std::set<Id> ids;
    for (const Object& object : scene.objects)
        if (hierarchy.isWithin(object.parent, group))
            ids.insert(object.id);
    return ids;
}

std::set<Id> asSet(const std::vector<Id>& ids) {
    return {ids.begin(), ids.end()};
}

DeviceState drawn(const Scene& scene) {
    DeviceState state;
    state.scene = scene;
    for (const Object& object : scene.objects) {
        state.resident.insert(object.id);
        if (isPosed(object))
            state.poses[object.id] = poseKeyOf(object, scene.timeline.seconds());
    }
    state.anchor = chooseAnchor(std::nullopt, scene.camera);
    state.width = state.height = 64;
    state.samples = scene.render.samples;
    return state;
}

} // namespace

class TestHierarchy : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void membersGoWhereTheirGroupsPutThem();
    void lightsFollowTheirGroups();
    void circlesAndLostParentsEndSomewhere();
    void movingAGroupMovesItsMembersOnly();
    void aHiddenGroupHidesItsMembers();
    void planOfAMovedGroupIsTheTopLevel();
    void hiddenMembersAreNotPosed();
    void soloSilencesTheOthers();
};

void TestHierarchy::membersGoWhereTheirGroupsPutThem() {
    std::mt19937 random(1);
    for (int run = 0; run < 50; ++run) {
        const Scene scene = randomGroups(random, 10, 20);
        const Scene flat = flattened(scene);
        const Hierarchy hierarchy(scene);
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const glm::dmat4 expected = flat.objects[i].transform.matrix();
            QVERIFY(difference(hierarchy.worldMatrix(scene.objects[i]), expected) < 1e-12);
            QVERIFY(difference(worldMatrix(scene, scene.objects[i]), expected) < 1e-12);
            QCOMPARE(parentOf(scene, {EntityKind::Object, scene.objects[i].id}), scene.objects[i].parent);
        }
        std::size_t members = membersOf(scene, noId).size();
        for (const Group& group : scene.groups)
            members += membersOf(scene, group.id).size();
        QCOMPARE(members, scene.groups.size() + scene.objects.size() + scene.lights.size());
    }
}

void TestHierarchy::lightsFollowTheirGroups() {
    std::mt19937 random(2);
    for (int run = 0; run < 50; ++run) {
        Scene scene = randomGroups(random, 6, 0, 10);
        scene.groups.edit()[0].visible = run % 2 == 0;
        const Scene flat = flattened(scene);
        const std::vector<Light> lights = lightsInWorld(scene);
        QCOMPARE(lights.size(), flat.lights.size());
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const Light& is = lights[i];
            const Light& wanted = flat.lights[i];
            QCOMPARE(is.parent, noId);
            QCOMPARE(is.enabled, wanted.enabled);
            QVERIFY(glm::distance(is.position, wanted.position) < 1e-9 * (1.0 + glm::length(is.position)));
            QVERIFY(glm::distance(is.direction, wanted.direction) < 1e-12);
            QVERIFY(std::abs(is.radius - wanted.radius) < 1e-12 * wanted.radius);
            if (is.type != LightType::Rectangle)
                continue;
            QVERIFY(glm::distance(is.size, wanted.size) < 1e-12 * glm::length(wanted.size));
            for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
                QVERIFY(glm::distance(is.rotation * axis, wanted.rotation * axis) < 1e-9);
        }
    }
    // Under a shear a rectangle stays in its plane and keeps its area, and mirrors do not turn it round.
    Light panel;
    panel.type = LightType::Rectangle;
    panel.size = {2.0, 3.0};
    for (int run = 0; run < 50; ++run) {
        panel.rotation = randomRotation(random);
        Transform squash;
        squash.rotation = randomRotation(random);
        squash.scale = {randomIn(random, 0.5, 2.0), randomIn(random, -2.0, -0.5), randomIn(random, 0.5, 2.0)};
        const glm::dmat3 turn(squash.matrix());
        const Light there = transformed(panel, squash.matrix());
        const glm::dvec3 u = turn * (panel.rotation * glm::dvec3(2, 0, 0));
        const glm::dvec3 v = turn * (panel.rotation * glm::dvec3(0, 0, 3));
        const glm::dvec3 down = there.rotation * glm::dvec3(0, -1, 0);
        QVERIFY(std::abs(there.size.x * there.size.y - glm::length(glm::cross(u, v))) < 1e-9);
        QVERIFY(std::abs(glm::dot(down, u)) < 1e-9 && std::abs(glm::dot(down, v)) < 1e-9);
        QVERIFY(glm::dot(down, turn * (panel.rotation * glm::dvec3(0, -1, 0))) > 0.0);
    }
}

void TestHierarchy::circlesAndLostParentsEndSomewhere() {
    Scene scene;
    const Id a = addGroup(scene, {});
    const Id b = addGroup(scene, {});
    scene.groups.edit()[0].parent = b;
    scene.groups.edit()[1].parent = a;
    Object object;
    object.parent = b;
    object.transform.translation.x = 1.0;
    addObject(scene, object);
    object.parent = 12345;
    addObject(scene, object);
    const Hierarchy hierarchy(scene);
    QCOMPARE(hierarchy.worldMatrix(scene.objects[0])[3].x, 1.0);
    QCOMPARE(hierarchy.worldMatrix(scene.objects[1])[3].x, 1.0);
    QVERIFY(hierarchy.isShown(scene.objects[0]) && hierarchy.isShown(scene.objects[1]));
    QVERIFY(hierarchy.isWithin(a, a));
    QVERIFY(!hierarchy.isWithin(12345, a));
}

void TestHierarchy::movingAGroupMovesItsMembersOnly() {
    std::mt19937 random(3);
    for (int run = 0; run < 30; ++run) {
        const Scene before = randomGroups(random);
        Scene after = before;
        Group& moved = after.groups.edit()[random() % after.groups.size()];
        moved.transform.translation.x += 1.0;
        const SceneDiff changes = diff(before, after);
        QCOMPARE(asSet(changes.objectsMoved), objectsUnder(before, moved.id));
        QVERIFY(changes.objectsShown.empty() && changes.meshesChanged.empty());
        const Hierarchy hierarchy(before);
        QCOMPARE(changes.lights,
                 std::any_of(before.lights.begin(), before.lights.end(),
                             [&](const Light& light) { return hierarchy.isWithin(light.parent, moved.id); }));
        // Another name and another list with equal content are no change.
        Scene named = before;
        named.groups.edit()[0].name = "other";
        QVERIFY(diff(before, named).isEmpty());
    }
}

void TestHierarchy::aHiddenGroupHidesItsMembers() {
    std::mt19937 random(4);
    for (int run = 0; run < 30; ++run) {
        const Scene before = randomGroups(random);
        Scene after = before;
        Group& hidden = after.groups.edit()[random() % after.groups.size()];
        hidden.visible = false;
        const SceneDiff changes = diff(before, after);
        QCOMPARE(asSet(changes.objectsShown), objectsUnder(before, hidden.id));
        QVERIFY(changes.objectsMoved.empty());
        QCOMPARE(diff(after, before).objectsShown, changes.objectsShown);
        for (const Object& object : after.objects)
            QCOMPARE(isShown(after, object), !objectsUnder(before, hidden.id).contains(object.id));
    }
}

void TestHierarchy::planOfAMovedGroupIsTheTopLevel() {
    Scene before;
    const Id material = addMaterial(before, lambert());
    Object inside = primitiveObject(PrimitiveType::Cube, 1.0, material);
    inside.parent = addGroup(before, {});
    addObject(before, inside);
    addObject(before, primitiveObject(PrimitiveType::Sphere, 1.0, material));
    Scene after = before;
    after.groups.edit()[0].transform.translation.x = 1.0;
    const RenderPlan plan = makePlan(drawn(before), after, 64, 64);
    QVERIFY(plan.restarts);
    QVERIFY(plan.find(Stage::TopLevel));
    QCOMPARE(plan.stages.size(), std::size_t{4}); // and the rays, their shading, the display
    QVERIFY(plan.find(Stage::GenerateCameraRays) && plan.find(Stage::RayShader) && plan.find(Stage::Display));

    Scene empty = before;
    empty.objects.edit()[0].parent = noId; // a group of nothing
    Scene moved = empty;
    moved.groups.edit()[0].transform.translation.x = 1.0;
    QVERIFY(makePlan(drawn(empty), moved, 64, 64).isEmpty());
}

void TestHierarchy::hiddenMembersAreNotPosed() {
    Scene before;
    Object object = bendingObject();
    object.parent = addGroup(before, {});
    addObject(before, object);
    before.groups.edit()[0].visible = false;
    Scene after = before;
    after.timeline.frame = 17.0;
    DeviceState nothing;
    for (const DeviceState& held : {drawn(before), nothing}) {
        const RenderPlan plan = makePlan(held, after, 64, 64);
        for (const Stage stage : {Stage::Geometry, Stage::Poses, Stage::VertexShader, Stage::TriangleShader,
                                  Stage::RefitTreeShader})
            QVERIFY(!plan.find(stage));
    }
    QVERIFY(!drawsAnything(after));
    after.groups.edit()[0].visible = true;
    QVERIFY(makePlan(nothing, after, 64, 64).find(Stage::Poses));
}

void TestHierarchy::soloSilencesTheOthers() {
    std::mt19937 random(5);
    Scene scene = randomGroups(random, 3, 0, 5);
    QVERIFY(std::ranges::all_of(lightsInWorld(scene), &Light::enabled));
    Scene after = scene;
    after.lights.edit()[2].solo = true;
    QVERIFY(diff(scene, after).lights);
    const auto lights = lightsInWorld(after);
    for (std::size_t i = 0; i < lights.size(); ++i)
        QCOMPARE(lights[i].enabled, i == 2);
    // One that is off stays off, and still silences the others.
    after.lights.edit()[2].enabled = false;
    QVERIFY(std::ranges::none_of(lightsInWorld(after), &Light::enabled));
}

QTEST_APPLESS_MAIN(TestHierarchy)
#include "tst_hierarchy.moc"
