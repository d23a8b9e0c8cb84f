#pragma once

#include "core/scene/id.h"

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <variant>

namespace prizma {

/// What a shader of the project's own takes the place of.
enum class ShaderKind {
    Ray,   ///< The radiance of a pixel; the scene uses one (RenderSettings::customShader).
    Vertex ///< Where the vertices of an object go; each object may use one (Object::vertexShader).
};

/// A program of the project's own, in OpenCL C.
struct Shader {
    Id id = noId;
    std::string name;
    ShaderKind kind = ShaderKind::Ray;
    std::string source; ///< UTF-8; what kernels/shader_api.clh and vertex_shader_api.clh declare is at hand.
    std::string file;   ///< Absolute path of the .cl file it is kept in; empty: in the project file.

    friend bool operator==(const Shader&, const Shader&) = default;
};

/// The value of a parameter that a shader declares; whole numbers are stored as numbers.
using ShaderValue = std::variant<bool, double, glm::dvec3>;

/// Values by the parameter's name, kept where the shader is used: one shader may serve several objects, each
/// with its own. Those left out have the default that the shader declares.
using ShaderValues = std::map<std::string, ShaderValue>;

} // namespace prizma
