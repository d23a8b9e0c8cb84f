#include "core/import/mesh_builder.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace prizma {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::uint64_t mix(std::uint64_t hash, std::uint32_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 29);
}

/// Equal floats hash equally: -0 counts as 0.
std::uint64_t mix(std::uint64_t hash, float value) {
    return mix(hash, std::bit_cast<std::uint32_t>(value + 0.0F));
}

std::uint64_t mix(std::uint64_t hash, const glm::vec3& v) {
    return mix(mix(mix(hash, v.x), v.y), v.z);
}

/// Numbers equal items 0, 1, 2, ... in the order of their first appearance. `firsts` gets that first item of
/// each.
template <class Hash, class Equal>
Numbers numberEqual(std::size_t count, Numbers& firsts, const Hash& hash, const Equal& equal) {
    constexpr std::uint32_t free = 0xFFFFFFFF;
    const std::size_t mask = std::bit_ceil(count * 2 + 1) - 1;
    Numbers table(mask + 1, free);
    Numbers numbers(count);
    firsts.clear();
    for (std::size_t item = 0; item < count; ++item) {
        std::size_t at = static_cast<std::size_t>(hash(item)) & mask;
        while (table[at] != free && !equal(item, firsts[table[at]]))
            at = (at + 1) & mask;
        if (table[at] == free) {
            table[at] = static_cast<std::uint32_t>(firsts.size());
            firsts.push_back(static_cast<std::uint32_t>(item));
        }
        numbers[item] = table[at];
    }
    return numbers;
}

/// The corners at each point: corners[starts[p] .. starts[p + 1]).
struct PointCorners {
    Numbers starts, corners;
};

PointCorners cornersByPoint(const Numbers& points, std::size_t pointCount) {
    PointCorners result{Numbers(pointCount + 1, 0), Numbers(points.size())};
    for (const std::uint32_t point : points)
        ++result.starts[point + 1];
    for (std::size_t p = 0; p < pointCount; ++p)
        result.starts[p + 1] += result.starts[p];
    Numbers next(result.starts.begin(), result.starts.end() - 1);
    for (std::size_t corner = 0; corner < points.size(); ++corner)
        result.corners[next[points[corner]]++] = static_cast<std::uint32_t>(corner);
    return result;
}

/// Unit length, or zero where `v` has none.
glm::vec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0F);
}

bool isZero(const glm::vec3& v) {
    return v == glm::vec3(0.0F);
}

/// Each face's normal, and at each corner that normal times the face's angle there.
struct FaceNormals {
    std::vector<glm::vec3> unit, weighted;
};

FaceNormals faceNormals(const TriangleSoup& soup) {
    FaceNormals faces{std::vector<glm::vec3>(soup.triangleCount()),
                      std::vector<glm::vec3>(soup.positions.size())};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, soup.triangleCount(), 4096), [&](const auto& range) {
        for (std::size_t face = range.begin(); face != range.end(); ++face) {
            const glm::dvec3 p[3] = {soup.positions[face * 3], soup.positions[face * 3 + 1],
                                     soup.positions[face * 3 + 2]};
            faces.unit[face] = unitOrZero(glm::cross(p[1] - p[0], p[2] - p[0]));
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::vec3 u = unitOrZero(p[(i + 1) % 3] - p[i]);
                const glm::vec3 v = unitOrZero(p[(i + 2) % 3] - p[i]);
                const float angle = std::acos(std::clamp(glm::dot(u, v), -1.0F, 1.0F));
                faces.weighted[face * 3 + i] = faces.unit[face] * angle;
            }
        }
    });
    return faces;
}

/// Every face round the point is compared with every other: exact, and fast for the usual handful.
void smoothFewCorners(std::span<const std::uint32_t> corners, const FaceNormals& faces, float creaseCosine,
                      std::vector<glm::vec3>& normals) {
    for (const std::uint32_t corner : corners) {
        const glm::vec3 own = faces.unit[corner / 3];
        glm::vec3 sum(0.0F);
        for (const std::uint32_t other : corners)
            if (isZero(own) || glm::dot(own, faces.unit[other / 3]) >= creaseCosine)
                sum += faces.weighted[other];
        const glm::vec3 smooth = unitOrZero(sum);
        normals[corner] = isZero(smooth) ? own : smooth;
    }
}

/// The middle of a huge fan: faces join the first cluster that they are close enough to, which keeps the time
/// linear.
void smoothManyCorners(std::span<const std::uint32_t> corners, const FaceNormals& faces, float creaseCosine,
                       std::vector<glm::vec3>& normals) {
    std::vector<glm::vec3> heads;
    std::vector<glm::vec3> sums;
    Numbers clusters(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 own = faces.unit[corners[i] / 3];
        const auto head = std::find_if(heads.begin(), heads.end(), [&](const glm::vec3& other) {
            return (isZero(own) && isZero(other)) || glm::dot(own, other) >= creaseCosine;
        });
        clusters[i] = static_cast<std::uint32_t>(head - heads.begin());
        if (head == heads.end()) {
            heads.push_back(own);
            sums.emplace_back(0.0F);
        }
        sums[clusters[i]] += faces.weighted[corners[i]];
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 smooth = unitOrZero(sums[clusters[i]]);
        normals[corners[i]] = isZero(smooth) ? heads[clusters[i]] : smooth;
    }
}

/// Smooth normals for all corners, used where the file has none.
std::vector<glm::vec3> smoothNormals(const TriangleSoup& soup, const Numbers& points, std::size_t pointCount,
                                     double creaseDegrees) {
    const FaceNormals faces = faceNormals(soup);
    const PointCorners around = cornersByPoint(points, pointCount);
    const auto creaseCosine = static_cast<float>(std::cos(glm::radians(creaseDegrees)));
    constexpr std::size_t few = 64;
    std::vector<glm::vec3> normals(soup.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pointCount, 2048), [&](const auto& range) {
        for (std::size_t point = range.begin(); point != range.end(); ++point) {
            const std::span corners(around.corners.data() + around.starts[point],
                                    around.starts[point + 1] - around.starts[point]);
            const auto smooth = corners.size() <= few ? smoothFewCorners : smoothManyCorners;
            smooth(corners, faces, creaseCosine, normals);
        }
    });
    return normals;
}

/// The file's own normals at unit length, smooth ones where it has none.
std::vector<glm::vec3> completeNormals(const TriangleSoup& soup, const Numbers& points,
                                       std::size_t pointCount, double creaseDegrees) {
    std::vector<glm::vec3> normals(soup.normals.size());
    bool complete = true;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        normals[i] = unitOrZero(soup.normals[i]);
        complete = complete && !isZero(normals[i]);
    }
    if (complete)
        return normals;
    const std::vector<glm::vec3> smooth = smoothNormals(soup, points, pointCount, creaseDegrees);
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (isZero(normals[i]))
            normals[i] = isZero(smooth[i]) ? glm::vec3(0, 1, 0) : smooth[i];
    return normals;
}

} // namespace

void TriangleSoup::reserve(std::size_t triangles) {
    positions.reserve(triangles * 3);
    normals.reserve(triangles * 3);
    texCoords.reserve(triangles * 3);
    sourceVertices.reserve(triangles * 3);
    slots.reserve(triangles);
}

BuiltMesh buildMesh(const TriangleSoup& soup, double creaseDegrees) {
    Numbers firsts;
    const Numbers points = numberEqual(
        soup.positions.size(), firsts, [&](std::size_t i) { return mix(1, soup.positions[i]); },
        [&](std::size_t a, std::size_t b) { return soup.positions[a] == soup.positions[b]; });
    const std::vector<glm::vec3> normals = completeNormals(soup, points, firsts.size(), creaseDegrees);
    const auto hash = [&](std::size_t i) {
        return mix(mix(mix(mix(mix(1, points[i]), normals[i]), soup.texCoords[i].x), soup.texCoords[i].y),
                   soup.sourceVertices[i]);
    };
    const auto equal = [&](std::size_t a, std::size_t b) {
        return points[a] == points[b] && normals[a] == normals[b] && soup.texCoords[a] == soup.texCoords[b] &&
               soup.sourceVertices[a] == soup.sourceVertices[b];
    };
    const Numbers vertices = numberEqual(soup.positions.size(), firsts, hash, equal);

    BuiltMesh built;
    Mesh& mesh = built.mesh;
    mesh.positions.reserve(firsts.size());
    mesh.normals.reserve(firsts.size());
    for (const std::uint32_t corner : firsts) {
        mesh.positions.push_back(soup.positions[corner]);
        mesh.normals.push_back(normals[corner]);
        if (soup.hasTexCoords)
            mesh.texCoords.push_back(soup.texCoords[corner]);
        built.sourceVertices.push_back(soup.sourceVertices[corner]);
    }
    mesh.triangles.reserve(soup.triangleCount());
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
        mesh.triangles.emplace_back(vertices[i], vertices[i + 1], vertices[i + 2]);
    mesh.triangleSlots = soup.slots;
    updateBounds(mesh);
    return built;
}

} // namespace prizma
