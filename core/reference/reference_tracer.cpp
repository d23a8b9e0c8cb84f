#include "core/reference/reference_tracer.h"

#include "core/scene/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace prizma::reference {
namespace {

constexpr std::uint32_t leafSize = 4;
constexpr int midpointDepth = 48; ///< Deeper nodes are halved by number, so that no input makes a deep tree.
constexpr int stackSize = 128;    ///< midpointDepth, 32 halvings of a 32-bit number, and some room.

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

int widestAxis(const glm::dvec3& extent) {
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// Where the ray enters the box, or nothing if it passes by or enters beyond `limit`. Errs towards entering.
std::optional<double> enter(const DBounds& box, const Ray& ray, const glm::dvec3& inverse, double limit) {
    constexpr double slack = 4e-15;
    double near = ray.tMin;
    double far = limit;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis])
                return std::nullopt;
            continue;
        }
        double first = (box.low[axis] - ray.origin[axis]) * inverse[axis];
        double last = (box.high[axis] - ray.origin[axis]) * inverse[axis];
        if (first > last)
            std::swap(first, last);
        near = std::max(near, first - std::abs(first) * slack);
        far = std::min(far, last + std::abs(last) * slack);
    }
    return near <= far ? std::optional(near) : std::nullopt;
}

} // namespace

Tracer::Tracer(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        firstTriangle_.push_back(static_cast<std::uint32_t>(triangles_.size()));
        if (object.mesh && hierarchy.isShown(object))
            addObject(object, hierarchy.worldMatrix(object), i);
    }
    buildTree();
}

void Tracer::addObject(const Object& object, const glm::dmat4& toWorld, std::uint32_t index) {
    const Mesh& mesh = *object.mesh;
    const auto corner = [&](std::uint32_t vertex) {
        return glm::dvec3(toWorld * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
    };
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        triangles_.push_back({corner(t.x), corner(t.y), corner(t.z), index, i});
    }
}

void Tracer::buildTree() {
    struct Entry {
        glm::dvec3 centre;
        std::uint32_t triangle;
    };
    std::vector<Entry> entries;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        const Triangle& t = triangles_[i];
        if (isFinite(t.a) && isFinite(t.b) && isFinite(t.c)) // no ray meets any other
            entries.push_back({(t.a + t.b + t.c) / 3.0, i});
    }
    struct Step {
        std::uint32_t node, first, count;
        int depth;
    };
    std::vector<Step> steps;
    if (!entries.empty()) {
        nodes_.emplace_back();
        steps.push_back({0, 0, static_cast<std::uint32_t>(entries.size()), 0});
    }
    while (!steps.empty()) {
        const Step step = steps.back();
        steps.pop_back();
        const std::span<Entry> range(&entries[step.first], step.count);
        DBounds centres;
        for (const Entry& entry : range) {
            const Triangle& t = triangles_[entry.triangle];
            centres.add(entry.centre);
            nodes_[step.node].bounds.add(t.a);
            nodes_[step.node].bounds.add(t.b);
            nodes_[step.node].bounds.add(t.c);
        }
        if (step.count <= leafSize) {
            nodes_[step.node].first = step.first;
            nodes_[step.node].count = step.count;
            continue;
        }
        const int axis = widestAxis(centres.high - centres.low);
        const double middle = centres.low[axis] * 0.5 + centres.high[axis] * 0.5;
        const auto border = std::partition(range.begin(), range.end(),
                                           [&](const Entry& e) { return e.centre[axis] < middle; });
        auto left = static_cast<std::uint32_t>(border - range.begin());
        if (left == 0 || left == step.count || step.depth >= midpointDepth) {
            left = step.count / 2;
            std::nth_element(
                range.begin(), range.begin() + left, range.end(),
                [axis](const Entry& a, const Entry& b) { return a.centre[axis] < b.centre[axis]; });
        }
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        nodes_[step.node].first = child;
        nodes_.resize(child + 2);
        steps.push_back({child, step.first, left, step.depth + 1});
        steps.push_back({child + 1, step.first + left, step.count - left, step.depth + 1});
    }

    // Triangles in the order of the leaves; those in no leaf come last.
    sortedPlace_.assign(triangles_.size(), static_cast<std::uint32_t>(-1));
    std::vector<Triangle> sorted;
    sorted.reserve(triangles_.size());
    const auto place = [&](std::uint32_t triangle) {
        sortedPlace_[triangle] = static_cast<std::uint32_t>(sorted.size());
        sorted.push_back(triangles_[triangle]);
    };
    for (const Entry& entry : entries)
        place(entry.triangle);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
        if (sortedPlace_[i] == static_cast<std::uint32_t>(-1))
            place(i);
    triangles_ = std::move(sorted);
}

template <class Visit>
void Tracer::traverse(const Ray& ray, const double& limit, const Visit& visit) const {
    if (nodes_.empty() || !isFinite(ray.origin) || !isFinite(ray.direction))
        return;
    const glm::dvec3 inverse = 1.0 / ray.direction;
    struct Step {
        std::uint32_t node;
        double near;
    };
    std::array<Step, stackSize> stack;
    int size = 0;
    if (const auto near = enter(nodes_[0].bounds, ray, inverse, limit))
        stack[size++] = {0, *near};
    while (size > 0) {
        const Step step = stack[--size];
        if (step.near > limit)
            continue;
        const Node& node = nodes_[step.node];
        if (node.count > 0) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (visit(triangles_[i]))
                    return;
            continue;
        }
        const auto left = enter(nodes_[node.first].bounds, ray, inverse, limit);
        const auto right = enter(nodes_[node.first + 1].bounds, ray, inverse, limit);
        const bool rightFirst = left && right && *right < *left;
        if (right && !rightFirst)
            stack[size++] = {node.first + 1, *right};
        if (left)
            stack[size++] = {node.first, *left};
        if (right && rightFirst)
            stack[size++] = {node.first + 1, *right};
    }
}

/// Möller and Trumbore 1997, about the ray's origin; accepts by comparisons that are false for NaN.
std::optional<Hit> Tracer::intersect(const Ray& ray, const Triangle& triangle) {
    const glm::dvec3 ab = triangle.b - triangle.a;
    const glm::dvec3 ac = triangle.c - triangle.a;
    const glm::dvec3 cross = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, cross);
    const glm::dvec3 fromA = ray.origin - triangle.a;
    const glm::dvec3 crossAb = glm::cross(fromA, ab);
    Hit hit;
    hit.t = glm::dot(ac, crossAb) / determinant;
    hit.u = glm::dot(fromA, cross) / determinant;
    hit.v = glm::dot(ray.direction, crossAb) / determinant;
    if (!std::isfinite(hit.t) || !std::isfinite(hit.u) || !std::isfinite(hit.v))
        return std::nullopt; // no area, or the ray lies in the plane
    hit.object = triangle.object;
    hit.primitive = triangle.primitive;
    // A corner's weight is the distance from the opposite edge as a share of the height over it.
    const double doubleArea = glm::length(glm::cross(ab, ac));
    const double lengthA = glm::length(triangle.c - triangle.b);
    const double lengthB = glm::length(ac);
    const double lengthC = glm::length(ab);
    const double distance =
        std::min({(1.0 - hit.u - hit.v) / lengthA, hit.u / lengthB, hit.v / lengthC}) * doubleArea;
    hit.edgeDistance = distance / std::max({lengthA, lengthB, lengthC});
    return hit;
}

std::optional<Hit> Tracer::closestHit(const Ray& ray) const {
    std::optional<Hit> closest;
    double limit = ray.tMax;
    traverse(ray, limit, [&](const Triangle& triangle) {
        const auto hit = intersect(ray, triangle);
        if (hit && hit->u >= 0.0 && hit->v >= 0.0 && hit->u + hit->v <= 1.0 && hit->t >= ray.tMin &&
            hit->t <= limit) {
            closest = hit;
            limit = hit->t;
        }
        return false;
    });
    return closest;
}

bool Tracer::occluded(const Ray& ray) const {
    bool found = false;
    traverse(ray, ray.tMax, [&](const Triangle& triangle) {
        const auto hit = intersect(ray, triangle);
        found = hit && hit->u >= 0.0 && hit->v >= 0.0 && hit->u + hit->v <= 1.0 && hit->t >= ray.tMin &&
                hit->t <= ray.tMax;
        return found;
    });
    return found;
}

std::optional<Hit> Tracer::intersectTriangle(const Ray& ray, std::uint32_t object,
                                             std::uint32_t primitive) const {
    if (object >= firstTriangle_.size())
        return std::nullopt;
    const std::size_t end =
        object + 1 < firstTriangle_.size() ? firstTriangle_[object + 1] : triangles_.size();
    const std::size_t index = std::size_t{firstTriangle_[object]} + primitive;
    return index < end ? intersect(ray, triangles_[sortedPlace_[index]]) : std::nullopt;
}

} // namespace prizma::reference
