#pragma once

#include "core/scene/properties.h"

namespace prizma {

template <>
std::span<const Property<Object>> propertiesOf();
template <>
std::span<const Property<Light>> propertiesOf();
template <>
std::span<const Property<Material>> propertiesOf();
template <>
std::span<const Property<Group>> propertiesOf();
template <>
std::span<const Property<Camera>> propertiesOf();
template <>
std::span<const Property<Background>> propertiesOf();
template <>
std::span<const Property<Timeline>> propertiesOf();
template <>
std::span<const Property<RenderSettings>> propertiesOf();

/// The keys an enumeration has in files and scripts, in the order of its values.
template <class Enum>
std::span<const Choice> choicesOf();
template <>
std::span<const Choice> choicesOf<LightType>();
template <>
std::span<const Choice> choicesOf<ShaderType>();
template <>
std::span<const Choice> choicesOf<ViewTransform>();
template <>
std::span<const Choice> choicesOf<AlphaMode>();
template <>
std::span<const Choice> choicesOf<PrimitiveType>();
template <>
std::span<const Choice> choicesOf<UpAxis>();
template <>
std::span<const Choice> choicesOf<LoopMode>();

} // namespace prizma
