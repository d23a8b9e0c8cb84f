#pragma once

#include "core/diagnostic.h"
#include "core/scene/clip.h"

#include <string>
#include <string_view>
#include <vector>

namespace prizma {

/// Which bone of a model each bone of an animation file is: they pair by name, and of several bones of one
/// name the first does.
class BonePairing {
  public:
    BonePairing(const Skeleton& animation, const Skeleton& model);

    bool isEmpty() const { return pairs_ == 0; }

    /// `clip`, which is for the animation file's skeleton, for the model's. Bones that it lacks keep the
    /// bind pose, bones in excess are left out.
    Clip apply(Clip clip) const;

    /// One warning each for bones that the animation lacks, that it has in excess, and that hang on another
    /// bone in it.
    Diagnostics warnings(const std::string& file) const;

  private:
    std::vector<int> modelBones_; ///< Of each animation bone; -1 for none.
    std::size_t pairs_ = 0;
    std::vector<std::string> lacking_, excess_, elsewhere_;
};

/// `wanted`, or with a number behind it if a clip has that name.
std::string freeClipName(const std::vector<ClipPtr>& clips, const std::string& wanted);

} // namespace prizma
