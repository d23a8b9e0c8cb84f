#include "core/render/posed_mesh.h"

#include "core/animation/clip_time.h"
#include "core/animation/pose_key.h"

#include <fmt/format.h>

#include <iterator>

namespace prizma {

Result<PosedMesh> computePosedMesh(Renderer& renderer, const Scene& scene, Id object) {
    const Object* posed = scene.findObject(object);
    if (!posed || !isDrawn(Hierarchy(scene), *posed))
        return failure("There is no visible object with a mesh to pose.");
    renderer.waitForTrees(scene);
    const Scene drawn = renderer.drawable(scene);
    if (auto ok = renderer.begin(renderer.plan(drawn, 1, 1), drawn, 1, 1); !ok)
        return std::unexpected(ok.error());
    renderer.drop();
    auto vertices = renderer.deviceScene().vertices(object);
    if (!vertices)
        return std::unexpected(vertices.error());
    return PosedMesh{posed->mesh, std::move(vertices->positions), std::move(vertices->normals)};
}

Result<Object> holdFrame(Object object, const std::string& clipName, double frame) {
    object.clip = clipName;
    object.playback = {};
    if (clipName.empty())
        return object;
    const ClipPtr clip = findClip(object, clipName);
    if (!clip) {
        std::string all;
        for (const ClipPtr& other : object.clips)
            all += (all.empty() ? "" : ", ") + other->name;
        return failure("\"" + object.name + "\" has no clip \"" + clipName + "\"" +
                       (all.empty() ? ", nor any other." : ". It has: " + all + "."));
    }
    const int last = keyCount(*clip) - 1;
    if (!(frame >= 0.0 && frame <= last))
        return failure(
            fmt::format("The frames of \"{}\" are 0 to {}; there is no frame {}.", clipName, last, frame));
    // At one frame a second a second is a frame, exactly.
    object.playback.fps = 1.0;
    object.playback.offset = frame;
    object.playback.speed = 0.0;
    object.playback.loop = LoopMode::Once;
    return object;
}

std::string formatCsv(const PosedMesh& mesh, const glm::dmat4& toFile) {
    std::string text;
    for (const glm::uvec3& triangle : mesh.mesh->triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 p(toFile * glm::dvec4(glm::dvec3(mesh.positions[triangle[corner]]), 1.0));
            fmt::format_to(std::back_inserter(text), "{:.9g},{:.9g},{:.9g}\n", p.x, p.y, p.z);
        }
    return text;
}

std::string formatObj(const PosedMesh& posed, const std::string& name) {
    const Mesh& mesh = *posed.mesh;
    std::string text = fmt::format("o {}\n", name);
    const auto out = std::back_inserter(text);
    for (const glm::vec3& p : posed.positions)
        fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const glm::vec2& t : mesh.texCoords)
        fmt::format_to(out, "vt {:.9g} {:.9g}\n", t.x, t.y);
    for (const glm::vec3& n : posed.normals)
        fmt::format_to(out, "vn {:.6g} {:.6g} {:.6g}\n", n.x, n.y, n.z);
    for (std::uint32_t slot = 0; slot < mesh.slots.size(); ++slot) {
        fmt::format_to(out, "g {0}\nusemtl {0}\n", mesh.slots[slot]);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            if (mesh.triangleSlots[i] != slot)
                continue;
            text += 'f';
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t v = mesh.triangles[i][corner] + 1;
                if (mesh.texCoords.empty())
                    fmt::format_to(out, " {0}//{0}", v);
                else
                    fmt::format_to(out, " {0}/{0}/{0}", v);
            }
            text += '\n';
        }
    }
    return text;
}

} // namespace prizma
