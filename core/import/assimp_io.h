#pragma once

#include "core/progress.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/ProgressHandler.hpp>

#include <string>
#include <vector>

namespace prizma {

/// How assimp reads files: from memory, text brought to UTF-8, names looked up as people write them
/// (backslashes, quotes, wrong case). Remembers what was asked for in vain.
class AssimpFiles : public Assimp::IOSystem {
  public:
    /// `model` is the file that is imported; names in it are relative to its folder.
    explicit AssimpFiles(const std::string& model);

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// Files beside the model that were wanted but are not there, each once.
    const std::vector<std::string>& missing() const { return missing_; }

    /// Files beside the model that were read, each once.
    const std::vector<std::string>& companions() const { return companions_; }

    /// Folders of the files that were read, the model's own first: where its textures may be.
    const std::vector<std::string>& folders() const { return folders_; }

  private:
    std::vector<std::string> folders_;
    std::string model_;
    std::vector<std::string> missing_;
    std::vector<std::string> companions_;
};

/// Passes assimp's progress on as the part of it up to `share`, and breaks the import off by an exception,
/// which assimp turns into an error, once it was cancelled.
class AssimpProgress : public Assimp::ProgressHandler {
  public:
    AssimpProgress(Progress& progress, double share) : progress_(progress), share_(share) {}

    bool Update(float fraction) override;

  private:
    Progress& progress_;
    double share_;
};

} // namespace prizma
