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
            choices,    &Access<member>::get, &Access<member>::set, applies,
            {}};
}

/// A property stored in `part` of its owner's `whole` (its transform, its playback).
template <auto whole, auto part, class Owner = typename MemberTraits<decltype(whole)>::OwnerType>
Property<Owner> partProperty(Texts texts, PropertyKind kind, Range range = {},
                             Applies<Owner> applies = nullptr) {
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
            [](const Owner& owner) { return Access<part>::get(owner.*whole); },
            [](Owner& owner, const PropertyValue& value) { Access<part>::set(owner.*whole, value); },
            applies,
            {}};
}

template <auto part>
Property<Object> playbackProperty(Texts texts, PropertyKind kind, Range range, Applies<Object> applies) {
    return partProperty<&Object::playback, part>(texts, kind, range, applies);
}

/// From the property `key` on, panels put a heading.
struct SectionStart {
    std::string_view key, section;
};

template <class Owner, std::size_t count>
std::array<Property<Owner>, count> sectioned(std::array<Property<Owner>, count> properties,
                                             std::initializer_list<SectionStart> starts) {
    std::string_view section;
    for (Property<Owner>& property : properties) {
        for (const SectionStart& start : starts)
            if (start.key == property.key)
                section = start.section;
        property.section = section;
    }
    return properties;
}

bool isMasked(const Material& material) {
    return material.alphaMode == AlphaMode::Mask;
}

bool transmits(const Material& material) {
    return material.transmission > 0.0;
}

bool hasNormalMap(const Material& material) {
    return material.normalTexture.isSet();
}

bool hasLens(const Camera& camera) {
    return camera.lensRadius > 0.0;
}

bool hasImage(const Background& background) {
    return background.image.isSet();
}

template <ShaderType shader>
bool isShader(const RenderSettings& settings) {
    return settings.shader == shader;
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
    static constexpr std::array<Choice, 8> choices{{{"whitted", "Whitted"},
                                                    {"path", "Path"},
                                                    {"normals", "Normals"},
                                                    {"texcoords", "Texture coordinates"},
                                                    {"depth", "Depth"},
                                                    {"material", "Materials"},
                                                    {"object", "Objects"},
                                                    {"cost", "Traversal cost"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<ViewTransform>() {
    static constexpr std::array<Choice, 2> choices{{{"standard", "Standard (sRGB)"}, {"filmic", "Filmic"}}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<AlphaMode>() {
    static constexpr std::array<Choice, 3> choices{
        {{"blend", "Blend"}, {"mask", "Mask"}, {"opaque", "Opaque"}}};
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
        partProperty<&Object::transform, &Transform::translation>(
            {"translation", "Position", "Where the object's origin is, in its group's space."},
            PropertyKind::Vector3),
        partProperty<&Object::transform, &Transform::rotation>(
            {"rotation", "Rotation", "Turns about X, then Y, then Z."}, PropertyKind::Rotation,
            {"°", -360.0, 360.0, 5.0}),
        partProperty<&Object::transform, &Transform::scale>(
            {"scale", "Scale", "Size along each axis; 1 is the model's own."}, PropertyKind::Vector3),
        property<&Object::seenByCamera>(
            {"seenByCamera", "Seen by camera", "Otherwise one sees it only in mirrors and by its shadow."},
            PropertyKind::Boolean),
        property<&Object::seenInReflections>(
            {"seenInReflections", "Seen in reflections",
             "Light that was reflected or refracted meets it; otherwise mirrors do not show it."},
            PropertyKind::Boolean),
        property<&Object::castsShadows>({"castsShadows", "Casts shadows", "It stops the light of lights."},
                                        PropertyKind::Boolean),
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
    static const auto inSections = sectioned(
        properties, {{"translation", "Placement"}, {"seenByCamera", "Rays"}, {"clip", "Animation"}});
    return inSections;
}

template <>
std::span<const Property<Light>> propertiesOf() {
    using enum LightType;
    static const std::array properties{
        property<&Light::name>({"name", "Name", "What the light is called in the scene tree."},
                               PropertyKind::Text),
        property<&Light::enabled>({"enabled", "On", "A light that is off costs nothing."},
                                  PropertyKind::Boolean),
        property<&Light::solo>({"solo", "Solo", "While any light is solo, only those that are shine."},
                               PropertyKind::Boolean),
        property<&Light::visible>(
            {"visible", "Visible", "The camera sees the light itself, not only what it lights."},
            PropertyKind::Boolean, {}, isType<Rectangle, Sphere>),
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
    static const auto inSections = sectioned(properties, {{"color", "Light"}, {"position", "Placement"}});
    return inSections;
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
        property<&Material::alphaMode>(
            {"alphaMode", "Alpha mode", "Blend mixes, Mask cuts holes, Opaque takes no notice of alpha."},
            PropertyKind::Choice),
        property<&Material::alphaCutoff>({"alphaCutoff", "Alpha cut-off", "Below it there is a hole."},
                                         PropertyKind::Number, fraction, isMasked),
        property<&Material::doubleSided>(
            {"doubleSided", "Double-sided", "Otherwise the surface is not there when seen from behind."},
            PropertyKind::Boolean),
        property<&Material::specular>({"specular", "Specular", "Strength of the reflection of a non-metal."},
                                      PropertyKind::Number, fraction),
        property<&Material::specularColor>(
            {"specularColor", "Specular colour", "Tints the reflection of a non-metal; linear RGB."},
            PropertyKind::Color, fraction),
        property<&Material::specularTexture>(
            {"specularTexture", "Specular texture", "Its alpha multiplies the specular strength."},
            PropertyKind::Texture),
        property<&Material::metallic>(
            {"metallic", "Metallic", "1 reflects in its base colour, as metals do."}, PropertyKind::Number,
            fraction),
        property<&Material::roughness>({"roughness", "Roughness", "0 is polished, 1 is matt."},
                                       PropertyKind::Number, fraction),
        property<&Material::metallicRoughnessTexture>({"metallicRoughnessTexture",
                                                       "Metallic and roughness texture",
                                                       "Its blue multiplies metallic, its green roughness."},
                                                      PropertyKind::Texture),
        property<&Material::transmission>(
            {"transmission", "Transmission", "1 lets light through, as glass does."}, PropertyKind::Number,
            fraction),
        property<&Material::transmissionTexture>(
            {"transmissionTexture", "Transmission texture", "Its red multiplies the transmission."},
            PropertyKind::Texture),
        property<&Material::ior>({"ior", "Refraction index", "1 air, 1.33 water, 1.5 glass, 2.42 diamond."},
                                 PropertyKind::Number, {"", 1.0, 4.0, 0.01}),
        property<&Material::attenuationColor>(
            {"attenuationColor", "Absorption colour",
             "What is left of white light after the absorption distance inside."},
            PropertyKind::Color, fraction, transmits),
        property<&Material::attenuationDistance>(
            {"attenuationDistance", "Absorption distance",
             "How far light goes inside until it has the absorption colour; 0: nothing is absorbed."},
            PropertyKind::Number, {"", 0.0, unlimited, 0.1}, transmits),
        property<&Material::emission>(
            {"emission", "Emission", "Light that the surface sends out; linear RGB."}, PropertyKind::Color,
            {"", 0.0, unlimited}),
        property<&Material::emissionStrength>(
            {"emissionStrength", "Emission strength", "Multiplies the emission."}, PropertyKind::Number,
            {"W/m²sr", 0.0, unlimited, 0.5}),
        property<&Material::emissionTexture>(
            {"emissionTexture", "Emission texture", "Multiplies the emission."}, PropertyKind::Texture),
        property<&Material::normalTexture>({"normalTexture", "Normal map", "Bends the surface's normal."},
                                           PropertyKind::Texture),
        property<&Material::normalScale>(
            {"normalScale", "Normal strength", "How far the normal map bends the normal; 1 is as painted."},
            PropertyKind::Number, {"", -10.0, 10.0, 0.1}, hasNormalMap),
    };
    static const auto inSections = sectioned(properties, {{"baseColor", "Colour"},
                                                          {"alpha", "Holes"},
                                                          {"specular", "Reflection"},
                                                          {"transmission", "Glass"},
                                                          {"emission", "Light"},
                                                          {"normalTexture", "Relief"}});
    return inSections;
}

template <>
std::span<const Property<Group>> propertiesOf() {
    static const std::array properties{
        property<&Group::name>({"name", "Name", "What the group is called in the scene tree."},
                               PropertyKind::Text),
        property<&Group::visible>({"visible", "Visible", "A hidden group hides all that is in it."},
                                  PropertyKind::Boolean),
        partProperty<&Group::transform, &Transform::translation>(
            {"translation", "Position", "Where the group's origin is; its members move with it."},
            PropertyKind::Vector3),
        partProperty<&Group::transform, &Transform::rotation>(
            {"rotation", "Rotation", "Turns about X, then Y, then Z."}, PropertyKind::Rotation,
            {"°", -360.0, 360.0, 5.0}),
        partProperty<&Group::transform, &Transform::scale>(
            {"scale", "Scale", "Size along each axis; its members grow with it."}, PropertyKind::Vector3),
    };
    static const auto inSections = sectioned(properties, {{"translation", "Placement"}});
    return inSections;
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
        property<&Camera::lensRadius>(
            {"lensRadius", "Lens radius", "Blurs what is out of focus (shader Path); 0 is a pinhole."},
            PropertyKind::Number, {"", 0.0, unlimited, 0.01}),
        property<&Camera::focusDistance>(
            {"focusDistance", "Focus distance", "How far away things are sharp; 0: at the target."},
            PropertyKind::Number, {"", 0.0, unlimited, 0.1}, hasLens),
    };
    static const auto inSections = sectioned(properties, {{"fovY", "Lens"}});
    return inSections;
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
        property<&Background::rotation>({"rotation", "Rotation", "Turns the image about the vertical axis."},
                                        PropertyKind::Number, {"°", -360.0, 360.0, 5.0}, hasImage),
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
            {"maxDepth", "Depth", "How often light may bounce; Whitted follows 6 bounces at most."},
            PropertyKind::Integer, {"", 0.0, 64.0, 1.0}),
        property<&RenderSettings::transparentShadows>(
            {"transparentShadows", "Transparent shadows", "Glass lets light straight through in its shadow."},
            PropertyKind::Boolean, {}, isShader<ShaderType::Whitted>),
        property<&RenderSettings::fireflyClamp>(
            {"fireflyClamp", "Firefly limit",
             "Brightest radiance that one indirect sample may add; 0: no limit. Darkens the picture."},
            PropertyKind::Number, {"W/m²sr", 0.0, unlimited, 1.0}, isShader<ShaderType::Path>),
        property<&RenderSettings::seed>({"seed", "Seed", "Another number, other noise."},
                                        PropertyKind::Integer, {"", 0.0, 1e6, 1.0},
                                        isShader<ShaderType::Path>),
        property<&RenderSettings::samples>({"samples", "Samples", "A pixel is done after this many."},
                                           PropertyKind::Integer, {"", 1.0, 1e6, 16.0}),
        property<&RenderSettings::exposure>({"exposure", "Exposure", "Brightness of the display."},
                                            PropertyKind::Number, {"stops", -20.0, 20.0, 0.1}),
        property<&RenderSettings::viewTransform>(
            {"viewTransform", "View", "How radiance becomes colours of the screen; EXR files stay linear."},
            PropertyKind::Choice),
        property<&RenderSettings::denoise>(
            {"denoise", "Denoise preview",
             "Smooths the picture on the screen along surfaces; files stay as they are."},
            PropertyKind::Boolean),
    };
    static const auto inSections =
        sectioned(properties, {{"fireflyClamp", "Samples"}, {"exposure", "Display"}});
    return inSections;
}

} // namespace prizma
