#pragma once

#include "core/scene/clip.h"
#include "core/scene/id.h"
#include "core/scene/mesh.h"
#include "core/scene/playback.h"
#include "core/scene/shader.h"
#include "core/scene/transform.h"

#include <map>
#include <string>
#include <vector>

namespace prizma {

enum class UpAxis { Y, Z };

enum class PrimitiveType { Plane, Cube, Sphere, Cylinder, Torus };

/// Where an object's mesh comes from: a model file (with the options it was read with) or a primitive.
/// It is what the project file stores instead of the mesh.
struct MeshSource {
    std::string file; ///< Absolute path; empty for a primitive.
    UpAxis upAxis = UpAxis::Y;
    double unitScale = 1.0; ///< Scene units a unit of the file.

    PrimitiveType primitive = PrimitiveType::Cube;
    double size = 1.0; ///< Edge length or diameter.

    bool isPrimitive() const { return file.empty(); }

    friend bool operator==(const MeshSource&, const MeshSource&) = default;
};

/// A mesh placed in the world. Objects may share a mesh; each is one instance under the top level.
struct Object {
    Id id = noId;
    std::string name;
    MeshSource source;
    MeshPtr mesh;              ///< Null while it is being loaded, or if that failed.
    Id parent = noId;          ///< The group it hangs under.
    Transform transform;       ///< To the space of its group; without one, to world space.
    std::vector<Id> materials; ///< One a slot of the mesh.
    bool visible = true;
    bool seenByCamera = true;      ///< Camera rays meet it.
    bool seenInReflections = true; ///< Rays that were reflected or refracted meet it.
    bool castsShadows = true;      ///< Shadow rays meet it.
    bool dynamic = false;          ///< Its vertices move (thesis: Static or Dynamic).

    std::vector<std::string>
        clipFiles; ///< Absolute paths of the animation files brought in beside the model.
    std::vector<ClipPtr> clips;
    std::string clip; ///< Name of the clip that plays; empty for the bind pose.
    Playback playback;
    std::map<std::string, double> morphWeights; ///< By the morph target's name; those left out are 0.

    Id vertexShader = noId;    ///< A shader of the project's own that moves its vertices.
    ShaderValues shaderValues; ///< Of the vertex shader's parameters.

    friend bool operator==(const Object&, const Object&) = default;
};

/// The box of the object's mesh as it was modelled, in the space of its group (core/animation/posed_bounds.h
/// has the one of its pose in world space); empty without a mesh.
DBounds bindPoseBounds(const Object& object);

/// `box` after `toWorld`, as the box of its eight corners; empty if it is empty.
DBounds transformed(const Bounds& box, const glm::dmat4& toWorld);

} // namespace prizma
