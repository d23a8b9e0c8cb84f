#pragma once

#include "core/import/mesh_builder.h"
#include "core/scene/clip.h"
#include "core/scene/skeleton.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

namespace prizma {

glm::dmat4 toGlm(const aiMatrix4x4& m);

/// The bones of an animated model: every node of it is one, so that rigid parts move with their node too.
class AssimpSkin {
  public:
    /// `toObject` turns the file's axes and units into ours.
    AssimpSkin(const aiScene& scene, const glm::dmat4& toObject);

    static bool isNeeded(const aiScene& scene);

    /// Takes in the weights of a mesh that hangs on `node`: gives the matrix that brings its vertices into
    /// object space, and the number of its vertex 0 as a source vertex.
    struct Binding {
        glm::dmat4 toObject;
        std::uint32_t firstSourceVertex;
    };
    Binding bind(const aiMesh& mesh, const aiNode& node);

    /// Completes a mesh that was built from the bound ones.
    void apply(BuiltMesh& built);

    const Skeleton& skeleton() const { return skeleton_; }

    std::vector<ClipPtr> clips(const aiScene& scene) const;

  private:
    glm::dmat4 global(const aiNode& node) const;

    Skeleton skeleton_;
    std::vector<glm::dmat4> globals_;
    std::vector<bool> inverseBindKnown_;
    glm::dmat4 toObject_;
    std::map<const aiNode*, int> boneOfNode_;
    std::map<std::string, int> boneOfName_;
    std::vector<std::vector<BoneInfluence>> weights_; ///< Of each source vertex.
};

} // namespace prizma
