#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace prizma {

/// How a property is edited and written. Colours are linear RGB, rotations quaternions, choices their key.
enum class PropertyKind {
    Boolean,
    Integer,
    Number,
    Text,
    Choice,
    Vector2,
    Vector3,
    Color,
    Rotation,
    Texture
};

using PropertyValue =
    std::variant<bool, int, double, std::string, glm::dvec2, glm::dvec3, glm::dquat, Texture>;

/// One possible value of a choice: `key` in files and scripts, `label` on the screen.
struct Choice {
    std::string_view key;
    std::string_view label;
};

/// The one description of a property of `Owner` (Object, Light, Material, Group, Camera, Background,
/// Timeline, RenderSettings). Panels, undo commands, the project file and the command line's --set are driven
/// by it.
template <class Owner>
struct Property {
    std::string_view key;   ///< In project files and --set, e.g. "roughness".
    std::string_view label; ///< English; translated where it is shown.
    std::string_view help;  ///< One sentence, shown as a tool tip.
    PropertyKind kind;
    std::string_view unit = {}; ///< "°", "W/sr", ... or empty.
    double minimum = -1e9;      ///< Of the number, or of each component.
    double maximum = 1e9;
    double step = 0.1; ///< A sensible step for arrow keys.
    std::span<const Choice> choices = {};
    PropertyValue (*get)(const Owner&) = nullptr;
    void (*set)(Owner&, const PropertyValue&) = nullptr; ///< The value must have passed `checkValue`.
    bool (*applies)(const Owner&) = nullptr; ///< Null: always. E.g. a radius is for sphere lights only.
    std::string_view section = {}; ///< English heading under which panels show it; neighbours share one.
};

template <class Owner>
std::span<const Property<Owner>> propertiesOf();

enum class EntityKind { Object, Light, Material, Group, Camera, Background, Timeline, Render };

/// Names one thing in a scene that has properties; `id` counts for objects, lights, materials and groups
/// only.
struct EntityRef {
    EntityKind kind = EntityKind::Camera;
    Id id = noId;

    friend bool operator==(const EntityRef&, const EntityRef&) = default;
};

/// A property without its owner's type: what panels and undo commands work with.
struct PropertyInfo {
    std::string key, label;
    std::string_view help;
    PropertyKind kind = PropertyKind::Number;
    std::string_view unit;
    double minimum = 0.0, maximum = 0.0, step = 0.0;
    std::span<const Choice> choices;
    bool applies = true; ///< To this entity as it is now.
    PropertyValue value;
    PropertyValue defaultValue;
    std::string_view section = {};
};

/// All properties of an entity with their present values; empty if the scene has no such entity. An object
/// has one more for each of its mesh's morph targets, "morph:" and the target's name: its weight.
std::vector<PropertyInfo> properties(const Scene& scene, EntityRef entity);

/// Reads or writes one property. Errors: unknown entity or key, a value of the wrong type or that is not
/// finite. Numbers outside of the range are clamped into it.
Result<PropertyValue> getProperty(const Scene& scene, EntityRef entity, std::string_view key);
Result<void> setProperty(Scene& scene, EntityRef entity, std::string_view key, const PropertyValue& value);

/// Whether a property of objects, by its key, is the name of one of the object's own clips. Its kind is Text,
/// as projects may name clips that could not be loaded; --set and panels offer what there is.
bool namesClip(std::string_view key);

/// Whether the scene has it; camera, background, timeline and render settings always are there.
bool exists(const Scene& scene, EntityRef entity);

/// The name of an object, light, material or group; "Camera", "Background", ... for the rest.
std::string displayName(const Scene& scene, EntityRef entity);

/// Carries out "lights.key.intensity=80", "camera.fovY=30", "materials.floor.baseColor=0.8,0.8,0.8":
/// what --set takes. Names may hold dots; the key is what follows the last one before the equals sign, or the
/// "morph:" of "objects.face.morph:eye.left=0.5".
Result<void> applyAssignment(Scene& scene, std::string_view assignment);

} // namespace prizma
