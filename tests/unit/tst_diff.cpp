#include "core/scene/diff.h"
#include "core/scene/primitives.h"
#include "core/scene/starter_scene.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <random>

using namespace prizma;

namespace {

Scene makeScene() {
    Scene scene = makeStarterScene();
    for (int i = 0; i < 5; ++i) {
        Object object;
        object.name = "ball";
        object.mesh = makePrimitive(PrimitiveType::Sphere, 1.0 + i);
        object.materials = {scene.materials[0].id};
        addObject(scene, object);
    }
    Material glass;
    glass.name = "glass";
    addMaterial(scene, glass);
    return scene;
}

bool holds(const std::vector<Id>& ids, Id id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

} // namespace

class TestDiff : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void noEditsNoChanges() {
        const Scene scene = makeScene();
        QVERIFY(diff(scene, scene).isEmpty());
        Scene copied = scene;
        copied.objects.edit(); // another list in memory with the same items
        copied.lights.edit();
        copied.materials.edit();
        QVERIFY(diff(scene, copied).isEmpty());
        QVERIFY(diff({}, {}).isEmpty());
    }

    void namesDoNotCount() {
        const Scene before = makeScene();
        Scene after = before;
        after.objects.edit()[1].name = "other";
        after.lights.edit()[0].name = "other";
        after.materials.edit()[0].name = "other";
        QVERIFY(diff(before, after).isEmpty());
    }

    void everyEditIsSeen() {
        // Each edit with the check that the difference says just what was done.
        struct Edit {
            std::function<void(Scene&, std::size_t)> apply;
            std::function<bool(const SceneDiff&, Id)> isSeen;
        };
        const std::vector<Edit> edits{
            {[](Scene& s, std::size_t i) { s.objects.edit()[i].transform.translation.x += 1; },
             [](const SceneDiff& d, Id id) { return holds(d.objectsMoved, id); }},
            {[](Scene& s, std::size_t i) { s.objects.edit()[i].visible = !s.objects[i].visible; },
             [](const SceneDiff& d, Id id) { return holds(d.objectsShown, id); }},
            {[](Scene& s, std::size_t i) {
                 s.objects.edit()[i].mesh = makePrimitive(PrimitiveType::Cube, 1);
             },
             [](const SceneDiff& d, Id id) { return holds(d.meshesChanged, id); }},
            {[](Scene& s, std::size_t i) { s.objects.edit()[i].dynamic = !s.objects[i].dynamic; },
             [](const SceneDiff& d, Id id) { return holds(d.meshesChanged, id); }},
            {[](Scene& s, std::size_t i) { s.objects.edit()[i].materials = {s.materials[1].id}; },
             [](const SceneDiff& d, Id id) { return holds(d.materialsAssigned, id); }},
            {[](Scene& s, std::size_t i) { s.objects.edit()[i].clip = "walk"; },
             [](const SceneDiff& d, Id id) { return holds(d.clipsChanged, id); }},
            {[](Scene& s, std::size_t i) {
                 auto& objects = s.objects.edit();
                 objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(i));
             },
             [](const SceneDiff& d, Id id) { return holds(d.objectsRemoved, id); }},
            {[](Scene& s, std::size_t) { s.lights.edit()[0].intensity += 1; },
             [](const SceneDiff& d, Id) { return d.lights; }},
            {[](Scene& s, std::size_t) { s.lights.edit().pop_back(); },
             [](const SceneDiff& d, Id) { return d.lights; }},
            {[](Scene& s, std::size_t) { s.materials.edit()[0].roughness += 0.1; },
             [](const SceneDiff& d, Id) { return d.materials && !d.textures; }},
            {[](Scene& s, std::size_t) { s.materials.edit()[0].baseColorTexture.file = "/x.png"; },
             [](const SceneDiff& d, Id) { return d.materials && d.textures; }},
            {[](Scene& s, std::size_t) { s.camera.fovY += 1; },
             [](const SceneDiff& d, Id) { return d.camera; }},
            {[](Scene& s, std::size_t) { s.background.color.x += 1; },
             [](const SceneDiff& d, Id) { return d.background; }},
            {[](Scene& s, std::size_t) { s.timeline.frame += 1; },
             [](const SceneDiff& d, Id) { return d.time; }},
            {[](Scene& s, std::size_t) { s.render.maxDepth -= 1; },
             [](const SceneDiff& d, Id) { return d.settings; }},
            {[](Scene& s, std::size_t) { s.render.samples += 1; },
             [](const SceneDiff& d, Id) { return d.samples; }},
            {[](Scene& s, std::size_t) { s.render.exposure += 1; },
             [](const SceneDiff& d, Id) { return d.exposure; }},
        };
        std::mt19937 random(11);
        const Scene before = makeScene();
        for (int round = 0; round < 200; ++round) {
            const Edit& edit = edits[random() % edits.size()];
            const std::size_t object = random() % before.objects.size();
            const Id id = before.objects[object].id;
            Scene after = before;
            edit.apply(after, object);
            const SceneDiff forward = diff(before, after);
            if (before == after) { // e.g. a material assigned that was there already
                QVERIFY(forward.isEmpty());
                continue;
            }
            QVERIFY(edit.isSeen(forward, id));
            QVERIFY(!diff(after, before).isEmpty());
            QVERIFY(diff(after, after).isEmpty());
        }
    }

    void objectsComeAndGo() {
        const Scene before = makeScene();
        Scene after = before;
        const Id added = addObject(after, after.objects[2]);
        const SceneDiff forward = diff(before, after);
        QVERIFY(forward.objectsAdded == std::vector<Id>{added});
        QVERIFY(forward.objectsRemoved.empty() && forward.objectsMoved.empty());
        QVERIFY(diff(after, before).objectsRemoved == std::vector<Id>{added});
    }
};

QTEST_GUILESS_MAIN(TestDiff)
#include "tst_diff.moc"
