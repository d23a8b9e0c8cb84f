#pragma once

#include "core/scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace prizma::reference {

/// A ray in world space, double precision. `direction` need not have unit length; t counts in its lengths.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    double tMin = 0.0;
    double tMax = 1e300;
};

/// Where a ray meets a triangle. The point is (1 - u - v)·A + u·B + v·C.
struct Hit {
    double t = 0.0, u = 0.0, v = 0.0;
    std::uint32_t object = 0;    ///< Index into the scene's objects.
    std::uint32_t primitive = 0; ///< Index into the mesh's triangles.
    /// Distance of the hit point from the triangle's nearest edge, as a share of its longest edge; negative
    /// outside.
    double edgeDistance = 0.0;
};

/// The truth that tests compare the kernels with: the visible objects' triangles in world space, in double
/// precision, behind a tree of its own. Shares no code with kernels/ or core/bvh.
class Tracer {
  public:
    explicit Tracer(const Scene& scene);

    std::optional<Hit> closestHit(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

    /// The ray against the plane of one triangle, inside or not: to judge a hit that somebody else claims.
    std::optional<Hit> intersectTriangle(const Ray& ray, std::uint32_t object, std::uint32_t primitive) const;

  private:
    struct Triangle {
        glm::dvec3 a, b, c;
        std::uint32_t object, primitive;
    };
    struct Node {
        DBounds bounds;
        std::uint32_t first = 0, count = 0;
    };

    static std::optional<Hit> intersect(const Ray& ray, const Triangle& triangle);
    void addObject(const Object& object, const glm::dmat4& toWorld, std::uint32_t index);
    void buildTree();

    /// Calls `visit(triangle)` for the triangles whose boxes the ray meets before `limit`, which it may
    /// lower; stops when it returns true.
    template <class Visit>
    void traverse(const Ray& ray, const double& limit, const Visit& visit) const;

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> firstTriangle_; ///< By object: where its triangles start before sorting.
    std::vector<std::uint32_t> sortedPlace_;   ///< Where a triangle stands in `triangles_` after sorting.
};

} // namespace prizma::reference
