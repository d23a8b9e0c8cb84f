#include "core/bench/scene_export.h"

#include "core/scene/hierarchy.h"

#include <fmt/os.h>

#include <system_error>

namespace prizma::bench {
namespace {

void writeMeshes(const Scene& scene, fmt::ostream& out) {
    std::size_t first = 1; // OBJ counts from 1
    const Hierarchy hierarchy(scene);
    for (const Object& object : scene.objects) {
        if (!object.mesh || !hierarchy.isShown(object))
            continue;
        const glm::dmat4 matrix = hierarchy.worldMatrix(object);
        out.print("o {}\n", object.name);
        for (const glm::vec3& position : object.mesh->positions) {
            const glm::dvec3 p(matrix * glm::dvec4(glm::dvec3(position), 1.0));
            out.print("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        }
        for (const glm::uvec3& t : object.mesh->triangles)
            out.print("f {} {} {}\n", first + t.x, first + t.y, first + t.z);
        first += object.mesh->positions.size();
    }
}

std::string triple(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

void writeSetup(const Scene& scene, fmt::ostream& out) {
    const Camera& camera = scene.camera;
    out.print("{{\n  \"camera\": {{\"position\": {}, \"target\": {}, \"up\": {}, \"fovY\": {}}},\n",
              triple(camera.position), triple(camera.target), triple(camera.up), camera.fovY);
    const Light light = scene.lights.size() > 0 ? lightsInWorld(scene)[0] : Light{};
    out.print("  \"light\": {{\"position\": {}, \"intensity\": {}}},\n", triple(light.position),
              light.intensity);
    out.print("  \"background\": {}\n}}\n", triple(scene.background.color * scene.background.intensity));
}

} // namespace

Result<void> exportScene(const Scene& scene, const std::filesystem::path& file) {
    try {
        fmt::ostream model = fmt::output_file(file.string());
        writeMeshes(scene, model);
        fmt::ostream setup = fmt::output_file(file.string() + ".json");
        writeSetup(scene, setup);
    } catch (const std::system_error& error) {
        return failure("The scene cannot be written to " + file.string() + ": " + error.what());
    }
    return {};
}

} // namespace prizma::bench
