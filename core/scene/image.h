#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace prizma {

/// A picture in memory, rows from top to bottom. Exactly one of the two pixel arrays is filled.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes; ///< RGBA, 8 bits a channel, colour in sRGB, alpha straight.
    std::vector<float> floats;       ///< RGBA, linear, from HDR and EXR files.
    bool opaque = true;              ///< No pixel's alpha is below full.
};

using ImagePtr = std::shared_ptr<const Image>;

/// A material's or background's reference to a picture. A file that could not be read leaves `image` null
/// while `file` is set: it is drawn as a magenta checkerboard, so that the lack is seen.
struct Texture {
    std::string file; ///< Absolute path, or empty for no texture.
    ImagePtr image;

    bool isSet() const { return !file.empty() || image; }

    friend bool operator==(const Texture&, const Texture&) = default;
};

} // namespace prizma
