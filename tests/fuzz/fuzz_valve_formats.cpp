// Feeds one text to every reader of Valve's formats, and what they read to everything that is made of it.
// Built with libFuzzer (clang), or with mutate_corpus.cpp by any compiler.
#include "core/import/clip_pairing.h"
#include "core/import/qc_reader.h"
#include "core/import/smd_importer.h"
#include "core/import/smd_reader.h"
#include "core/import/text_encoding.h"
#include "core/import/vta_morphs.h"
#include "core/import/vta_reader.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace prizma;

namespace {

void require(bool truth, const char* what) {
    if (truth)
        return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

void requireError(const Diagnostic& error) {
    require(!error.message.empty(), "an error without words");
}

/// A mesh as the importer hands it to the scene: sound, or with numbers too large, which importModel rejects.
void requireSound(const Mesh& mesh) {
    const std::string fault = findFault(mesh);
    require(fault.empty() || fault.find("finite") != std::string::npos, fault.c_str());
}

void readSmdText(const std::string& text) {
    Progress progress;
    isSmdAnimation(text);
    const auto smd = readSmd(text, "fuzz.smd", ProgressPart(progress));
    if (!smd)
        return requireError(smd.error());
    Diagnostics warnings;
    const auto skeleton = makeSmdSkeleton(*smd, {}, "fuzz.smd", warnings);
    if (skeleton) {
        if (auto clip = makeSmdClip(*smd, {}, "fuzz.smd", warnings)) {
            for (const BoneTrack& track : clip->tracks)
                require(track.frames.size() == static_cast<std::size_t>(clip->frameCount), "a short track");
            const BonePairing pairing(skeleton->skeleton, skeleton->skeleton);
            for (const BoneTrack& track : pairing.apply(std::move(*clip)).tracks)
                require(static_cast<std::size_t>(track.bone) < smd->bones.size(), "a track of no bone");
        }
    }
    const auto model = buildSmdModel(*smd, "fuzz.smd", {UpAxis::Z, 1.0});
    if (!model)
        return requireError(model.error());
    require(model->mesh->triangles.size() * 3 == smd->corners.size(), "triangles are lost");
    requireSound(*model->mesh);
}

/// The mesh is the file's own unmoved shape.
void readVtaText(const std::string& text) {
    Progress progress;
    const auto vta = readVta(text, "fuzz.vta", ProgressPart(progress));
    if (!vta)
        return requireError(vta.error());
    Mesh mesh;
    std::vector<std::uint32_t> candidates;
    for (const VtaVertex& vertex : vta->frames.front().vertices) {
        candidates.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(vertex.position);
        mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
    }
    mesh.triangles.assign(mesh.positions.empty() ? 0 : 1, glm::uvec3(0));
    mesh.triangleSlots.assign(mesh.triangles.size(), 0);
    mesh.slots = {"slot"};
    Diagnostics warnings;
    auto targets = makeMorphTargets(*vta, {}, mesh, candidates, glm::dmat4(1.0), "fuzz.vta", warnings);
    if (!targets)
        return requireError(targets.error());
    mesh.morphTargets = std::move(*targets);
    if (!mesh.triangles.empty())
        requireSound(mesh);
}

void readQcText(const std::string& text) {
    int includes = 0;
    const auto qc = readQc({"fuzz.qc", text}, [&](const std::string& name) -> Result<QcScript> {
        if (++includes > 3)
            return failure("enough");
        return QcScript{name, text.substr(std::min(name.size() * 5, text.size()))};
    });
    if (!qc)
        return requireError(qc.error());
    for (const QcSequence& sequence : qc->sequences)
        require(sequence.fps > 0.0 && sequence.scale > 0.0 &&
                    (!sequence.frames || sequence.frames->first <= sequence.frames->second),
                "a sequence that cannot be");
    for (const QcBody& body : qc->bodies)
        require(body.scale > 0.0, "a body without size");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const auto text = toUtf8(std::string(reinterpret_cast<const char*>(data), size));
    if (!text)
        return 0;
    readSmdText(*text);
    readVtaText(*text);
    readQcText(*text);
    return 0;
}
