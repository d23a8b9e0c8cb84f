#pragma once

#include "core/scene/hierarchy.h"
#include "tests/support/test_scenes.h"

#include <random>

namespace prizma::test {

inline double randomIn(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline glm::dquat randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

/// Scales all axes alike, so that any chain of them is a transform again.
inline Transform randomSimilarity(std::mt19937& random) {
    Transform transform;
    for (int i = 0; i < 3; ++i)
        transform.translation[i] = randomIn(random, -5.0, 5.0);
    transform.rotation = randomRotation(random);
    transform.scale = glm::dvec3(std::exp(randomIn(random, -1.0, 1.0)));
    return transform;
}

/// Groups in random trees, with objects and lights of all types in them and beside them.
inline Scene randomGroups(std::mt19937& random, int groups = 8, int objects = 10, int lights = 6) {
    Scene scene;
    const Id material = addMaterial(scene, lambert());
    const auto anyGroup = [&] {
        const auto i = random() % (scene.groups.size() + 1);
        return i == scene.groups.size() ? noId : scene.groups[i].id;
    };
    for (int i = 0; i < groups; ++i) {
        Group group;
        group.name = "group";
        group.parent = anyGroup();
        group.transform = randomSimilarity(random);
        addGroup(scene, group);
    }
    for (int i = 0; i < objects; ++i) {
        Object object = primitiveObject(static_cast<PrimitiveType>(random() % 5), 1.0, material);
        object.parent = anyGroup();
        object.transform = randomSimilarity(random);
        addObject(scene, object);
    }
    for (int i = 0; i < lights; ++i) {
        Light light;
        light.name = "light";
        light.type = static_cast<LightType>(i % 5);
        light.parent = anyGroup();
        light.position = randomSimilarity(random).translation;
        light.direction = randomRotation(random) * glm::dvec3(0.0, 0.0, 1.0);
        light.rotation = randomRotation(random);
        light.size = {randomIn(random, 0.5, 2.0), randomIn(random, 0.5, 2.0)};
        addLight(scene, light);
    }
    return scene;
}

/// Every object, light and group.
inline std::vector<EntityRef> allThatHangs(const Scene& scene) {
    std::vector<EntityRef> all;
    for (const Group& group : scene.groups)
        all.push_back({EntityKind::Group, group.id});
    for (const Object& object : scene.objects)
        all.push_back({EntityKind::Object, object.id});
    for (const Light& light : scene.lights)
        all.push_back({EntityKind::Light, light.id});
    return all;
}

/// The scene without its groups: every member where its groups put it. Made by plain recursion, to compare
/// with; right for similarities only.
inline Scene flattened(const Scene& scene) {
    Scene flat = scene;
    flat.groups = {};
    const auto above = [&](Id id) {
        std::vector<const Group*> chain;
        for (const Group* g = findGroup(scene, id); g; g = findGroup(scene, g->parent))
            chain.push_back(g);
        return chain;
    };
    for (Object& object : flat.objects.edit()) {
        for (const Group* group : above(object.parent)) {
            const Transform& t = group->transform;
            Transform& own = object.transform;
            own = {t.translation + t.rotation * (t.scale * own.translation), t.rotation * own.rotation,
                   t.scale * own.scale};
            object.visible = object.visible && group->visible;
        }
        object.parent = noId;
    }
    for (Light& light : flat.lights.edit()) {
        for (const Group* group : above(light.parent)) {
            const Transform& t = group->transform;
            light.position = t.translation + t.rotation * (t.scale * light.position);
            light.direction = t.rotation * light.direction;
            light.rotation = t.rotation * light.rotation;
            light.size *= t.scale.x;
            light.radius *= t.scale.x;
            light.enabled = light.enabled && group->visible;
        }
        light.parent = noId;
    }
    return flat;
}

/// The largest difference of any two entries, as a share of the larger matrix' size.
inline double difference(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0.0;
    double size = 1.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            most = std::max(most, std::abs(a[column][row] - b[column][row]));
            size = std::max({size, std::abs(a[column][row]), std::abs(b[column][row])});
        }
    return most / size;
}

} // namespace prizma::test
