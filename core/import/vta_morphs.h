#pragma once

#include "core/import/qc_reader.h"
#include "core/import/vta_reader.h"
#include "core/scene/mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace prizma {

/// The shapes of a VTA file as morph targets of `mesh`. Its vertices pair with those of `candidates` (mesh
/// vertices) by their unmoved position, and by the normal where several share one. `flexes` picks shapes and
/// names them; all are taken if it is empty. `toObject` turns the file's axes and units. Errors: the file has
/// nothing in common with the mesh, or moves absurdly many vertices.
Result<std::vector<MorphTarget>> makeMorphTargets(const VtaFile& vta, std::span<const QcFlex> flexes,
                                                  const Mesh& mesh, std::span<const std::uint32_t> candidates,
                                                  const glm::dmat4& toObject, const std::string& file,
                                                  Diagnostics& warnings);

} // namespace prizma
