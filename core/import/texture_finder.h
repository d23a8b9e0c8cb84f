#pragma once

#include "core/diagnostic.h"
#include "core/scene/material.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prizma {

/// Finds and reads the pictures that SMD materials are named after: in the model's folder and those its QC
/// names, regardless of case, and with another extension, or one where the name has none.
class TextureFinder {
  public:
    /// `folders` are absolute, the model's own first.
    explicit TextureFinder(std::vector<std::string> folders) : folders_(std::move(folders)) {}

    std::optional<std::string> find(const std::string& materialName);

    /// The material's picture, read once. A name with a picture's extension for which there is none gives a
    /// texture without image and a warning, a name without one no texture.
    Texture read(const std::string& materialName, Diagnostics& warnings);

  private:
    using Listing = std::map<std::string, std::string>; ///< File names by themselves in lower case.
    const Listing& listingOf(const std::string& folder);

    std::vector<std::string> folders_;
    std::map<std::string, Listing> listings_;
    std::map<std::string, Texture> textures_; ///< By file.
};

} // namespace prizma
