#include "core/import/smd_model_builder.h"

#include "core/import/clip_pairing.h"
#include "core/import/color_words.h"
#include "core/import/fault_tally.h"
#include "core/import/file_space.h"
#include "core/import/vta_morphs.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr std::size_t mostTriangles =
    20'000'000;                        ///< Of all bodies together, which may be one file many times.
constexpr double creaseDegrees = 40.0; ///< Where a file has no normals.

bool isIdentity(const glm::dmat4& matrix, double tolerance) {
    double most = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            most = std::max(most, std::abs(matrix[column][row] - (column == row ? 1.0 : 0.0)));
    return most <= tolerance;
}

void append(Diagnostics& list, Diagnostics more) {
    list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

Result<void> SmdModelBuilder::addBody(const SmdFile& smd, const SmdSpace& space, const std::string& file) {
    if (smd.triangleMaterials.size() + soup_.triangleCount() > mostTriangles)
        return failure("The model has too many triangles.", file);
    append(warnings(), smd.warnings);
    const auto own = makeSmdSkeleton(smd, space, file, warnings());
    if (!own)
        return std::unexpected(own.error());
    const auto bones = joinBones(*own);
    const auto first = static_cast<std::uint32_t>(bindings_.size());
    addBindings(smd, bones);
    const glm::dmat4 toObject = fileToObject(space.upAxis, space.scale);
    bodies_.push_back({toObject, first, static_cast<std::uint32_t>(bindings_.size())});
    addTriangles(smd, toObject);
    if (bodies_.size() > 1)
        rebind(smd, *own, bones);
    return {};
}

/// The joint skeleton's bone for each of a body's own; those it lacks are added.
std::vector<std::uint32_t> SmdModelBuilder::joinBones(const SmdSkeleton& own) {
    const bool isFirst = bodies_.empty(); // whose bones stay apart even if two have one name
    std::vector<std::uint32_t> joint;
    for (std::size_t i = 0; i < own.skeleton.bones.size(); ++i) {
        Bone bone = own.skeleton.bones[i];
        const auto next = static_cast<std::uint32_t>(skeleton_.skeleton.bones.size());
        const auto [known, isNew] = boneOfName_.try_emplace(bone.name, next);
        if (!isNew && !isFirst) {
            joint.push_back(known->second);
            continue;
        }
        const glm::dmat4 local =
            bone.parent < 0
                ? own.globals[i]
                : glm::affineInverse(own.globals[static_cast<std::size_t>(bone.parent)]) * own.globals[i];
        glm::dmat4 global = own.globals[i];
        if (bone.parent >= 0) {
            bone.parent = static_cast<int>(joint[static_cast<std::size_t>(bone.parent)]);
            global = skeleton_.globals[static_cast<std::size_t>(bone.parent)] * local;
        }
        if (!isFirst)
            bone.inverseBind = glm::mat4(glm::affineInverse(global));
        skeleton_.globals.push_back(global);
        skeleton_.skeleton.bones.push_back(std::move(bone));
        joint.push_back(next);
    }
    return joint;
}

void SmdModelBuilder::addBindings(const SmdFile& smd, const std::vector<std::uint32_t>& bones) {
    std::vector<BoneInfluence> list;
    for (std::size_t i = 0; i < smd.bindings.size(); ++i) {
        list.clear();
        for (const BoneInfluence& influence : smd.bindings[i])
            list.push_back({bones[influence.bone], influence.weight});
        bindings_.add(list);
    }
}

void SmdModelBuilder::addTriangles(const SmdFile& smd, const glm::dmat4& toObject) {
    const std::uint32_t firstBinding = bodies_.back().firstBinding;
    const glm::dmat3 linear(toObject); // a turn and an even scale: right for normals, which are normalised
    std::vector<std::uint32_t> slots;
    for (const std::string& material : smd.materials)
        slots.push_back(slotOf(material));
    soup_.reserve(soup_.triangleCount() + smd.triangleMaterials.size());
    soup_.hasTexCoords = true;
    for (const SmdCorner& corner : smd.corners) {
        soup_.positions.emplace_back(toObject * glm::dvec4(corner.position, 1.0));
        soup_.normals.emplace_back(linear * glm::dvec3(corner.normal));
        soup_.texCoords.push_back(corner.texCoord);
        soup_.sourceVertices.push_back(firstBinding + corner.binding);
    }
    for (const std::uint32_t material : smd.triangleMaterials)
        soup_.slots.push_back(slots[material]);
}

/// A body whose bind pose is not the joint one is posed like that one.
void SmdModelBuilder::rebind(const SmdFile& smd, const SmdSkeleton& own,
                             const std::vector<std::uint32_t>& bones) {
    constexpr double tolerance = 1e-5;
    std::vector<glm::dmat4> toJoint;
    bool moves = false;
    for (std::size_t i = 0; i < bones.size(); ++i) {
        toJoint.push_back(skeleton_.globals[bones[i]] * glm::affineInverse(own.globals[i]));
        moves = moves || !isIdentity(toJoint.back(), tolerance);
    }
    if (!moves)
        return;
    const std::size_t first = soup_.positions.size() - smd.corners.size();
    for (std::size_t i = 0; i < smd.corners.size(); ++i) {
        glm::dmat4 matrix(0.0);
        for (const BoneInfluence& influence : smd.bindings[smd.corners[i].binding])
            matrix += toJoint[influence.bone] * static_cast<double>(influence.weight);
        soup_.positions[first + i] = glm::vec3(matrix * glm::dvec4(soup_.positions[first + i], 1.0));
        soup_.normals[first + i] = glm::vec3(glm::dmat3(matrix) * glm::dvec3(soup_.normals[first + i]));
    }
}

std::uint32_t SmdModelBuilder::slotOf(const std::string& material) {
    const std::string name = material.empty() ? "unnamed" : material;
    const auto [found, isNew] = slotOfName_.try_emplace(name, static_cast<std::uint32_t>(slots_.size()));
    if (isNew)
        slots_.push_back(name);
    return found->second;
}

void SmdModelBuilder::buildMesh() {
    BuiltMesh built = prizma::buildMesh(soup_, creaseDegrees);
    soup_ = {};
    mesh_ = std::move(built.mesh);
    bindingOfVertex_ = std::move(built.sourceVertices);
    mesh_.slots = slots_;
    mesh_.firstInfluence.assign(1, 0);
    for (const std::uint32_t binding : bindingOfVertex_) {
        const auto list = bindings_[binding];
        mesh_.influences.insert(mesh_.influences.end(), list.begin(), list.end());
        mesh_.firstInfluence.push_back(static_cast<std::uint32_t>(mesh_.influences.size()));
    }
}

void SmdModelBuilder::addFlexes(std::size_t body, const VtaFile& vta, std::span<const QcFlex> flexes,
                                const std::string& file) {
    append(warnings(), vta.warnings);
    std::vector<std::uint32_t> vertices;
    for (std::size_t i = 0; i < bindingOfVertex_.size(); ++i)
        if (bindingOfVertex_[i] >= bodies_[body].firstBinding &&
            bindingOfVertex_[i] < bodies_[body].lastBinding)
            vertices.push_back(static_cast<std::uint32_t>(i));
    auto targets = makeMorphTargets(vta, flexes, mesh_, vertices, bodies_[body].toObject, file, warnings());
    if (!targets) {
        warnings().push_back(
            {Severity::Warning, "The flexes were left out: " + targets.error().message, file, 0});
        return;
    }
    std::ranges::move(*targets, std::back_inserter(mesh_.morphTargets));
}

void SmdModelBuilder::addClip(Clip clip, const Skeleton& skeleton, const std::string& file) {
    const BonePairing pairing(skeleton, skeleton_.skeleton);
    if (pairing.isEmpty()) {
        warnings().push_back({Severity::Warning,
                              "The animation has no bone in common with the model and was left out.", file,
                              0});
        return;
    }
    clip = pairing.apply(std::move(clip));
    clip.name = freeClipName(model_.clips, clip.name);
    append(warnings(), pairing.warnings(file));
    model_.clips.push_back(std::make_shared<Clip>(std::move(clip)));
}

ImportedModel SmdModelBuilder::finish(TextureFinder* textures) {
    std::vector<std::string> plain;
    for (const std::string& slot : slots_) {
        Material material;
        material.name = slot;
        material.specular = 0.0; // the formats know no shine
        material.baseColor = colorOfName(slot).value_or(material.baseColor);
        if (textures)
            material.baseColorTexture = textures->read(slot, warnings());
        if (material.baseColorTexture.isSet())
            material.baseColor = glm::dvec3(1.0); // it multiplies
        else
            plain.push_back(slot);
        model_.materials.push_back(std::move(material));
    }
    if (textures && !plain.empty())
        warnings().push_back({Severity::Warning,
                              "There are no pictures named like these materials, which got plain colours: " +
                                  listOf(plain) + ".",
                              {},
                              0});
    mesh_.skeleton = std::make_shared<Skeleton>(std::move(skeleton_.skeleton));
    model_.mesh = std::make_shared<Mesh>(std::move(mesh_));
    return std::move(model_);
}

} // namespace prizma
