#pragma once

#include "core/scene/object.h"

namespace prizma {

/// The mesh of a primitive of diameter or edge length `size` (plane: in XZ, facing +Y), centred on the
/// origin, with smooth normals where it is round and texture coordinates. Equal arguments give an equal mesh.
MeshPtr makePrimitive(PrimitiveType type, double size);

} // namespace prizma
