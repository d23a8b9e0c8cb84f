#pragma once

#include "core/diagnostic.h"
#include "core/scene/material.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prizma {

/// Reads the pictures of one model file, each once, and keeps those that are made of them.
class PictureReader {
  public:
    /// `model` is the model's absolute path; pictures are looked for in `folders`, its own first, and what is
    /// amiss with one is added to `warnings`.
    PictureReader(std::string model, std::vector<std::string> folders, Diagnostics& warnings)
        : model_(std::move(model)), folders_(std::move(folders)), warnings_(warnings) {}

    /// The picture that the model file calls `name`; without image if it is missing or broken, and not set
    /// for an empty name.
    Texture read(const std::string& name);

    /// A picture from inside the model file, by `name`; `load` makes it the first time.
    Texture embedded(const std::string& name, const std::function<Result<ImagePtr>()>& load);

    /// A picture made of others: `recipe` says how, in words and with their names, and with it the project
    /// file refers to it. `make` is called once for each recipe.
    Texture made(const std::string& recipe, const std::function<ImagePtr()>& make);

    void warn(std::string message, const std::string& file);

  private:
    Texture load(const std::string& name);

    std::string model_;
    std::vector<std::string> folders_;
    Diagnostics& warnings_;
    std::map<std::string, Texture> textures_;
};

} // namespace prizma
