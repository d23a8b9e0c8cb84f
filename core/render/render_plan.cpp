#include "core/render/render_plan.h"

#include "core/render/emissive_objects.h"

#include <algorithm>

namespace prizma {
namespace {

/// Collects the stages; remembers only the first reason for each.
class PlanBuilder {
  public:
    void need(Stage stage, const std::string& why, std::vector<Id> objects = {}) {
        const auto [found, inserted] = stages_.try_emplace(stage, PlannedStage{stage, why, {}});
        auto& all = found->second.objects;
        all.insert(all.end(), objects.begin(), objects.end());
    }

    /// A picture that has to begin anew.
    void restart(const std::string& why) {
        if (!restarts_)
            need(Stage::GenerateCameraRays, why);
        restarts_ = true;
    }

    bool restarts() const { return restarts_; }

    std::vector<PlannedStage> take() {
        std::vector<PlannedStage> list;
        for (auto& [stage, planned] : stages_) {
            std::sort(planned.objects.begin(), planned.objects.end());
            planned.objects.erase(std::unique(planned.objects.begin(), planned.objects.end()),
                                  planned.objects.end());
            list.push_back(std::move(planned));
        }
        return list;
    }

  private:
    std::map<Stage, PlannedStage>
        stages_; ///< In the order of the enumeration, which is the order they run in.
    bool restarts_ = false;
};

std::vector<Id> drawnIds(const Scene& scene) {
    const Hierarchy hierarchy(scene);
    std::vector<Id> ids;
    for (const Object& object : scene.objects)
        if (isDrawn(hierarchy, object))
            ids.push_back(object.id);
    return ids;
}

void planGeometry(const DeviceState& held, const Scene& next, const SceneDiff& changes, PlanBuilder& plan) {
    std::set<Id> changed(changes.meshesChanged.begin(), changes.meshesChanged.end());
    const Hierarchy hierarchy(next);
    std::vector<Id> missing;
    for (const Object& object : next.objects)
        if (isDrawn(hierarchy, object) && (!held.resident.contains(object.id) || changed.contains(object.id)))
            missing.push_back(object.id);
    if (!missing.empty())
        plan.need(Stage::Geometry, "model added", missing);
}

void planPoses(const DeviceState& held, const Scene& next, const SceneDiff& changes, PlanBuilder& plan) {
    const Hierarchy hierarchy(next);
    std::vector<Id> moving;
    for (const Object& object : next.objects) {
        if (!isDrawn(hierarchy, object) || !isPosed(object))
            continue;
        const auto pose = held.poses.find(object.id);
        const bool fresh =
            pose == held.poses.end() || std::ranges::count(changes.meshesChanged, object.id) > 0;
        if (fresh || pose->second != poseKeyOf(object, next.timeline.seconds()))
            moving.push_back(object.id);
    }
    if (moving.empty())
        return;
    for (const Stage stage :
         {Stage::Poses, Stage::VertexShader, Stage::TriangleShader, Stage::RefitTreeShader})
        plan.need(stage, changes.time ? "time changed" : "pose changed", moving);
    plan.need(Stage::TopLevel, "pose changed");
    plan.restart("pose changed");
}

/// A better tree shows the same picture, so that nothing restarts.
void planNewTrees(const DeviceState& held, const Scene& next, PlanBuilder& plan) {
    const Hierarchy hierarchy(next);
    std::vector<Id> objects;
    for (const Object& object : next.objects)
        if (held.newTrees.contains(object.id) && isDrawn(hierarchy, object) && isPosed(object))
            objects.push_back(object.id);
    if (objects.empty())
        return;
    for (const Stage stage : {Stage::NewTrees, Stage::TriangleShader, Stage::RefitTreeShader})
        plan.need(stage, "tree built anew", objects);
    plan.need(Stage::TopLevel, "tree built anew");
}

void planTopLevel(const Scene& before, const Scene& next, const SceneDiff& changes, PlanBuilder& plan) {
    const Hierarchy hierarchy(next);
    const auto touchesDrawn = [&](const std::vector<Id>& ids) {
        return std::any_of(ids.begin(), ids.end(), [&](Id id) {
            const Object* object = next.findObject(id);
            return object && isDrawn(hierarchy, *object);
        });
    };
    const auto need = [&](const char* why) {
        plan.need(Stage::TopLevel, why);
        plan.restart(why);
    };
    if (drawnIds(before) != drawnIds(next))
        need("objects shown or hidden");
    if (touchesDrawn(changes.objectsMoved))
        need("object moved");
    if (touchesDrawn(changes.meshesChanged))
        need("model changed");
    if (touchesDrawn(changes.materialsAssigned))
        need("material assigned");
}

void planTables(const SceneDiff& changes, PlanBuilder& plan) {
    if (changes.textures) {
        plan.need(Stage::Textures, "texture changed");
        plan.need(Stage::Materials, "texture changed");
        plan.restart("texture changed");
    }
    if (changes.materials) {
        plan.need(Stage::Materials, "material changed");
        plan.restart("material changed");
    }
    if (changes.lights) {
        plan.need(Stage::Lights, "light changed");
        plan.need(Stage::LightTree, "light changed");
        plan.restart("light changed");
    }
    if (changes.background) {
        plan.need(Stage::Background, "background changed");
        plan.restart("background changed");
    }
    if (changes.settings)
        plan.restart("shader changed");
    if (changes.camera)
        plan.restart("camera moved");
}

/// Emissive objects are lights.
void planEmitters(const Scene& before, const Scene& next, PlanBuilder& plan) {
    if (before.objects.shares(next.objects) && before.materials.shares(next.materials) &&
        before.groups.shares(next.groups))
        return;
    if (emissiveObjects(before) != emissiveObjects(next))
        plan.need(Stage::LightTree, "emissive object changed");
}

void planEverything(const Scene& next, PlanBuilder& plan) {
    const std::string why = "first picture";
    const auto drawn = drawnIds(next);
    if (!drawn.empty())
        plan.need(Stage::Geometry, why, drawn);
    for (const Stage stage : {Stage::Textures, Stage::Materials, Stage::Lights, Stage::TopLevel,
                              Stage::LightTree, Stage::Background})
        plan.need(stage, why);
    plan.restart(why);
}

} // namespace

std::string describe(Stage stage) {
    switch (stage) {
    case Stage::Geometry:
        return "Geometry";
    case Stage::Textures:
        return "Textures";
    case Stage::Materials:
        return "Materials";
    case Stage::Lights:
        return "Lights";
    case Stage::NewTrees:
        return "New trees";
    case Stage::Poses:
        return "Poses";
    case Stage::VertexShader:
        return "VertexShader";
    case Stage::TriangleShader:
        return "TriangleShader";
    case Stage::RefitTreeShader:
        return "RefitTreeShader";
    case Stage::TopLevel:
        return "Top level";
    case Stage::LightTree:
        return "Light tree";
    case Stage::Background:
        return "Background";
    case Stage::GenerateCameraRays:
        return "GenerateCameraRays";
    case Stage::RayShader:
        return "RayShader";
    case Stage::Display:
        return "Display";
    }
    return {};
}

const PlannedStage* RenderPlan::find(Stage stage) const {
    const auto found =
        std::find_if(stages.begin(), stages.end(), [&](const PlannedStage& p) { return p.stage == stage; });
    return found == stages.end() ? nullptr : &*found;
}

bool isDrawn(const Hierarchy& hierarchy, const Object& object) {
    return object.mesh && hierarchy.isShown(object);
}

bool drawsAnything(const Scene& scene) {
    return !drawnIds(scene).empty();
}

glm::dvec3 chooseAnchor(const std::optional<glm::dvec3>& present, const Camera& camera) {
    const double reach = 4.0 * glm::length(camera.target - camera.position);
    if (present && glm::length(camera.position - *present) <= reach)
        return *present;
    return camera.position;
}

RenderPlan makePlan(const DeviceState& held, const Scene& next, int width, int height) {
    PlanBuilder plan;
    RenderPlan result;
    result.anchor = chooseAnchor(held.scene ? std::optional(held.anchor) : std::nullopt, next.camera);
    bool exposureChanged = false;
    if (!held.scene) {
        planEverything(next, plan);
        planPoses(held, next, {}, plan);
    } else {
        const SceneDiff changes = diff(*held.scene, next);
        planGeometry(held, next, changes, plan);
        planTables(changes, plan);
        planPoses(held, next, changes, plan);
        planTopLevel(*held.scene, next, changes, plan);
        planEmitters(*held.scene, next, plan);
        if (result.anchor != held.anchor) {
            plan.need(Stage::Lights, "camera went far");
            plan.need(Stage::TopLevel, "camera went far");
            plan.need(Stage::LightTree, "camera went far");
            plan.restart("camera went far");
        }
        exposureChanged = changes.exposure;
    }
    planNewTrees(held, next, plan);
    if (width != held.width || height != held.height)
        plan.restart("picture resized");
    if (held.dropped)
        plan.restart("picture was dropped");
    if (!plan.restarts() && held.samples < next.render.samples)
        plan.need(Stage::GenerateCameraRays, "next sample");

    result.restarts = plan.restarts();
    result.stages = plan.take();
    if (const PlannedStage* rays = result.find(Stage::GenerateCameraRays)) {
        const std::string why = rays->why;
        result.stages.push_back({Stage::RayShader, why, {}});
        result.stages.push_back({Stage::Display, why, {}});
    } else if (exposureChanged) {
        result.stages.push_back({Stage::Display, "exposure changed", {}});
    }
    return result;
}

} // namespace prizma
