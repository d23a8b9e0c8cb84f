#pragma once

#include "core/scene/scene.h"

namespace prizma::bench {

enum class ProceduralForm {
    OneMesh,  ///< Everything merged into one object.
    Instances ///< The room and nine objects that share three meshes.
};

/// About 800,000 triangles: a closed room with nine bumpy things of three kinds in it, and a camera inside
/// that sees most of them. The scene that is measured when nobody names a file; the same each time.
Scene makeProceduralScene(ProceduralForm form);

} // namespace prizma::bench
