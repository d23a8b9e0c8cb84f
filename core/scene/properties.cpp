#include "core/scene/properties.h"

#include "core/animation/pose_key.h"
#include "core/scene/hierarchy.h"
#include "core/scene/property_tables.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace prizma {
namespace {

bool isFiniteValue(const PropertyValue& value) {
    return std::visit(
        [](const auto& v) {
            using V = std::decay_t<decltype(v)>;
            if constexpr (std::is_same_v<V, double>)
                return std::isfinite(v);
            else if constexpr (std::is_same_v<V, glm::dvec2>)
                return std::isfinite(v.x) && std::isfinite(v.y);
            else if constexpr (std::is_same_v<V, glm::dvec3>)
                return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
            else if constexpr (std::is_same_v<V, glm::dquat>)
                return std::isfinite(glm::length(v)) && glm::length(v) > 0.0;
            else
                return true;
        },
        value);
}

/// `value` brought into the property's range, or an error if its type or content is wrong.
template <class Owner>
Result<PropertyValue> checkValue(const Property<Owner>& property, PropertyValue value) {
    const std::string key(property.key);
    if (value.index() != property.get(Owner{}).index())
        return failure("\"" + key + "\" is of another type");
    if (!isFiniteValue(value))
        return failure("\"" + key + "\" must be finite");
    const double low = property.minimum;
    const double high = property.maximum;
    if (auto* number = std::get_if<double>(&value))
        *number = std::clamp(*number, low, high);
    else if (auto* integer = std::get_if<int>(&value))
        *integer = static_cast<int>(std::clamp(static_cast<double>(*integer), low, high));
    else if (auto* pair = std::get_if<glm::dvec2>(&value))
        *pair = glm::clamp(*pair, low, high);
    else if (auto* triple = std::get_if<glm::dvec3>(&value))
        *triple = glm::clamp(*triple, low, high);
    else if (property.kind == PropertyKind::Choice) {
        const auto& chosen = std::get<std::string>(value);
        if (std::none_of(property.choices.begin(), property.choices.end(),
                         [&](const Choice& choice) { return choice.key == chosen; }))
            return failure("\"" + chosen + "\" is no possible value of \"" + key + "\"");
    }
    return value;
}

template <class Owner>
const Property<Owner>* findProperty(std::string_view key) {
    const auto all = propertiesOf<Owner>();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.key == key; });
    return found == all.end() ? nullptr : &*found;
}

constexpr std::string_view morphPrefix = "morph:";
constexpr double largestMorphWeight = 2.0;

/// The morph target that a key names, if the object has it.
std::optional<std::string> morphTargetOf(const Object& object, std::string_view key) {
    if (object.mesh && key.starts_with(morphPrefix))
        for (const MorphTarget& target : object.mesh->morphTargets)
            if (target.name == key.substr(morphPrefix.size()))
                return target.name;
    return std::nullopt;
}

double morphWeight(const Object& object, const std::string& target) {
    const auto found = object.morphWeights.find(target);
    return found == object.morphWeights.end() ? 0.0 : found->second;
}

Result<void> setMorphWeight(Object& object, const std::string& target, const PropertyValue& value) {
    const auto* weight = std::get_if<double>(&value);
    if (!weight || !std::isfinite(*weight))
        return failure("the weight of a morph target must be a number");
    if (*weight == 0.0) // as if it had never been set
        object.morphWeights.erase(target);
    else
        object.morphWeights[target] = std::clamp(*weight, -largestMorphWeight, largestMorphWeight);
    return {};
}

void appendMorphs(const Object& object, std::vector<PropertyInfo>& infos) {
    std::set<std::string_view> listed;
    if (object.mesh)
        for (const MorphTarget& target : object.mesh->morphTargets)
            if (listed.insert(target.name).second)
                infos.push_back({std::string(morphPrefix) + target.name,
                                 target.name,
                                 "How far the shape is blended in; 1 is all of it.",
                                 PropertyKind::Number,
                                 {},
                                 -largestMorphWeight,
                                 largestMorphWeight,
                                 0.05,
                                 {},
                                 true,
                                 morphWeight(object, target.name),
                                 0.0,
                                 "Shapes"});
}

/// Calls `visitor` with the entity itself; false if the scene has none such.
template <class Visitor>
bool visitEntity(const Scene& scene, EntityRef entity, Visitor&& visitor) {
    const auto visitPointer = [&](const auto* item) {
        if (item)
            visitor(*item);
        return item != nullptr;
    };
    switch (entity.kind) {
    case EntityKind::Object:
        return visitPointer(scene.findObject(entity.id));
    case EntityKind::Light:
        return visitPointer(scene.findLight(entity.id));
    case EntityKind::Material:
        return visitPointer(scene.findMaterial(entity.id));
    case EntityKind::Group:
        return visitPointer(findGroup(scene, entity.id));
    case EntityKind::Camera:
        return visitPointer(&scene.camera);
    case EntityKind::Background:
        return visitPointer(&scene.background);
    case EntityKind::Timeline:
        return visitPointer(&scene.timeline);
    case EntityKind::Render:
        return visitPointer(&scene.render);
    }
    return false;
}

/// The entity for changing; `entity` is in the scene.
template <class T>
T& editable(CowList<T>& list, Id id) {
    auto& items = list.edit();
    return *std::find_if(items.begin(), items.end(), [id](const T& item) { return item.id == id; });
}

Object& editable(Scene& scene, const Object& item) {
    return editable(scene.objects, item.id);
}
Light& editable(Scene& scene, const Light& item) {
    return editable(scene.lights, item.id);
}
Material& editable(Scene& scene, const Material& item) {
    return editable(scene.materials, item.id);
}
Group& editable(Scene& scene, const Group& item) {
    return editable(scene.groups, item.id);
}
Camera& editable(Scene& scene, const Camera&) {
    return scene.camera;
}
Background& editable(Scene& scene, const Background&) {
    return scene.background;
}
Timeline& editable(Scene& scene, const Timeline&) {
    return scene.timeline;
}
RenderSettings& editable(Scene& scene, const RenderSettings&) {
    return scene.render;
}

Diagnostic noSuchEntity() {
    return {Severity::Error, "it is no longer in the scene", {}, 0};
}

std::optional<double> parseNumber(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

/// "1,2,3" as numbers; nothing if any part is not one.
std::optional<std::vector<double>> parseNumbers(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        const auto comma = text.find(',');
        const auto number = parseNumber(text.substr(0, comma));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        if (comma == std::string_view::npos)
            return numbers;
        text.remove_prefix(comma + 1);
    }
}

std::optional<PropertyValue> parseValue(PropertyKind kind, std::string_view text) {
    if (kind == PropertyKind::Text || kind == PropertyKind::Choice)
        return std::string(text);
    if (kind == PropertyKind::Texture)
        return Texture{std::string(text), nullptr};
    if (kind == PropertyKind::Boolean) {
        if (text == "true" || text == "false")
            return text == "true";
        return std::nullopt;
    }
    const auto numbers = parseNumbers(text);
    if (!numbers)
        return std::nullopt;
    const auto& n = *numbers;
    switch (kind) {
    case PropertyKind::Integer:
        return n.size() == 1 && std::abs(n[0]) < 2e9 ? std::optional<PropertyValue>(static_cast<int>(n[0]))
                                                     : std::nullopt;
    case PropertyKind::Number:
        return n.size() == 1 ? std::optional<PropertyValue>(n[0]) : std::nullopt;
    case PropertyKind::Vector2:
        return n.size() == 2 ? std::optional<PropertyValue>(glm::dvec2(n[0], n[1])) : std::nullopt;
    case PropertyKind::Vector3:
    case PropertyKind::Color:
        return n.size() == 3 ? std::optional<PropertyValue>(glm::dvec3(n[0], n[1], n[2])) : std::nullopt;
    case PropertyKind::Rotation:
        return n.size() == 4 ? std::optional<PropertyValue>(glm::dquat(n[3], n[0], n[1], n[2]))
                             : std::nullopt;
    default:
        return std::nullopt;
    }
}

Result<void> checkClipName(const Object& object, const std::string& name) {
    if (name.empty() || findClip(object, name))
        return {};
    std::string all;
    for (const ClipPtr& clip : object.clips)
        all += (all.empty() ? "" : ", ") + clip->name;
    return failure("\"" + object.name + "\" has no clip \"" + name + "\"" +
                   (all.empty() ? ", nor any other" : ", but: " + all));
}

template <class T>
std::optional<EntityRef> findNamed(const CowList<T>& list, EntityKind kind, std::string_view name) {
    for (const T& item : list)
        if (item.name == name)
            return EntityRef{kind, item.id};
    return std::nullopt;
}

/// The entity that "lights.key" or "camera" names.
std::optional<EntityRef> parseEntity(const Scene& scene, std::string_view path) {
    if (path == "camera")
        return EntityRef{EntityKind::Camera};
    if (path == "background")
        return EntityRef{EntityKind::Background};
    if (path == "timeline")
        return EntityRef{EntityKind::Timeline};
    if (path == "render")
        return EntityRef{EntityKind::Render};
    const auto dot = path.find('.');
    if (dot == std::string_view::npos)
        return std::nullopt;
    const auto list = path.substr(0, dot);
    const auto name = path.substr(dot + 1);
    if (list == "objects")
        return findNamed(scene.objects, EntityKind::Object, name);
    if (list == "lights")
        return findNamed(scene.lights, EntityKind::Light, name);
    if (list == "materials")
        return findNamed(scene.materials, EntityKind::Material, name);
    if (list == "groups")
        return findNamed(scene.groups, EntityKind::Group, name);
    return std::nullopt;
}

} // namespace

std::vector<PropertyInfo> properties(const Scene& scene, EntityRef entity) {
    std::vector<PropertyInfo> infos;
    visitEntity(scene, entity, [&]<class Owner>(const Owner& owner) {
        for (const Property<Owner>& p : propertiesOf<Owner>())
            infos.push_back({std::string(p.key), std::string(p.label), p.help, p.kind, p.unit, p.minimum,
                             p.maximum, p.step, p.choices, !p.applies || p.applies(owner), p.get(owner),
                             p.get(Owner{}), p.section});
        if constexpr (std::is_same_v<Owner, Object>)
            appendMorphs(owner, infos);
    });
    return infos;
}

Result<PropertyValue> getProperty(const Scene& scene, EntityRef entity, std::string_view key) {
    Result<PropertyValue> result = std::unexpected(noSuchEntity());
    visitEntity(scene, entity, [&]<class Owner>(const Owner& owner) {
        if constexpr (std::is_same_v<Owner, Object>)
            if (const auto target = morphTargetOf(owner, key)) {
                result = morphWeight(owner, *target);
                return;
            }
        if (const auto* property = findProperty<Owner>(key))
            result = property->get(owner);
        else
            result = failure("there is no property \"" + std::string(key) + "\"");
    });
    return result;
}

Result<void> setProperty(Scene& scene, EntityRef entity, std::string_view key, const PropertyValue& value) {
    Result<void> result = std::unexpected(noSuchEntity());
    visitEntity(scene, entity, [&]<class Owner>(const Owner& owner) {
        if constexpr (std::is_same_v<Owner, Object>)
            if (const auto target = morphTargetOf(owner, key)) {
                result = setMorphWeight(editable(scene, owner), *target, value);
                return;
            }
        const auto* property = findProperty<Owner>(key);
        if (!property) {
            result = failure("there is no property \"" + std::string(key) + "\"");
            return;
        }
        const auto checked = checkValue(*property, value);
        if (!checked) {
            result = std::unexpected(checked.error());
            return;
        }
        property->set(editable(scene, owner), *checked);
        result = {};
    });
    return result;
}

bool namesClip(std::string_view key) {
    return key == "clip" || key == "fadeFrom";
}

bool exists(const Scene& scene, EntityRef entity) {
    return visitEntity(scene, entity, [](const auto&) {});
}

std::string displayName(const Scene& scene, EntityRef entity) {
    std::string name;
    visitEntity(scene, entity, [&]<class Owner>(const Owner& owner) {
        if constexpr (requires { owner.name; })
            name = owner.name;
    });
    switch (entity.kind) {
    case EntityKind::Camera:
        return "Camera";
    case EntityKind::Background:
        return "Background";
    case EntityKind::Timeline:
        return "Timeline";
    case EntityKind::Render:
        return "Render settings";
    default:
        return name;
    }
}

Result<void> applyAssignment(Scene& scene, std::string_view assignment) {
    const auto whole = std::string(assignment);
    const auto equals = assignment.find('=');
    const auto left = assignment.substr(0, equals);
    const auto morph = left.rfind("." + std::string(morphPrefix));
    const auto dot = morph != std::string_view::npos ? morph : left.find_last_of('.');
    if (equals == std::string_view::npos || dot == std::string_view::npos)
        return failure("\"" + whole + "\" is not of the form lights.NAME.KEY=VALUE or camera.KEY=VALUE");
    const auto entity = parseEntity(scene, assignment.substr(0, dot));
    if (!entity)
        return failure("the scene has no \"" + std::string(assignment.substr(0, dot)) + "\"");
    const auto key = assignment.substr(dot + 1, equals - dot - 1);
    for (const PropertyInfo& info : properties(scene, *entity)) {
        if (info.key != key)
            continue;
        const auto value = parseValue(info.kind, assignment.substr(equals + 1));
        if (!value)
            return failure("\"" + std::string(assignment.substr(equals + 1)) + "\" is no value for \"" +
                           std::string(key) + "\"");
        if (entity->kind == EntityKind::Object && namesClip(key))
            if (auto ok = checkClipName(*scene.findObject(entity->id), std::get<std::string>(*value)); !ok)
                return ok;
        return setProperty(scene, *entity, key, *value);
    }
    return failure("there is no property \"" + std::string(key) + "\"");
}

} // namespace prizma
