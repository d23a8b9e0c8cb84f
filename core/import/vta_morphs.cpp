#include "core/import/vta_morphs.h"

#include "core/import/fault_tally.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace prizma {
namespace {

constexpr double matchTolerance = 1e-4; ///< Of the mesh's size.
constexpr std::size_t mostInCell = 32;  ///< Vertices at one point that are looked at.
constexpr std::size_t mostOffsets = 4'000'000;

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// Unmoved vertices in a grid of cells as wide as the tolerance.
class VertexGrid {
  public:
    VertexGrid(std::span<const VtaVertex> vertices, const glm::dmat4& toObject, double tolerance)
        : tolerance_(tolerance) {
        for (const VtaVertex& vertex : vertices) {
            positions_.emplace_back(toObject * glm::dvec4(vertex.position, 1.0));
            normals_.push_back(unit(glm::dmat3(toObject) * glm::dvec3(vertex.normal)));
            auto& cell = cells_[keyOf(cellOf(positions_.back()))];
            if (cell.size() < mostInCell)
                cell.push_back(static_cast<std::uint32_t>(positions_.size() - 1));
        }
    }

    /// The vertex within the tolerance whose normal is closest; -1 if there is none.
    int find(const glm::dvec3& position, const glm::dvec3& normal) const {
        int best = -1;
        double bestScore = -2.0;
        const glm::dvec3 cell = cellOf(position);
        for (int i = 0; i < 27; ++i) {
            const auto found = cells_.find(keyOf(cell + glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (found == cells_.end())
                continue;
            for (const std::uint32_t candidate : found->second) {
                const double distance = glm::length(positions_[candidate] - position) / tolerance_;
                const double score = glm::dot(normals_[candidate], normal) - distance * 0.5;
                if (distance <= 1.0 && score > bestScore) {
                    best = static_cast<int>(candidate);
                    bestScore = score;
                }
            }
        }
        return best;
    }

  private:
    glm::dvec3 cellOf(const glm::dvec3& position) const { return glm::floor(position / tolerance_); }

    static std::uint64_t keyOf(const glm::dvec3& cell) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double clamped = std::clamp(cell[axis], -9e18, 9e18);
            key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(clamped))) *
                  0x9E3779B97F4A7C15ULL;
            key ^= key >> 31;
        }
        return key;
    }

    double tolerance_;
    std::vector<glm::dvec3> positions_, normals_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// The mesh vertices that each unmoved vertex of the VTA stands for.
std::vector<std::vector<std::uint32_t>> matchVertices(std::span<const VtaVertex> base, const Mesh& mesh,
                                                      std::span<const std::uint32_t> candidates,
                                                      const glm::dmat4& toObject) {
    Bounds box;
    for (const std::uint32_t vertex : candidates)
        box.add(mesh.positions[vertex]);
    const double size = candidates.empty() ? 0.0 : glm::length(glm::dvec3(box.high) - glm::dvec3(box.low));
    const VertexGrid grid(base, toObject, std::max(size * matchTolerance, 1e-30));
    std::vector<std::vector<std::uint32_t>> matches(base.size());
    for (const std::uint32_t vertex : candidates) {
        const int found = grid.find(mesh.positions[vertex], mesh.normals[vertex]);
        if (found >= 0)
            matches[static_cast<std::size_t>(found)].push_back(vertex);
    }
    return matches;
}

struct Offset {
    std::uint32_t vertex;
    glm::vec3 position, normal;
};

/// How far the mesh's vertices go in `frame`, by vertex. Stops short once there are more than `most`.
std::vector<Offset> offsetsOf(const VtaFrame& frame, std::span<const VtaVertex> base,
                              const std::vector<std::vector<std::uint32_t>>& matches,
                              const glm::dmat4& toObject, std::size_t most) {
    std::vector<Offset> offsets;
    const glm::dmat3 linear(toObject);
    for (const VtaVertex& moved : frame.vertices) {
        const auto found = std::ranges::lower_bound(base, moved.id, {}, &VtaVertex::id);
        if (found == base.end() || found->id != moved.id)
            continue;
        const glm::vec3 position(linear * (glm::dvec3(moved.position) - glm::dvec3(found->position)));
        const glm::vec3 normal(unit(linear * glm::dvec3(moved.normal)) -
                               unit(linear * glm::dvec3(found->normal)));
        for (const std::uint32_t vertex : matches[static_cast<std::size_t>(found - base.begin())])
            offsets.push_back({vertex, position, normal});
        if (offsets.size() > most)
            break;
    }
    std::ranges::sort(offsets, {}, &Offset::vertex);
    return offsets;
}

struct Shape {
    std::string name;
    const VtaFrame* frame;
};

/// The frames that become morph targets, under names of their own.
std::vector<Shape> shapesOf(const VtaFile& vta, std::span<const QcFlex> flexes, const std::string& file,
                            Diagnostics& warnings) {
    std::vector<Shape> shapes;
    std::set<std::string> taken;
    const auto add = [&](const std::string& wanted, const VtaFrame& frame) {
        const std::string stem = wanted.empty() ? "flex " + std::to_string(frame.time) : wanted;
        std::string name = stem;
        for (int number = 2; !taken.insert(name).second; ++number)
            name = stem + " " + std::to_string(number);
        shapes.push_back({name, &frame});
    };
    if (flexes.empty())
        for (std::size_t i = 1; i < vta.frames.size(); ++i)
            add(vta.frames[i].name, vta.frames[i]);
    std::unordered_map<int, const VtaFrame*> byTime;
    for (const VtaFrame& frame : vta.frames)
        byTime.try_emplace(frame.time, &frame);
    std::vector<std::string> missing;
    for (const QcFlex& flex : flexes) {
        if (const auto found = byTime.find(flex.frame); found != byTime.end())
            add(flex.name, *found->second);
        else
            missing.push_back(flex.name);
    }
    if (!missing.empty())
        warnings.push_back(
            {Severity::Warning,
             "The file lacks the frames of flexes, which were left out: " + listOf(missing) + ".", file, 0});
    return shapes;
}

} // namespace

Result<std::vector<MorphTarget>> makeMorphTargets(const VtaFile& vta, std::span<const QcFlex> flexes,
                                                  const Mesh& mesh, std::span<const std::uint32_t> candidates,
                                                  const glm::dmat4& toObject, const std::string& file,
                                                  Diagnostics& warnings) {
    const std::span<const VtaVertex> base = vta.frames.front().vertices;
    const auto matches = matchVertices(base, mesh, candidates, toObject);
    const auto unmatched = std::ranges::count_if(matches, [](const auto& list) { return list.empty(); });
    if (static_cast<std::size_t>(unmatched) == matches.size())
        return failure("None of its vertices is where one of the model is: it belongs to another model.",
                       file);
    if (unmatched > 0)
        warnings.push_back(
            {Severity::Warning,
             std::to_string(unmatched) + " vertices of the flexes are not in the model and were ignored.",
             file, 0});
    std::vector<MorphTarget> targets;
    std::size_t total = 0;
    for (const Shape& shape : shapesOf(vta, flexes, file, warnings)) {
        MorphTarget target;
        target.name = shape.name;
        for (const Offset& offset : offsetsOf(*shape.frame, base, matches, toObject, mostOffsets - total)) {
            target.vertices.push_back(offset.vertex);
            target.positionOffsets.push_back(offset.position);
            target.normalOffsets.push_back(offset.normal);
        }
        total += target.vertices.size();
        if (total > mostOffsets)
            return failure("The flexes move too many vertices.", file);
        targets.push_back(std::move(target));
    }
    return targets;
}

} // namespace prizma
