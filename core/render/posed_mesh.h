#pragma once

#include "core/render/renderer.h"

#include <string>

namespace prizma {

/// An object's mesh as the device computed it: in its pose at the scene's time, in object space.
struct PosedMesh {
    MeshPtr mesh; ///< Triangles, slots and texture coordinates; its vertices are in the bind pose.
    std::vector<glm::vec3> positions, normals; ///< One a vertex.
};

/// Brings the renderer's device to `scene`, without drawing, and reads an object's vertices back. Errors: the
/// object has no mesh or is hidden, a fault of the device.
Result<PosedMesh> computePosedMesh(Renderer& renderer, const Scene& scene, Id object);

/// `object` standing still at a frame of a clip (a real number; empty: the bind pose). Errors: no such clip,
/// a frame before the first or after the last.
Result<Object> holdFrame(Object object, const std::string& clip, double frame);

/// One line `x,y,z` a corner of a triangle, in the order of the mesh, all transformed by `toFile`.
std::string formatCsv(const PosedMesh& mesh, const glm::dmat4& toFile);

/// A Wavefront OBJ in object space, a group a material slot.
std::string formatObj(const PosedMesh& mesh, const std::string& name);

} // namespace prizma
