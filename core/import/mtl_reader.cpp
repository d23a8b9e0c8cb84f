#include "core/import/mtl_reader.h"

#include "core/import/text_fields.h"

#include <algorithm>
#include <array>

namespace prizma {
namespace {

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

/// "r g b", or one value for all three. Spectral curves and XYZ are not read.
std::optional<glm::dvec3> readColor(Fields fields) {
    const auto red = fields.number();
    if (!red)
        return std::nullopt;
    const auto green = fields.number();
    const auto blue = fields.number();
    return green && blue ? glm::dvec3(*red, *green, *blue) : glm::dvec3(*red);
}

std::optional<double> readNumber(Fields fields) {
    if (Fields next = fields; next.word() == "-halo")
        fields = next;
    return fields.number();
}

/// How many values an option of a map has at most; nothing for what is no option.
std::optional<int> valuesOf(std::string_view option) {
    constexpr std::array<std::pair<std::string_view, int>, 14> options{{{"-o", 3},
                                                                        {"-s", 3},
                                                                        {"-t", 3},
                                                                        {"-mm", 2},
                                                                        {"-bm", 1},
                                                                        {"-blendu", 1},
                                                                        {"-blendv", 1},
                                                                        {"-boost", 1},
                                                                        {"-cc", 1},
                                                                        {"-clamp", 1},
                                                                        {"-colorspace", 1},
                                                                        {"-imfchan", 1},
                                                                        {"-texres", 1},
                                                                        {"-type", 1}}};
    const auto found = std::ranges::find(options, option, [](const auto& entry) { return entry.first; });
    return found == options.end() ? std::nullopt : std::optional(found->second);
}

/// -o, -s and -t may have fewer values than three.
bool isPlacing(std::string_view option) {
    return option == "-o" || option == "-s" || option == "-t";
}

/// Passes over the values of an option that puts the map elsewhere; true if they do.
bool readPlacing(std::string_view option, Fields& fields) {
    const double neutral = option == "-s" ? 1.0 : 0.0;
    bool moves = false;
    for (int i = 0; i < 3; ++i) {
        Fields next = fields;
        const auto value = next.number();
        if (!value)
            break;
        fields = next;
        moves = moves || (*value != neutral && i < 2);
    }
    return moves;
}

/// The options, then the file's name, which may hold spaces.
MtlMap readMap(Fields fields) {
    MtlMap map;
    while (true) {
        Fields next = fields;
        const std::string option = lowerCase(next.word().value_or(""));
        const auto values = valuesOf(option);
        if (!values)
            break;
        fields = next;
        if (isPlacing(option)) {
            map.isPlaced = readPlacing(option, fields) || map.isPlaced;
        } else if (option == "-bm") {
            map.bumpScale = fields.number().value_or(1.0);
        } else {
            for (int i = 0; i < *values; ++i)
                fields.word();
        }
    }
    map.file = std::string(fields.rest());
    return map;
}

template <class T, class Read>
bool readInto(std::optional<T>& target, const Fields& fields, const Read& read) {
    if (const auto value = read(fields))
        target = *value;
    return true;
}

bool readColors(const std::string& key, const Fields& fields, MtlMaterial& m) {
    std::optional<glm::dvec3>* target = key == "kd"   ? &m.diffuse
                                        : key == "ks" ? &m.specular
                                        : key == "ke" ? &m.emission
                                        : key == "tf" ? &m.filter
                                                      : nullptr;
    return target && readInto(*target, fields, readColor);
}

bool readNumbers(const std::string& key, const Fields& fields, MtlMaterial& m) {
    std::optional<double>* target = key == "ns"   ? &m.shininess
                                    : key == "ni" ? &m.ior
                                    : key == "d"  ? &m.dissolve
                                    : key == "tr" ? &m.transparency
                                    : key == "pr" ? &m.roughness
                                    : key == "pm" ? &m.metallic
                                                  : nullptr;
    return target && readInto(*target, fields, readNumber);
}

void readMaps(const std::string& key, const Fields& fields, MtlMaterial& m) {
    MtlMap* target = key == "map_kd"                                         ? &m.diffuseMap
                     : key == "map_ks"                                       ? &m.specularMap
                     : key == "map_ns"                                       ? &m.shininessMap
                     : key == "map_ke" || key == "map_emissive"              ? &m.emissionMap
                     : key == "map_d" || key == "map_opacity"                ? &m.dissolveMap
                     : key == "map_pr"                                       ? &m.roughnessMap
                     : key == "map_pm"                                       ? &m.metallicMap
                     : key == "bump" || key == "map_bump"                    ? &m.bumpMap
                     : key == "norm" || key == "map_kn" || key == "map_norm" ? &m.normalMap
                                                                             : nullptr;
    if (target)
        *target = readMap(fields);
}

} // namespace

std::map<std::string, MtlMaterial> readMtl(std::string_view text) {
    std::map<std::string, MtlMaterial> materials;
    MtlMaterial* current = nullptr;
    LineReader lines(text);
    while (lines.next()) {
        Fields fields(lines.line());
        const auto word = fields.word();
        if (!word)
            continue;
        const std::string key = lowerCase(*word);
        if (key == "newmtl")
            current = &materials[std::string(fields.rest())];
        else if (!current)
            continue;
        else if (key == "illum")
            readInto(current->illumination, fields, [](Fields f) { return f.integer(); });
        else if (!readColors(key, fields, *current) && !readNumbers(key, fields, *current))
            readMaps(key, fields, *current);
    }
    return materials;
}

} // namespace prizma
