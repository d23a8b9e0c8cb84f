#pragma once

#include "core/import/mesh_builder.h"
#include "core/import/model_importer.h"
#include "core/import/qc_reader.h"
#include "core/import/smd_skeleton.h"
#include "core/import/texture_finder.h"
#include "core/import/vta_reader.h"

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace prizma {

/// Puts reference SMDs together into one model: bodies first, then buildMesh, then flexes, clips and
/// materials. Bones of several bodies are one where they have one name; the first body's bind pose counts.
/// Triangles keep the files' order.
class SmdModelBuilder {
  public:
    /// Errors: places too large to compute with.
    Result<void> addBody(const SmdFile& smd, const SmdSpace& space, const std::string& file);

    bool hasTriangles() const { return soup_.triangleCount() > 0; }
    void buildMesh();

    /// What is wrong becomes a warning.
    void addFlexes(std::size_t body, const VtaFile& vta, std::span<const QcFlex> flexes,
                   const std::string& file);

    /// Pairs `clip` of an animation file with the model's bones. What is wrong becomes a warning.
    void addClip(Clip clip, const Skeleton& skeleton, const std::string& file);

    Diagnostics& warnings() { return model_.warnings; }
    const std::vector<ClipPtr>& clips() const { return model_.clips; }

    /// Gives the model its materials, with pictures if `textures` finds them.
    ImportedModel finish(TextureFinder* textures);

  private:
    struct Body {
        glm::dmat4 toObject;
        std::uint32_t firstBinding, lastBinding; ///< Of its own, the last excluded.
    };

    std::vector<std::uint32_t> joinBones(const SmdSkeleton& own);
    void addBindings(const SmdFile& smd, const std::vector<std::uint32_t>& bones);
    void addTriangles(const SmdFile& smd, const glm::dmat4& toObject);
    void rebind(const SmdFile& smd, const SmdSkeleton& own, const std::vector<std::uint32_t>& bones);
    std::uint32_t slotOf(const std::string& material);

    TriangleSoup soup_;
    SmdBindings bindings_;
    SmdSkeleton skeleton_;
    std::unordered_map<std::string, std::uint32_t> boneOfName_;
    std::vector<std::string> slots_;
    std::unordered_map<std::string, std::uint32_t> slotOfName_;
    std::vector<Body> bodies_;
    Mesh mesh_;
    std::vector<std::uint32_t> bindingOfVertex_;
    ImportedModel model_;
};

} // namespace prizma
