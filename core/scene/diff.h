#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace prizma {

/// What differs between two scenes. Computed by comparing values and pointers; nothing is flagged by hand.
struct SceneDiff {
    std::vector<Id> objectsAdded;
    std::vector<Id> objectsRemoved;
    std::vector<Id> objectsMoved;      ///< In the world: themselves, or a group above them.
    std::vector<Id> objectsShown;      ///< Shown or hidden, themselves or by a group.
    std::vector<Id> meshesChanged;     ///< Another mesh, or Static/Dynamic changed.
    std::vector<Id> materialsAssigned; ///< The object's list of materials changed.
    std::vector<Id> clipsChanged;      ///< Another clip, played otherwise, or morph weights.
    bool lights = false;
    bool materials = false; ///< A value in some material.
    bool textures = false;  ///< Some material's or the background's picture.
    bool camera = false;
    bool background = false;
    bool time = false;     ///< The seconds at which clips are evaluated.
    bool settings = false; ///< Shader or depth: what a sample is.
    bool samples = false;  ///< The limit only.
    bool exposure = false; ///< Or anything else that only the display depends on.

    bool isEmpty() const;
    bool isTimeOnly() const; ///< The time changed and nothing else, as while playing.

    friend bool operator==(const SceneDiff&, const SceneDiff&) = default;
};

/// What has to change to get from `before` to `after`. Names do not count: they are not in the picture.
SceneDiff diff(const Scene& before, const Scene& after);

} // namespace prizma
