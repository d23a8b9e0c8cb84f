#pragma once

#include "core/scene/camera.h"
#include "core/scene/cow_list.h"
#include "core/scene/group.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/object.h"
#include "core/scene/shader.h"

#include <optional>
#include <string>

namespace prizma {

struct Background {
    glm::dvec3 color{0.05, 0.06, 0.08}; ///< Radiance where there is no image.
    Texture image;                      ///< Equirectangular; its middle looks along -Z.
    double intensity = 1.0;             ///< Multiplies colour or image.
    double rotation = 0.0;              ///< Of the image about +Y, in degrees.

    friend bool operator==(const Background&, const Background&) = default;
};

/// Whole frames, `start` to `end` inclusive; `frame` may lie between two while playing.
struct Timeline {
    static constexpr double furthestFrame = 1e6; ///< From 0, either way.

    double fps = 30.0;
    int start = 0;
    int end = 120;
    double frame = 0.0;

    double seconds() const { return fps > 0.0 ? frame / fps : 0.0; }

    friend bool operator==(const Timeline&, const Timeline&) = default;
};

/// What a ray's first hit turns into.
enum class ShaderType { Whitted, Path, Normals, TexCoords, Depth, Material, Object, TraversalCost };

/// How linear radiance becomes what a screen shows.
enum class ViewTransform {
    Standard, ///< The sRGB curve; what is brighter than white is white.
    Filmic    ///< A film's soft shoulder: highlights fade to white.
};

/// A part of the picture, in fractions of its width and height from the upper left; left < right, top <
/// bottom.
struct Region {
    double left = 0.0, top = 0.0, right = 1.0, bottom = 1.0;

    friend bool operator==(const Region&, const Region&) = default;
};

struct RenderSettings {
    ShaderType shader = ShaderType::Whitted;
    Id customShader = noId;          ///< A shader of the project's own that takes the place of `shader`.
    ShaderValues shaderValues;       ///< Of the custom shader's parameters.
    int maxDepth = 6;                ///< Bounces; 0 is direct light only. Whitted follows 6 at most.
    bool transparentShadows = false; ///< Whitted: light goes straight through glass instead of being stopped.
    double fireflyClamp = 0.0; ///< Path: brightest radiance that one indirect sample may add; 0: no limit.
    int seed = 0;              ///< Another seed, other noise.
    int samples = 256;         ///< A pixel is done after this many,
    double maxError = 0.0;     ///< or as soon as its estimated relative error is below this; 0: never sooner.
    std::optional<Region> region;                          ///< Only these pixels are rendered.
    double exposure = 0.0;                                 ///< In stops; display only.
    ViewTransform viewTransform = ViewTransform::Standard; ///< Display only.
    bool denoise = false; ///< The preview only: the picture is smoothed along surfaces, and marked so.

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// A view to come back to.
struct CameraBookmark {
    Id id = noId;
    std::string name;
    Camera camera;

    friend bool operator==(const CameraBookmark&, const CameraBookmark&) = default;
};

/// Everything a picture depends on. A value: copying costs a few pointers (snapshots), `==` says whether two
/// scenes look the same. Heavy parts (meshes, images, clips) are shared and never change.
struct Scene {
    CowList<Object> objects;
    CowList<Light> lights;
    CowList<Material> materials;
    CowList<Group> groups;
    CowList<CameraBookmark> bookmarks;
    CowList<Shader> shaders;
    Camera camera;
    Background background;
    Timeline timeline;
    RenderSettings render;
    Id lastId = noId;

    /// A new id, never given out before by this scene.
    Id newId() { return ++lastId; }

    const Object* findObject(Id id) const;
    const Light* findLight(Id id) const;
    const Material* findMaterial(Id id) const;
    const Material* findMaterial(const std::string& name) const;
    const Shader* findShader(Id id) const;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Appends a copy of `item` with a new id and, if its name is taken in that list, a new name ("bunny 2").
Id addObject(Scene& scene, Object item);
Id addLight(Scene& scene, Light item);
Id addMaterial(Scene& scene, Material item);
Id addShader(Scene& scene, Shader item);

/// `wanted`, or "wanted 2", "wanted 3", ... whichever no item of `list` has.
template <class T>
std::string uniqueName(const CowList<T>& list, const std::string& wanted);

/// `camera` moved along its own view direction so that `bounds` fills the picture (`aspect` is width /
/// height) with a small margin; unchanged for empty bounds.
Camera frameBounds(Camera camera, const DBounds& bounds, double aspect);

} // namespace prizma
