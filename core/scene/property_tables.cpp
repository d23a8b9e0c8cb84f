#include "core/scene/property_tables.h"

#include <array>

namespace prizma {
namespace {

template <class T>
struct MemberTraits;
template <class Owner, class Value>
struct MemberTraits<Value Owner::*> {
    using OwnerType = Owner;
    using ValueType = Value;
};

constexpr double unlimited = 1e9;

/// Reads and writes `Owner::*member`; enumerations travel as their key.
template <auto member>
struct Access {
    using Owner = typename MemberTraits<decltype(member)>::OwnerType;
    using Value = typename MemberTraits<decltype(member)>::ValueType;

    static PropertyValue get(const Owner& owner) {
        if constexpr (std::is_enum_v<Value>)
            return std::string(choicesOf<Value>()[static_cast<std::size_t>(owner.*member)].key);
        else
            return owner.*member;
    }
    static void set(Owner& owner, const PropertyValue& value) {
        if constexpr (std::is_enum_v<Value>) {
            const auto& key = std::get<std::string>(value);
            const auto choices = choicesOf<Value>();
            for (std::size_t i = 0; i < choices.size(); ++i)
                if (choices[i].key == key)
                    owner.*member = static_cast<Value>(i);
        } else {
            owner.*member = std::get<Value>(value);
        }
    }
};

struct Texts {
    std::string_view key, label, help;
};

struct Range {
    std::string_view unit = {};
    double minimum = -unlimited;
    double maximum = unlimited;
    double step = 0.1;
};

template <class Owner>
using Applies = bool (*)(const Owner&);

/// A property stored in one member of its owner.
template <auto member, class Owner = typename MemberTraits<decltype(member)>::OwnerType>
Property<Owner> property(Texts texts, PropertyKind kind, Range range = {}, Applies<Owner> applies = nullptr) {
    using Value = typename MemberTraits<decltype(member)>::ValueType;
    std::span<const Choice> choices;
    if constexpr (std::is_enum_v<Value>)
        choices = choicesOf<Value>();
    return {texts.key,  texts.label,          texts.help,           kind,
            range.unit, range.minimum,        range.maximum,        range.step,
            choices,    &Access<member>::get, &Access<member>::set, applies};
}

/// A property stored in `part` of an object's `whole` (its transform, its playback).
template <auto whole, auto part>
Property<Object> partProperty(Texts texts, PropertyKind kind, Range range = {},
                              Applies<Object> applies = nullptr) {
    using Part = typename MemberTraits<decltype(part)>::OwnerType;
    Property<Part> inner = property<part, Part>(texts, kind, range);
    return {inner.key,
            inner.label,
            inner.help,
            kind,
            inner.unit,
            inner.minimum,
            inner.maximum,
            inner.step,
            inner.choices,
            [](const Object& object) { return Access<part>::get(object.*whole); },
            [](Object& object, const PropertyValue& value) { Access<part>::set(object.*whole, value); },
            applies};
}

template <auto part>
Property<Object> transformProperty(Texts texts, PropertyKind kind, Range range = {}) {
    return partProperty<&Object::transform, part>(texts, kind, range);
}

template <auto part>
Property<Object> playbackProperty(Texts texts, PropertyKind kind, Range range, Applies<Object> applies) {
    return partProperty<&Object::playback, part>(texts, kind, range, applies);
}

bool hasClips(const Object& object) {
    return !object.clips.empty();
}

bool fades(const Object& object) {
    return hasClips(object) && object.playback.fadeSeconds > 0.0;
}

template <LightType... types>
bool isType(const Light& light) {
    return ((light.type == types) || ...);
}

} // namespace

template <>
std::span<const Choice> choicesOf<LightType>() {
    static constexpr std::array<Choice, 5> choices{{{"point", "Point"},
                                                    {"spot", "Spot"},
                                                    {"directional", "Directional"},
                                                    {"rectangle", "Rectangle"},
                                                    {"sphere", "Sphere"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<ShaderType>() {
    static constexpr std::array<Choice, 5> choices{{{"whitted", "Whitted"},
                                                    {"normals", "Normals"},
                                                    {"texcoords", "Texture coordinates"},
                                                    {"depth", "Depth"},
                                                    {"cost", "Traversal cost"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<PrimitiveType>() {
    static constexpr std::array<Choice, 5> choices{{{"plane", "Plane"},
                                                    {"cube", "Cube"},
                                                    {"sphere", "Sphere"},
                                                    {"cylinder", "Cylinder"},
                                                    {"torus", "Torus"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<UpAxis>() {
    static constexpr std::array<Choice, 2> choices{{{"y", "Y up"}, {"z", "Z up"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<LoopMode>() {
    static constexpr std::array<Choice, 4> choices{
        {{"clip", "As the clip says"}, {"loop", "Loop"}, {"once", "Once"}, {"pingpong", "Back and forth"}}};
    return choices;
}

template <>
std::span<const Property<Object>> propertiesOf() {
    static const std::array properties{
        property<&Object::name>({"name", "Name", "What the object is called in the scene tree."},
                                PropertyKind::Text),
        property<&Object::visible>({"visible", "Visible", "A hidden object is neither drawn nor animated."},
                                   PropertyKind::Boolean),
        property<&Object::dynamic>(
            {"dynamic", "Dynamic",
             "Its vertices move: they are shaded and its tree is refitted when it changes."},
            PropertyKind::Boolean),
        transformProperty<&Transform::translation>(
            {"translation", "Position", "Where the object's origin is."}, PropertyKind::Vector3),
        transformProperty<&Transform::rotation>({"rotation", "Rotation", "Turns about X, then Y, then Z."},
                                                PropertyKind::Rotation, {"°", -360.0, 360.0, 5.0}),
        transformProperty<&Transform::scale>(
            {"scale", "Scale", "Size along each axis; 1 is the model's own."}, PropertyKind::Vector3),
        property<&Object::clip>({"clip", "Clip", "The animation that plays; empty for the bind pose."},
                                PropertyKind::Text, {}, hasClips),
        playbackProperty<&Playback::offset>(
            {"clipOffset", "Clip offset", "How far into the clip the timeline's beginning is."},
            PropertyKind::Number, {"s", -unlimited, unlimited, 0.1}, hasClips),
        playbackProperty<&Playback::speed>(
            {"clipSpeed", "Speed", "1 is the clip's own speed, 0 stands still, below 0 runs backwards."},
            PropertyKind::Number, {"", -1000.0, 1000.0, 0.1}, hasClips),
        playbackProperty<&Playback::loop>({"loop", "Loop", "What the clip does after its end."},
                                          PropertyKind::Choice, {}, hasClips),
        playbackProperty<&Playback::fps>(
            {"clipFps", "Clip's frame rate", "Frames of the clip a second; 0 is the clip's own rate."},
            PropertyKind::Number, {"1/s", 0.0, 1000.0, 1.0}, hasClips),
        playbackProperty<&Playback::fadeSeconds>(
            {"fadeSeconds", "Fade", "How long it takes to go over to the clip; 0 for no fade."},
            PropertyKind::Number, {"s", 0.0, unlimited, 0.1}, hasClips),
        playbackProperty<&Playback::fadeStart>(
            {"fadeStart", "Fade starts", "When on the timeline the fade begins."}, PropertyKind::Number,
            {"s", -unlimited, unlimited, 0.1}, fades),
        playbackProperty<&Playback::fadeFrom>(
            {"fadeFrom", "Fade from", "The clip that plays before; empty for the bind pose."},
            PropertyKind::Text, {}, fades),
    };
    return properties;
}

template <>
std::span<const Property<Light>> propertiesOf() {
    using enum LightType;
    static const std::array properties{
        property<&Light::name>({"name", "Name", "What the light is called in the scene tree."},
                               PropertyKind::Text),
        property<&Light::enabled>({"enabled", "On", "A light that is off costs nothing."},
                                  PropertyKind::Boolean),
        property<&Light::type>({"type", "Type", "What kind of light it is."}, PropertyKind::Choice),
        property<&Light::color>({"color", "Colour", "Multiplies the strength; linear RGB."},
                                PropertyKind::Color, {"", 0.0, unlimited}),
        property<&Light::intensity>({"intensity", "Intensity", "Power sent into a unit of solid angle."},
                                    PropertyKind::Number, {"W/sr", 0.0, unlimited, 5.0}, isType<Point, Spot>),
        property<&Light::irradiance>(
            {"irradiance", "Irradiance", "Power on a unit of area that faces the light."},
            PropertyKind::Number, {"W/m²", 0.0, unlimited, 0.1}, isType<Directional>),
        property<&Light::radiance>(
            {"radiance", "Radiance", "Power a unit of area sends into a unit of solid angle."},
            PropertyKind::Number, {"W/m²sr", 0.0, unlimited, 0.5}, isType<Rectangle, Sphere>),
        property<&Light::position>({"position", "Position", "Where the light is."}, PropertyKind::Vector3, {},
                                   isType<Point, Spot, Rectangle, Sphere>),
        property<&Light::direction>({"direction", "Direction", "Where the light travels."},
                                    PropertyKind::Vector3, {}, isType<Spot, Directional>),
        property<&Light::innerAngle>(
            {"innerAngle", "Inner angle", "Full intensity within this angle of the axis."},
            PropertyKind::Number, {"°", 0.0, 90.0, 1.0}, isType<Spot>),
        property<&Light::outerAngle>({"outerAngle", "Outer angle", "No light beyond this angle of the axis."},
                                     PropertyKind::Number, {"°", 0.0, 90.0, 1.0}, isType<Spot>),
        property<&Light::rotation>(
            {"rotation", "Rotation", "Turns about X, then Y, then Z; unturned it shines down."},
            PropertyKind::Rotation, {"°", -360.0, 360.0, 5.0}, isType<Rectangle>),
        property<&Light::size>({"size", "Size", "Width and depth."}, PropertyKind::Vector2,
                               {"", 0.0, unlimited}, isType<Rectangle>),
        property<&Light::radius>({"radius", "Radius", "Of the sphere."}, PropertyKind::Number,
                                 {"", 0.0, unlimited}, isType<Sphere>),
    };
    return properties;
}

template <>
std::span<const Property<Material>> propertiesOf() {
    constexpr Range fraction{"", 0.0, 1.0, 0.05};
    static const std::array properties{
        property<&Material::name>({"name", "Name", "What the material is called."}, PropertyKind::Text),
        property<&Material::baseColor>(
            {"baseColor", "Base colour", "Share of light that is reflected; linear RGB."},
            PropertyKind::Color, fraction),
        property<&Material::baseColorTexture>(
            {"baseColorTexture", "Base texture", "Multiplies the base colour."}, PropertyKind::Texture),
        property<&Material::alpha>({"alpha", "Alpha", "0 is a hole, 1 is solid."}, PropertyKind::Number,
                                   fraction),
        property<&Material::specular>({"specular", "Specular", "Strength of the reflection of a non-metal."},
                                      PropertyKind::Number, fraction),
        property<&Material::metallic>(
            {"metallic", "Metallic", "1 reflects in its base colour, as metals do."}, PropertyKind::Number,
            fraction),
        property<&Material::roughness>({"roughness", "Roughness", "0 is polished, 1 is matt."},
                                       PropertyKind::Number, fraction),
        property<&Material::transmission>(
            {"transmission", "Transmission", "1 lets light through, as glass does."}, PropertyKind::Number,
            fraction),
        property<&Material::ior>({"ior", "Refraction index", "1 air, 1.33 water, 1.5 glass, 2.42 diamond."},
                                 PropertyKind::Number, {"", 1.0, 4.0, 0.01}),
        property<&Material::emission>(
            {"emission", "Emission", "Light that the surface sends out; linear RGB."}, PropertyKind::Color,
            {"", 0.0, unlimited}),
        property<&Material::emissionStrength>(
            {"emissionStrength", "Emission strength", "Multiplies the emission."}, PropertyKind::Number,
            {"W/m²sr", 0.0, unlimited, 0.5}),
        property<&Material::normalTexture>({"normalTexture", "Normal map", "Bends the surface's normal."},
                                           PropertyKind::Texture),
    };
    return properties;
}

template <>
std::span<const Property<Camera>> propertiesOf() {
    static const std::array properties{
        property<&Camera::position>({"position", "Position", "Where the camera is."}, PropertyKind::Vector3),
        property<&Camera::target>({"target", "Target", "What it looks at and orbits."},
                                  PropertyKind::Vector3),
        property<&Camera::up>({"up", "Up", "The direction that is up in the picture."},
                              PropertyKind::Vector3),
        property<&Camera::fovY>({"fovY", "Field of view", "Vertical opening angle."}, PropertyKind::Number,
                                {"°", 1.0, 170.0, 1.0}),
    };
    return properties;
}

template <>
std::span<const Property<Background>> propertiesOf() {
    static const std::array properties{
        property<&Background::color>({"color", "Colour", "What rays that leave the scene see."},
                                     PropertyKind::Color, {"", 0.0, unlimited}),
        property<&Background::image>({"image", "Image", "An equirectangular picture around the scene."},
                                     PropertyKind::Texture),
        property<&Background::intensity>({"intensity", "Intensity", "Multiplies colour or image."},
                                         PropertyKind::Number, {"", 0.0, unlimited, 0.1}),
    };
    return properties;
}

template <>
std::span<const Property<Timeline>> propertiesOf() {
    static const std::array properties{
        property<&Timeline::fps>({"fps", "Frame rate", "Frames a second."}, PropertyKind::Number,
                                 {"1/s", 0.01, 1000.0, 1.0}),
        property<&Timeline::start>({"start", "Start", "The first frame."}, PropertyKind::Integer,
                                   {"", -Timeline::furthestFrame, Timeline::furthestFrame, 1.0}),
        property<&Timeline::end>({"end", "End", "The last frame."}, PropertyKind::Integer,
                                 {"", -Timeline::furthestFrame, Timeline::furthestFrame, 1.0}),
        property<&Timeline::frame>({"frame", "Frame", "The frame that is shown."}, PropertyKind::Number,
                                   {"", -Timeline::furthestFrame, Timeline::furthestFrame, 1.0}),
    };
    return properties;
}

template <>
std::span<const Property<RenderSettings>> propertiesOf() {
    static const std::array properties{
        property<&RenderSettings::shader>({"shader", "Shader", "What is drawn where a ray hits."},
                                          PropertyKind::Choice),
        property<&RenderSettings::maxDepth>(
            {"maxDepth", "Depth", "How often a ray may be reflected or refracted."}, PropertyKind::Integer,
            {"", 0.0, 6.0, 1.0}),
        property<&RenderSettings::samples>({"samples", "Samples", "A pixel is done after this many."},
                                           PropertyKind::Integer, {"", 1.0, 1e6, 16.0}),
        property<&RenderSettings::exposure>({"exposure", "Exposure", "Brightness of the display."},
                                            PropertyKind::Number, {"stops", -20.0, 20.0, 0.1}),
    };
    return properties;
}

} // namespace prizma
