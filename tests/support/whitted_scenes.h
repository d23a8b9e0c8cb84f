#pragma once

#include "tests/support/test_scenes.h"

#include <functional>

namespace prizma::test {

/// A small scene that shows one side of Whitted's shader, for comparing pictures.
struct NamedScene {
    const char* name;
    Scene scene;
};

inline Material namedMaterial(const char* name, const std::function<void(Material&)>& edit = {}) {
    Material material;
    material.name = name;
    if (edit)
        edit(material);
    return material;
}

inline Material mirrorMaterial(const glm::dvec3& color = {0.9, 0.85, 0.8}) {
    return namedMaterial("mirror", [&](Material& m) {
        m.baseColor = color;
        m.metallic = 1.0;
        m.roughness = 0.0;
    });
}

inline Material glassMaterial(double ior = 1.5) {
    return namedMaterial("glass", [&](Material& m) {
        m.baseColor = glm::dvec3(1.0);
        m.transmission = 1.0;
        m.roughness = 0.0;
        m.ior = ior;
    });
}

inline Light pointLight(const glm::dvec3& position, double intensity) {
    Light light;
    light.position = position;
    light.intensity = intensity;
    return light;
}

/// A picture of `size` texels a side whose texels `texel(x, y)` gives, RGBA from 0 to 255.
inline Texture pictureOf(int size, const std::function<glm::ivec4(int, int)>& texel) {
    auto image = std::make_shared<Image>();
    image->width = image->height = size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::ivec4 value = texel(x, y);
            for (int c = 0; c < 4; ++c)
                image->bytes.push_back(static_cast<std::uint8_t>(value[c]));
            image->opaque = image->opaque && value.w == 255;
        }
    return {"made by the test", image};
}

/// A picture of random texels, smooth to look at because it is seen from near.
inline Texture randomPicture(int size, unsigned seed, int lowest = 0, bool withAlpha = false) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> level(lowest, 255);
    return pictureOf(size, [&](int, int) {
        return glm::ivec4(level(random), level(random), level(random), withAlpha ? level(random) : 255);
    });
}

/// An HDR picture of the surroundings: a bright patch in a dark sky over a brown ground.
inline Texture skyPicture() {
    auto image = std::make_shared<Image>();
    image->width = 32;
    image->height = 16;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            const bool sun = x >= 20 && x < 23 && y >= 4 && y < 6;
            const glm::vec3 color = sun ? glm::vec3(9.0f, 8.0f, 6.0f)
                                        : (y < 8 ? glm::vec3(0.2f, 0.3f, 0.05f * static_cast<float>(y) + 0.4f)
                                                 : glm::vec3(0.3f, 0.01f * static_cast<float>(x), 0.1f));
            for (const float value : {color.x, color.y, color.z, 1.0f})
                image->floats.push_back(value);
        }
    return {"made by the test", image};
}

/// Camera, floor and a grey sky.
inline Scene stage() {
    Scene scene;
    scene.camera = {{0.4, 1.9, 5.2}, {0.0, 0.5, 0.0}, {0, 1, 0}, 42.0};
    scene.background.color = {0.25, 0.3, 0.4};
    scene.render.samples = 1;
    Material floor = lambert(0.7);
    floor.name = "floor";
    floor.baseColorTexture = pictureOf(4, [](int x, int y) {
        return (x + y) % 2 == 0 ? glm::ivec4(240, 230, 210, 255) : glm::ivec4(60, 80, 90, 255);
    });
    addObject(scene, primitiveObject(PrimitiveType::Plane, 9.0, addMaterial(scene, floor)));
    return scene;
}

inline Object& addPrimitive(Scene& scene, PrimitiveType type, double size, const Material& material,
                            const glm::dvec3& place) {
    addObject(scene, primitiveObject(type, size, addMaterial(scene, material), place));
    return scene.objects.edit().back();
}

/// Every kind of material, side by side.
inline Scene materialScene() {
    Scene scene = stage();
    const auto rough = [](double roughness, double metallic, const glm::dvec3& color) {
        return namedMaterial("rough", [=](Material& m) {
            m.roughness = roughness;
            m.metallic = metallic;
            m.baseColor = color;
        });
    };
    const Material half = namedMaterial("half clear", [](Material& m) {
        m.transmission = 0.5;
        m.roughness = 0.05;
        m.baseColor = {0.3, 0.7, 0.9};
    });
    const Material ink = namedMaterial("ink", [](Material& m) {
        m = glassMaterial(1.33);
        m.attenuationColor = {0.2, 0.6, 0.9};
        m.attenuationDistance = 0.5;
    });
    const Material lamp = namedMaterial("lamp", [](Material& m) {
        m.emission = {1.0, 0.6, 0.2};
        m.emissionStrength = 2.0;
    });
    const Material materials[] = {lambert(0.6),
                                  rough(0.4, 0.0, {0.8, 0.2, 0.2}),
                                  rough(0.0, 0.0, {0.1, 0.3, 0.8}),
                                  mirrorMaterial(),
                                  rough(0.5, 1.0, {0.9, 0.7, 0.3}),
                                  glassMaterial(),
                                  ink,
                                  half,
                                  lamp,
                                  rough(0.3, 0.6, {0.4, 0.8, 0.4})};
    const PrimitiveType types[] = {PrimitiveType::Sphere, PrimitiveType::Cube, PrimitiveType::Cylinder,
                                   PrimitiveType::Torus};
    int i = 0;
    for (const Material& material : materials) {
        Object& object = addPrimitive(scene, types[i % 4], 0.8, material,
                                      {-1.8 + 0.9 * (i % 5), 0.55, 0.9 - 1.6 * (i / 5)});
        object.transform.rotation = rotationFromEulerDegrees({10.0 * i, 25.0 * i + 7.0, 3.0 * i});
        ++i;
    }
    addLight(scene, pointLight({2.0, 4.0, 3.0}, 60.0));
    return scene;
}

/// One of each type of light, over matt and shiny things.
inline Scene lightScene() {
    Scene scene = stage();
    addPrimitive(scene, PrimitiveType::Sphere, 1.2, lambert(0.8), {-1.1, 0.6, 0.0});
    addPrimitive(scene, PrimitiveType::Torus, 1.4,
                 namedMaterial("gloss", [](Material& m) { m.roughness = 0.35; }), {1.0, 0.5, 0.2});
    addLight(scene, pointLight({-2.0, 2.5, 1.5}, 25.0));
    Light spot;
    spot.type = LightType::Spot;
    spot.position = {2.0, 3.0, 2.0};
    spot.direction = {-0.5, -1.0, -0.6};
    spot.intensity = 70.0;
    spot.color = {1.0, 0.8, 0.6};
    addLight(scene, spot);
    Light sun;
    sun.type = LightType::Directional;
    sun.direction = {0.4, -1.0, -0.7};
    sun.irradiance = 0.8;
    addLight(scene, sun);
    Light panel;
    panel.type = LightType::Rectangle;
    panel.position = {0.0, 2.2, -1.4};
    panel.rotation = rotationFromEulerDegrees({-70.0, 0.0, 15.0});
    panel.size = {1.0, 0.5};
    panel.radiance = 12.0;
    addLight(scene, panel);
    Light bulb;
    bulb.type = LightType::Sphere;
    bulb.position = {0.3, 1.7, 1.0};
    bulb.radius = 0.2;
    bulb.radiance = 15.0;
    bulb.color = {0.5, 0.7, 1.0};
    addLight(scene, bulb);
    bulb.position = {-0.4, 0.9, 1.2};
    bulb.radius = 0.1;
    bulb.visible = false; // but in the mirror
    addLight(scene, bulb);
    addPrimitive(scene, PrimitiveType::Plane, 2.0, mirrorMaterial(), {-0.2, 1.0, -1.0}).transform.rotation =
        rotationFromEulerDegrees({90, 0, 0});
    Light off = pointLight({0, 2, 2}, 500.0);
    off.enabled = false;
    addLight(scene, off);
    return scene;
}

/// One mesh in many places: turned, stretched, mirrored, hidden.
inline Scene instanceScene() {
    Scene scene = stage();
    const Material materials[] = {lambert(0.7), mirrorMaterial(), glassMaterial(1.3)};
    Id ids[3];
    for (int i = 0; i < 3; ++i)
        ids[i] = addMaterial(scene, materials[i]);
    Object torus = primitiveObject(PrimitiveType::Torus, 1.0, ids[0]);
    for (int i = 0; i < 9; ++i) {
        torus.transform.translation = {-1.6 + 1.6 * (i % 3), 0.6 + 0.2 * (i / 3), 1.4 - 1.5 * (i / 3)};
        torus.transform.rotation = rotationFromEulerDegrees({35.0 * i, -20.0 * i, 10.0 * i});
        torus.transform.scale = {0.8 + 0.05 * i, i % 2 == 0 ? -0.9 : 0.9, i % 4 == 1 ? -1.2 : 0.7};
        torus.materials[0] = ids[i % 3];
        torus.visible = i != 4;
        addObject(scene, torus);
    }
    addLight(scene, pointLight({-1.0, 4.0, 3.0}, 50.0));
    return scene;
}

/// All textures, on things that are seen from near, under a picture of the sky.
inline Scene textureScene() {
    Scene scene = stage();
    scene.camera = {{0.2, 1.3, 3.4}, {0.0, 0.6, 0.0}, {0, 1, 0}, 40.0};
    scene.background.image = skyPicture();
    scene.background.intensity = 0.7;
    scene.background.rotation = 40.0;
    const Material all = namedMaterial("all textures", [](Material& m) {
        m.baseColor = {0.9, 0.8, 1.0};
        m.baseColorTexture = randomPicture(6, 1);
        m.emission = glm::dvec3(0.5);
        m.emissionTexture = randomPicture(5, 2);
        m.metallic = 0.8;
        m.roughness = 1.0;
        m.metallicRoughnessTexture = randomPicture(4, 3, 90);
        m.specularColor = {1.0, 0.6, 0.3};
        m.specularTexture = randomPicture(4, 4, 0, true);
        m.normalTexture =
            pictureOf(4, [](int x, int y) { return glm::ivec4(100 + 20 * x, 150 - 15 * y, 230, 255); });
        m.normalScale = 0.8;
    });
    addPrimitive(scene, PrimitiveType::Cube, 1.0, all, {-0.8, 0.55, 0.3}).transform.rotation =
        rotationFromEulerDegrees({0, 30, 0});
    addPrimitive(scene, PrimitiveType::Sphere, 1.1, all, {0.8, 0.6, 0.2}).transform.scale = {1.0, -1.0, 1.0};
    const Material window = namedMaterial("stained glass", [](Material& m) {
        m = glassMaterial(1.4);
        m.baseColorTexture = randomPicture(3, 8, 120);
        m.transmissionTexture = randomPicture(3, 9, 128);
    });
    addPrimitive(scene, PrimitiveType::Cube, 0.5, window, {0.0, 0.3, 1.2}).transform.rotation =
        rotationFromEulerDegrees({0, 20, 0});
    addLight(scene, pointLight({1.0, 3.0, 3.0}, 30.0));
    return scene;
}

/// Blended sheets behind each other, a mask's holes, single sides, and what shows through them in a mirror.
inline Scene alphaScene() {
    Scene scene = stage();
    const auto sheet = [&](const Material& material, const glm::dvec3& place, double turn) {
        addPrimitive(scene, PrimitiveType::Plane, 1.5, material, place).transform.rotation =
            rotationFromEulerDegrees({90.0, turn, 0.0});
    };
    for (int i = 0; i < 4; ++i)
        sheet(namedMaterial("veil",
                            [=](Material& m) {
                                m.baseColor = {0.3 + 0.2 * i, 0.8 - 0.2 * i, 0.5};
                                m.specular = 0.0;
                                m.alpha = 0.35 + 0.1 * i;
                            }),
              {-1.4, 0.8, 1.2 - 0.5 * i}, 10.0 * i);
    sheet(namedMaterial("grid",
                        [](Material& m) {
                            m.baseColorTexture = pictureOf(8, [](int x, int y) {
                                return glm::ivec4(200, 120, 60, (x * y) % 3 == 0 ? 40 : 240);
                            });
                            m.alphaMode = AlphaMode::Mask;
                            m.specular = 0.0;
                        }),
          {0.4, 0.8, 1.0}, -15.0);
    sheet(namedMaterial("faded",
                        [](Material& m) {
                            m.baseColorTexture = randomPicture(5, 21, 30, true);
                            m.specular = 0.0;
                        }),
          {1.7, 0.8, 0.9}, 25.0);
    sheet(mirrorMaterial(), {0.5, 0.9, -1.5}, 5.0);
    addPrimitive(scene, PrimitiveType::Sphere, 0.9,
                 namedMaterial("half a ball",
                               [](Material& m) {
                                   m.doubleSided = false;
                                   m.alphaMode = AlphaMode::Mask;
                                   m.specular = 0.0;
                                   m.baseColorTexture = pictureOf(4, [](int, int y) {
                                       return glm::ivec4(90, 160, 220, y < 2 ? 255 : 0);
                                   });
                               }),
                 {0.6, 0.5, -0.4});
    addLight(scene, pointLight({-1.0, 3.5, 4.0}, 45.0));
    addLight(scene, pointLight({2.5, 2.0, -1.0}, 20.0));
    return scene;
}

/// A glass shell with air, glass of another kind and an opaque ball inside; a bubble; a prism.
inline Scene nestedGlassScene() {
    Scene scene = stage();
    Material tinted = glassMaterial(1.6);
    tinted.attenuationColor = {0.9, 0.5, 0.3};
    tinted.attenuationDistance = 0.8;
    addPrimitive(scene, PrimitiveType::Sphere, 1.8, glassMaterial(), {-0.9, 0.95, 0.0});
    addPrimitive(scene, PrimitiveType::Sphere, 1.6, glassMaterial(), {-0.9, 0.95, 0.0}).transform.scale =
        glm::dvec3(-1.0); // seen from inside: air
    // Faces turned in make a bubble; a mirrored transform does not turn them, a mesh's order of corners does.
    auto turned = std::make_shared<Mesh>(*scene.objects.edit().back().mesh);
    for (glm::uvec3& triangle : turned->triangles)
        std::swap(triangle.y, triangle.z);
    for (glm::vec3& normal : turned->normals)
        normal = -normal;
    scene.objects.edit().back().mesh = turned;
    addPrimitive(scene, PrimitiveType::Sphere, 0.8, tinted, {-0.9, 0.95, 0.0});
    addPrimitive(scene, PrimitiveType::Cube, 0.9, tinted, {1.1, 0.6, 0.4}).transform.rotation =
        rotationFromEulerDegrees({20, 35, 10});
    addPrimitive(scene, PrimitiveType::Sphere, 0.4, lambert(0.9), {1.1, 0.6, 0.4});
    addLight(scene, pointLight({1.0, 4.0, 2.0}, 60.0));
    return scene;
}

/// The same and an absorbing slab, lit through.
inline Scene clearShadowScene() {
    Scene scene = nestedGlassScene();
    scene.render.transparentShadows = true;
    Material pane = glassMaterial(1.5);
    pane.baseColor = {0.5, 0.9, 0.6};
    addPrimitive(scene, PrimitiveType::Cube, 1.0, pane, {0.0, 2.2, 1.5}).transform.scale = {1.5, 0.1, 1.0};
    return scene;
}

/// Two mirrors that face each other with a ball between.
inline Scene hallScene() {
    Scene scene = stage();
    scene.camera = {{0.3, 1.2, 1.7}, {-0.6, 0.9, -2.0}, {0, 1, 0}, 60.0};
    addPrimitive(scene, PrimitiveType::Plane, 6.0, mirrorMaterial(), {0, 1, -2}).transform.rotation =
        rotationFromEulerDegrees({90, 0, 0});
    addPrimitive(scene, PrimitiveType::Plane, 6.0, mirrorMaterial({0.7, 0.9, 0.8}), {0, 1, 2})
        .transform.rotation = rotationFromEulerDegrees({-90, 2, 0});
    addPrimitive(scene, PrimitiveType::Cube, 0.7, lambert(0.7), {-0.7, 0.5, -0.5});
    addLight(scene, pointLight({0.5, 3.0, 0.5}, 20.0));
    return scene;
}

/// Things, materials and lights by chance.
inline Scene randomScene(unsigned seed) {
    Scene scene = stage();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto color = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
    for (int i = 0; i < 9; ++i) {
        const Material material = namedMaterial("by chance", [&](Material& m) {
            const int kind = static_cast<int>(unit(random) * 5.0);
            m.baseColor = color();
            m.roughness = kind < 2 ? 0.3 + 0.7 * unit(random) : 0.0;
            m.metallic = kind == 1 || kind == 2 ? 1.0 : 0.3 * unit(random);
            m.transmission = kind == 3 ? 1.0 : (kind == 4 ? unit(random) : 0.0);
            m.specular = unit(random);
            m.specularColor = color();
            m.ior = 1.05 + unit(random);
            m.attenuationColor = 0.2 + 0.8 * color();
            m.attenuationDistance = kind >= 3 ? 1.0 : 0.0;
            m.alpha = unit(random) < 0.2 ? unit(random) : 1.0;
        });
        const auto type = static_cast<PrimitiveType>(static_cast<int>(unit(random) * 5.0));
        Object& object =
            addPrimitive(scene, type, 0.5 + unit(random), material,
                         {4.0 * unit(random) - 2.0, 0.3 + 1.2 * unit(random), 3.0 * unit(random) - 1.8});
        object.transform.rotation =
            rotationFromEulerDegrees({360.0 * unit(random), 90.0 * unit(random), 360.0 * unit(random)});
        object.transform.scale = {0.6 + 0.6 * unit(random), unit(random) < 0.5 ? -1.0 : 1.0, 0.8};
    }
    scene.render.maxDepth = static_cast<int>(unit(random) * 8.0);
    scene.render.transparentShadows = unit(random) < 0.5;
    for (int i = 0; i < 3; ++i) {
        Light light = pointLight({6.0 * unit(random) - 3.0, 2.5 + unit(random), 4.0 * unit(random)}, 25.0);
        light.type = static_cast<LightType>(static_cast<int>(unit(random) * 5.0));
        light.direction = {unit(random) - 0.5, -1.0, unit(random) - 0.5};
        light.irradiance = 1.0;
        light.color = 0.4 + 0.6 * color();
        addLight(scene, light);
    }
    return scene;
}

} // namespace prizma::test
