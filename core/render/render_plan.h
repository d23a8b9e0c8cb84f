#pragma once

#include "core/animation/pose_key.h"
#include "core/scene/diff.h"
#include "core/scene/hierarchy.h"
#include "core/scene/scene.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace prizma {

/// The steps that make a picture, in the order in which they run.
enum class Stage {
    Geometry,           ///< Upload a mesh and its tree.
    Textures,           ///< Upload pictures.
    Materials,          ///< Upload the material table.
    Lights,             ///< Upload the light table.
    NewTrees,           ///< Upload trees that were built anew for poses that had worn the old ones out.
    Poses,              ///< Evaluate clips, on the host.
    VertexShader,       ///< Pose the vertices of Dynamic objects.
    TriangleShader,     ///< Put their triangles into the leaves.
    RefitTreeShader,    ///< Refit their trees.
    TopLevel,           ///< Upload the instances and build the tree over them.
    LightTree,          ///< Build the tree over lights and emissive triangles.
    Background,         ///< Make the table that the background's picture is sampled with.
    GenerateCameraRays, ///< And find their first hits.
    RayShader,
    Display, ///< Tone mapping.
};

/// As shown in the statistics.
std::string describe(Stage stage);

struct PlannedStage {
    Stage stage = Stage::RayShader;
    std::string why;
    std::vector<Id> objects; ///< Which objects it is about; empty if it is about none or all.

    friend bool operator==(const PlannedStage&, const PlannedStage&) = default;
};

/// What the device holds.
struct DeviceState {
    std::optional<Scene>
        scene;             ///< What the buffers were last brought up to; nothing at first and after a fault.
    std::set<Id> resident; ///< Objects whose geometry is there.
    std::map<Id, PoseKey> poses; ///< What the resident Dynamic objects were last posed with.
    std::set<Id> newTrees;       ///< Posed objects for which a better tree is ready, on the host.
    glm::dvec3 anchor{0.0};      ///< World position that everything is relative to.
    int width = 0, height = 0;   ///< Of the picture.
    int samples = 0;             ///< Whole samples that its pixels hold.
    bool dropped = false;        ///< A pass was left half done: the picture is no use.
};

/// What has to be done next, and why. Without stages there is nothing to do: no kernel is launched.
struct RenderPlan {
    std::vector<PlannedStage> stages;
    bool restarts = false; ///< The picture begins anew with its first sample.
    glm::dvec3 anchor{0.0};

    bool isEmpty() const { return stages.empty(); }
    const PlannedStage* find(Stage stage) const;
};

/// The least that brings the device from what it holds to the next sample of `next` at width × height pixels.
/// A pure function. Objects without a mesh (still loading, still building) are not drawn.
RenderPlan makePlan(const DeviceState& held, const Scene& next, int width, int height);

/// Whether an object takes part in the picture; `hierarchy` is its scene's.
bool isDrawn(const Hierarchy& hierarchy, const Object& object);
bool drawsAnything(const Scene& scene);

/// Device coordinates are floats relative to an anchor near the camera. The anchor stays while the camera
/// moves about its target (so that orbiting touches no buffer), and follows once it is more than four times
/// as far from the camera as the target is.
glm::dvec3 chooseAnchor(const std::optional<glm::dvec3>& present, const Camera& camera);

} // namespace prizma
