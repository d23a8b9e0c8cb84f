#pragma once

#include "core/scene/scene.h"

#include <cstddef>

namespace prizma::bench {

enum class ProceduralForm {
    OneMesh,  ///< Everything merged into one object.
    Instances ///< The room and nine objects that share three meshes.
};

/// Of the scene that is measured when nobody says otherwise.
inline constexpr std::size_t proceduralTriangles = 804612;

/// A closed room with nine bumpy things of three kinds in it, and a camera inside that sees most of them. The
/// scene that is measured when nobody names a file; the same each time. `triangles` is about how many it has.
Scene makeProceduralScene(ProceduralForm form, std::size_t triangles = proceduralTriangles);

} // namespace prizma::bench
