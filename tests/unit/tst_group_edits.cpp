#include "core/scene/edits.h"
#include "core/scene/group_edits.h"
#include "tests/support/random_groups.h"

#include <QtTest>

#include <algorithm>
#include <map>

using namespace prizma;
using namespace prizma::test;

namespace {

/// Where everything is that one can see.
struct Places {
    explicit Places(const Scene& scene) {
        const Hierarchy hierarchy(scene);
        for (const Object& object : scene.objects) {
            matrices[object.id] = hierarchy.worldMatrix(object);
            shown[object.id] = hierarchy.isShown(object);
        }
        for (const Light& light : lightsInWorld(scene)) {
            const glm::dmat3 turn = glm::mat3_cast(glm::normalize(light.rotation));
            glm::dmat4 place(turn);
            place[3] = glm::dvec4(light.position, light.radius);
            if (light.type == LightType::Rectangle)
                matrices[light.id] = place;
            shown[light.id] = light.enabled;
            directions[light.id] = light.direction;
            positions[light.id] = light.position;
        }
    }

    double distanceTo(const Places& other) const {
        double most = matrices.size() == other.matrices.size() && shown == other.shown ? 0.0 : 1e300;
        for (const auto& [id, matrix] : matrices)
            most = std::max(most,
                            other.matrices.contains(id) ? difference(matrix, other.matrices.at(id)) : 1e300);
        for (const auto& [id, direction] : directions)
            most = std::max({most, glm::distance(direction, other.directions.at(id)),
                             glm::distance(positions.at(id), other.positions.at(id)) /
                                 (1.0 + glm::length(positions.at(id)))});
        return most;
    }

    std::map<Id, glm::dmat4> matrices;
    std::map<Id, bool> shown;
    std::map<Id, glm::dvec3> directions, positions;
};

std::vector<EntityRef> someOf(std::vector<EntityRef> all, std::mt19937& random) {
    std::shuffle(all.begin(), all.end(), random);
    all.resize(1 + random() % std::min<std::size_t>(all.size(), 5));
    return all;
}

} // namespace

class TestGroupEdits : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void transformsComeBackFromTheirMatrices();
    void reparentingKeepsPlaces();
    void groupsCannotBePutIntoThemselves();
    void groupingAndUngroupingKeepPlaces();
    void ungroupingAHiddenGroupKeepsItsMembersHidden();
    void deletingAGroupDeletesItsMembers();
    void duplicatingAGroupCopiesWhatIsInIt();
    void namesAreUnique();
};

void TestGroupEdits::transformsComeBackFromTheirMatrices() {
    std::mt19937 random(1);
    for (int run = 0; run < 300; ++run) {
        Transform transform = randomSimilarity(random);
        for (int i = 0; i < 3; ++i)
            transform.scale[i] = randomIn(random, -3.0, 3.0);
        if (run % 5 == 0)
            transform.scale[run % 3] = 0.0;
        if (run % 25 == 0)
            transform.scale[(run + 1) % 3] = 0.0;
        const Transform back = transformOf(transform.matrix());
        QVERIFY(difference(back.matrix(), transform.matrix()) < 1e-12);
        QVERIFY(std::abs(glm::length(back.rotation) - 1.0) < 1e-12);
    }
    QVERIFY(difference(transformOf(glm::dmat4(0.0)).matrix(), Transform{{}, {1, 0, 0, 0}, {}}.matrix()) ==
            0.0);
}

void TestGroupEdits::reparentingKeepsPlaces() {
    std::mt19937 random(2);
    for (int run = 0; run < 200; ++run) {
        Scene scene = randomGroups(random);
        const Places before(scene);
        const auto moved = someOf(allThatHangs(scene), random);
        const auto pick = random() % (scene.groups.size() + 1);
        const Id target = pick == scene.groups.size() ? noId : scene.groups[pick].id;
        const Scene untouched = scene;
        if (!reparent(scene, moved, target)) {
            QVERIFY(scene == untouched);
            continue;
        }
        QVERIFY(before.distanceTo(Places(scene)) < 1e-9);
        for (const EntityRef& entity : topmost(untouched, moved))
            QCOMPARE(parentOf(scene, entity), target);
    }
}

void TestGroupEdits::groupsCannotBePutIntoThemselves() {
    Scene scene;
    Group group;
    const Id outer = addGroup(scene, group);
    group.parent = outer;
    const Id inner = addGroup(scene, group);
    const std::vector<EntityRef> moved{{EntityKind::Group, outer}};
    const Scene before = scene;
    QVERIFY(!reparent(scene, moved, inner));
    QVERIFY(!reparent(scene, moved, outer));
    QVERIFY(!reparent(scene, moved, 999));
    QVERIFY(scene == before);
    QVERIFY(reparent(scene, std::vector<EntityRef>{{EntityKind::Group, inner}}, noId));
    QVERIFY(reparent(scene, moved, inner));
    QCOMPARE(findGroup(scene, outer)->parent, inner);
}

void TestGroupEdits::groupingAndUngroupingKeepPlaces() {
    std::mt19937 random(3);
    for (int run = 0; run < 100; ++run) {
        Scene scene = randomGroups(random);
        const Places before(scene);
        const auto chosen = someOf(allThatHangs(scene), random);
        const auto members = topmost(scene, chosen);
        const Id id = groupEntities(scene, chosen);
        QVERIFY(id != noId);
        QVERIFY(before.distanceTo(Places(scene)) < 1e-9);
        QCOMPARE(membersOf(scene, id).size(), members.size());
        const std::size_t groups = scene.groups.size();
        const auto freed = ungroupEntities(scene, std::vector<EntityRef>{{EntityKind::Group, id}});
        QCOMPARE(freed.size(), members.size());
        QCOMPARE(scene.groups.size(), groups - 1);
        QVERIFY(before.distanceTo(Places(scene)) < 1e-9);
    }
    // Those that have a parent in common stay under it, and the group's origin is in their middle.
    Scene scene;
    Group outer;
    outer.transform.translation = {10.0, 0.0, 0.0};
    const Id outerId = addGroup(scene, outer);
    Object object = primitiveObject(PrimitiveType::Cube, 1.0, noId);
    object.parent = outerId;
    const Id a = addObject(scene, object);
    object.transform.translation.x = 4.0;
    const Id b = addObject(scene, object);
    const Id id =
        groupEntities(scene, std::vector<EntityRef>{{EntityKind::Object, a}, {EntityKind::Object, b}});
    QCOMPARE(findGroup(scene, id)->parent, outerId);
    QCOMPARE(findGroup(scene, id)->transform.translation, glm::dvec3(2.0, 0.0, 0.0));
    Scene empty;
    QCOMPARE(groupEntities(empty, std::vector<EntityRef>{{EntityKind::Camera}}), noId);
}

void TestGroupEdits::ungroupingAHiddenGroupKeepsItsMembersHidden() {
    std::mt19937 random(4);
    for (int run = 0; run < 50; ++run) {
        Scene scene = randomGroups(random);
        for (Group& group : scene.groups.edit())
            group.visible = random() % 3 != 0;
        const Places before(scene);
        std::vector<EntityRef> groups;
        for (const Group& group : scene.groups)
            if (random() % 2 == 0)
                groups.push_back({EntityKind::Group, group.id});
        const auto freed = ungroupEntities(scene, groups);
        QVERIFY(before.distanceTo(Places(scene)) < 1e-9);
        for (const EntityRef& entity : freed)
            QVERIFY(std::ranges::count(groups, entity) == 0);
        for (const EntityRef& group : groups)
            QVERIFY(!findGroup(scene, group.id));
    }
}

void TestGroupEdits::deletingAGroupDeletesItsMembers() {
    std::mt19937 random(5);
    for (int run = 0; run < 50; ++run) {
        Scene scene = randomGroups(random);
        const Hierarchy hierarchy(scene);
        const Id doomed = scene.groups[random() % scene.groups.size()].id;
        std::size_t stay = 0;
        for (const EntityRef& entity : allThatHangs(scene))
            stay += hierarchy.isWithin(entity.kind == EntityKind::Group ? entity.id : parentOf(scene, entity),
                                       doomed)
                        ? 0
                        : 1;
        const auto before = allThatHangs(scene).size();
        const int removed = removeEntities(scene, std::vector<EntityRef>{{EntityKind::Group, doomed}});
        QCOMPARE(allThatHangs(scene).size(), stay);
        QCOMPARE(static_cast<std::size_t>(removed), before - stay);
    }
}

void TestGroupEdits::duplicatingAGroupCopiesWhatIsInIt() {
    std::mt19937 random(6);
    for (int run = 0; run < 50; ++run) {
        Scene scene = randomGroups(random);
        const Scene before = scene;
        const EntityRef original{EntityKind::Group, scene.groups[random() % scene.groups.size()].id};
        const auto inside = withMembers(scene, std::vector<EntityRef>{original});
        // What is inside is named, too: it must not be copied twice.
        const auto copies = duplicateEntities(scene, inside);
        QCOMPARE(copies.size(), std::size_t{1});
        QCOMPARE(copies[0].kind, EntityKind::Group);
        const auto copied = withMembers(scene, copies);
        QCOMPARE(copied.size(), inside.size());
        QCOMPARE(allThatHangs(scene).size(), allThatHangs(before).size() + inside.size());
        // Every copy is where its original is, moved by one and the same step.
        const Hierarchy hierarchy(scene);
        const glm::dvec4 step = hierarchy.toWorld(copies[0].id)[3] - hierarchy.toWorld(original.id)[3];
        std::vector<glm::dmat4> wanted, found;
        for (const EntityRef& entity : inside)
            if (const Object* object = scene.findObject(entity.id)) {
                wanted.push_back(hierarchy.worldMatrix(*object));
                wanted.back()[3] += step;
            }
        for (const EntityRef& entity : copied)
            if (const Object* object = scene.findObject(entity.id))
                found.push_back(hierarchy.worldMatrix(*object));
        QCOMPARE(found.size(), wanted.size());
        for (const glm::dmat4& matrix : wanted)
            QVERIFY(std::ranges::any_of(found, [&](const auto& m) { return difference(m, matrix) < 1e-9; }));
    }
}

void TestGroupEdits::namesAreUnique() {
    Scene scene;
    Group group;
    group.name = "rig";
    const Id first = addGroup(scene, group);
    const Id second = addGroup(scene, group);
    QCOMPARE(findGroup(scene, second)->name, std::string("rig 2"));
    QVERIFY(renameEntity(scene, {EntityKind::Group, second}, "rig"));
    QCOMPARE(findGroup(scene, second)->name, std::string("rig 2"));
    QVERIFY(renameEntity(scene, {EntityKind::Group, first}, " arm "));
    QCOMPARE(displayName(scene, {EntityKind::Group, first}), std::string("arm"));
    QVERIFY(!renameEntity(scene, {EntityKind::Group, 77}, "x"));
    QVERIFY(applyAssignment(scene, "groups.arm.translation=1,2,3"));
    QCOMPARE(findGroup(scene, first)->transform.translation, glm::dvec3(1.0, 2.0, 3.0));
    QVERIFY(applyAssignment(scene, "groups.arm.visible=false"));
    QVERIFY(!applyAssignment(scene, "groups.none.visible=false"));
}

QTEST_APPLESS_MAIN(TestGroupEdits)
#include "tst_group_edits.moc"
