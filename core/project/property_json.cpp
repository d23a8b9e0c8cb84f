#include "core/project/property_json.h"

#include "core/import/file_finder.h"

#include <cmath>
#include <filesystem>
#include <limits>

namespace prizma {
namespace {

/// Whole numbers without ".0", as people write them.
Json numberToJson(double value) {
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return static_cast<std::int64_t>(value);
    return value;
}

bool isNumbers(const Json& json, std::size_t count) {
    if (!json.is_array() || json.size() != count)
        return false;
    for (const Json& item : json)
        if (!item.is_number())
            return false;
    return true;
}

double numberAt(const Json& json, std::size_t index) {
    return json[index].get<double>();
}

Result<PropertyValue> scalarFromJson(const Json& json, PropertyKind kind) {
    if (kind == PropertyKind::Boolean) {
        if (json.is_boolean())
            return json.get<bool>();
        return failure("must be true or false");
    }
    if (kind == PropertyKind::Integer) {
        const double number = json.is_number() ? json.get<double>() : 0.5;
        if (number == std::floor(number) && std::abs(number) < std::numeric_limits<int>::max())
            return static_cast<int>(number);
        return failure("must be a whole number");
    }
    if (json.is_number())
        return json.get<double>();
    return failure("must be a number");
}

Result<PropertyValue> textFromJson(const Json& json, PropertyKind kind, const std::string& folder) {
    if (!json.is_string())
        return failure(kind == PropertyKind::Texture ? "must be the path of a picture, in quotes"
                                                     : "must be a text in quotes");
    const auto text = json.get<std::string>();
    if (kind != PropertyKind::Texture)
        return text;
    if (text.empty())
        return Texture{};
    return Texture{findFile(folder, text).value_or(expectedPath(folder, text)), nullptr};
}

Result<PropertyValue> vectorFromJson(const Json& json, PropertyKind kind) {
    if (kind == PropertyKind::Vector2) {
        if (isNumbers(json, 2))
            return glm::dvec2(numberAt(json, 0), numberAt(json, 1));
        return failure("must be a list of 2 numbers");
    }
    if (kind == PropertyKind::Rotation) {
        if (isNumbers(json, 4))
            return glm::dquat(numberAt(json, 3), numberAt(json, 0), numberAt(json, 1), numberAt(json, 2));
        return failure("must be a list of 4 numbers (a quaternion x, y, z, w)");
    }
    if (isNumbers(json, 3))
        return glm::dvec3(numberAt(json, 0), numberAt(json, 1), numberAt(json, 2));
    return failure("must be a list of 3 numbers");
}

} // namespace

Json toJson(const PropertyValue& value, const std::string& folder) {
    return std::visit(
        [&folder](const auto& v) -> Json {
            using V = std::decay_t<decltype(v)>;
            const auto list = [](std::initializer_list<double> numbers) {
                Json json = Json::array();
                for (const double number : numbers)
                    json.push_back(numberToJson(number));
                return json;
            };
            if constexpr (std::is_same_v<V, double>)
                return numberToJson(v);
            else if constexpr (std::is_same_v<V, glm::dvec2>)
                return list({v.x, v.y});
            else if constexpr (std::is_same_v<V, glm::dvec3>)
                return list({v.x, v.y, v.z});
            else if constexpr (std::is_same_v<V, glm::dquat>)
                return list({v.x, v.y, v.z, v.w});
            else if constexpr (std::is_same_v<V, Texture>)
                return relativePath(v.file, folder);
            else
                return v;
        },
        value);
}

Result<PropertyValue> fromJson(const Json& json, PropertyKind kind, const std::string& folder) {
    switch (kind) {
    case PropertyKind::Boolean:
    case PropertyKind::Integer:
    case PropertyKind::Number:
        return scalarFromJson(json, kind);
    case PropertyKind::Text:
    case PropertyKind::Choice:
    case PropertyKind::Texture:
        return textFromJson(json, kind, folder);
    default:
        return vectorFromJson(json, kind);
    }
}

std::string relativePath(const std::string& path, const std::string& folder) {
    if (path.empty())
        return path;
    const std::filesystem::path absolute(path);
    const auto relative = absolute.lexically_relative(folder);
    return (relative.empty() ? absolute : relative).generic_string();
}

} // namespace prizma
