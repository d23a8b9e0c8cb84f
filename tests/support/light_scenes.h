#pragma once

#include "tests/support/light_probe.h"

#include <functional>

namespace prizma::test {

constexpr double pi = glm::pi<double>();
using Question = LightProbe::Question;
using Answer = LightProbe::Answer;

class RandomNumbers {
  public:
    explicit RandomNumbers(unsigned seed) : random_(seed) {}

    double uniform(double low = 0.0, double high = 1.0) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    glm::dvec3 direction() {
        std::normal_distribution<double> normal;
        return glm::normalize(glm::dvec3(normal(random_), normal(random_), normal(random_)));
    }
    glm::dquat rotation() {
        std::normal_distribution<double> normal;
        return glm::normalize(glm::dquat(normal(random_), normal(random_), normal(random_), normal(random_)));
    }
    /// As a sampler gives them: multiples of 2^-24 below 1.
    float fraction() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }
    std::uint32_t whole() { return static_cast<std::uint32_t>(random_()); }

  private:
    std::mt19937 random_;
};

inline Question question(const glm::dvec3& position, const glm::dvec3& normal, RandomNumbers& random) {
    Question q{};
    for (int i = 0; i < 3; ++i) {
        q.position[i] = static_cast<float>(position[i]);
        q.normal[i] = static_cast<float>(normal[i]);
        q.u[i] = random.fraction();
    }
    return q;
}

/// Black, without surroundings, with its anchor at the origin.
inline Scene emptyScene() {
    Scene scene;
    scene.camera.position = glm::dvec3(0.0);
    scene.camera.target = {0, 0, -1};
    scene.background.color = glm::dvec3(0.0);
    return scene;
}

inline Light rectangle(const glm::dvec3& position, const glm::dquat& rotation, const glm::dvec2& size) {
    Light light;
    light.type = LightType::Rectangle;
    light.position = position;
    light.rotation = rotation;
    light.size = size;
    light.radiance = 3.0;
    return light;
}

inline Light sphere(const glm::dvec3& position, double radius) {
    Light light;
    light.type = LightType::Sphere;
    light.position = position;
    light.radius = radius;
    light.radiance = 3.0;
    return light;
}

inline Material shining(const glm::dvec3& emission = glm::dvec3(3.0)) {
    Material material = lambert(0.0);
    material.emission = emission;
    return material;
}

/// An object of these triangles.
inline Object triangles(const std::vector<glm::vec3>& corners, Id material) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = corners;
    mesh->slots = {"slot"};
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) {
        mesh->triangles.emplace_back(i, i + 1, i + 2);
        mesh->triangleSlots.push_back(0);
    }
    mesh->normals.assign(corners.size(), {0, 1, 0});
    updateBounds(*mesh);
    Object object;
    object.mesh = mesh;
    object.materials = {material};
    return object;
}

inline ImagePtr floatImage(int width, int height, const std::function<double(int, int)>& value) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto v = static_cast<float>(value(x, y));
            image->floats.insert(image->floats.end(), {v, 0.5f * v, 0.25f * v, 1.0f});
        }
    return image;
}

/// Irradiance that a polygon of radiance 1 gives to the origin of a surface with `normal`, whatever side the
/// polygon shows (Lambert 1760). The part below the surface is cut off first (Sutherland and Hodgman 1974).
inline double polygonIrradiance(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal) {
    std::vector<glm::dvec3> above;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % corners.size()];
        const double heightA = glm::dot(a, normal);
        const double heightB = glm::dot(b, normal);
        if (heightA >= 0.0)
            above.push_back(a);
        if ((heightA < 0.0) != (heightB < 0.0))
            above.push_back(a + (b - a) * (heightA / (heightA - heightB)));
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const glm::dvec3& a = above[i];
        const glm::dvec3& b = above[(i + 1) % above.size()];
        const glm::dvec3 across = glm::cross(a, b);
        const double sine = glm::length(across);
        if (sine > 0.0)
            sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across / sine, normal);
    }
    return 0.5 * std::abs(sum);
}

} // namespace prizma::test
