#pragma once

#include "core/diagnostic.h"
#include "core/scene/skeleton.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace prizma {

struct SmdBone {
    std::string name;
    int parent = -1; ///< Index of the parent, always less than the bone's own; -1 for a root.
};

/// A bone's place relative to its parent in one frame.
struct SmdKey {
    std::uint32_t frame = 0, bone = 0;
    glm::vec3 position{0.0F};
    glm::vec3 angles{0.0F}; ///< Radians; the matrix is Rz·Ry·Rx.
};

struct SmdCorner {
    glm::vec3 position{0.0F}, normal{0.0F}; ///< In the file's model space, in the bind pose.
    glm::vec2 texCoord{0.0F};               ///< (0, 0) is the picture's bottom left corner.
    std::uint32_t binding = 0;              ///< Which bones move it: an index into SmdFile::bindings.
};

/// Lists of bone influences, each list once; the weights of a list are positive and sum to 1.
class SmdBindings {
  public:
    std::size_t size() const { return starts_.size() - 1; }
    std::span<const BoneInfluence> operator[](std::size_t binding) const {
        return std::span(influences_).subspan(starts_[binding], starts_[binding + 1] - starts_[binding]);
    }
    void add(std::span<const BoneInfluence> influences) {
        influences_.insert(influences_.end(), influences.begin(), influences.end());
        starts_.push_back(influences_.size());
    }

  private:
    std::vector<std::size_t> starts_{0};
    std::vector<BoneInfluence> influences_;
};

/// What an SMD file says, in its own axes and units. All indices are in range, all numbers finite.
struct SmdFile {
    std::vector<SmdBone> bones; ///< Parents before children, otherwise by their numbers.

    int frameCount = 0;
    std::vector<SmdKey> keys; ///< By frame; a frame need not have all bones, nor any.

    bool hasTriangles = false;      ///< Whether there is such a block: a reference model.
    std::vector<SmdCorner> corners; ///< Three a triangle, in the file's order.
    std::vector<std::uint32_t> triangleMaterials;
    std::vector<std::string> materials; ///< Each name once, in the order of appearance; may be empty text.
    SmdBindings bindings;

    Diagnostics warnings; ///< What was put up with, with the line and what was done about it.
};

} // namespace prizma
