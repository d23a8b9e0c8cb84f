#pragma once

#include "core/diagnostic.h"

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace prizma {

/// A picture that an MTL file names, with those of its options that matter.
struct MtlMap {
    std::string file;       ///< As written.
    double bumpScale = 1.0; ///< -bm
    bool isPlaced = false;  ///< -o, -s or -t move or scale it.

    bool isSet() const { return !file.empty(); }
};

/// A material of an MTL file (Alias|Wavefront, File Formats 4.2, 1995; the keywords of physically based
/// materials are Exocortex's, 2014). What the file does not say is not there.
struct MtlMaterial {
    std::optional<glm::dvec3> diffuse, specular, emission, filter;          // Kd, Ks, Ke, Tf
    std::optional<double> shininess, ior, dissolve, transparency;           // Ns, Ni, d, Tr
    std::optional<double> roughness, metallic;                              // Pr, Pm
    std::optional<int> illumination;                                        // illum
    MtlMap diffuseMap, specularMap, shininessMap, emissionMap, dissolveMap; // map_Kd, _Ks, _Ns, _Ke, _d
    MtlMap roughnessMap, metallicMap, bumpMap, normalMap;                   // map_Pr, _Pm, bump, norm
};

/// The materials of an MTL file's text by their names. Two of one name are one, as for assimp; what is not
/// understood is passed over.
std::map<std::string, MtlMaterial> readMtl(std::string_view text);

} // namespace prizma
