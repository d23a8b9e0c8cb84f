#pragma once

#include "core/diagnostic.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace prizma::bench {

struct RuinBenchOptions {
    std::string deviceId;  ///< Empty: the default device.
    int parts = 200;       ///< Of each object.
    double distance = 2.0; ///< How far they fly, in sizes of their object.
    int repeats = 5;       ///< Rates are medians of this many; both trees take turns.
};

/// Millions of rays a second.
struct RuinRates {
    double camera = 0.0, diffuse = 0.0;
};

/// One moment of the flight.
struct RuinStep {
    double flown = 0.0; ///< Share of the distance.
    double wear = 1.0;  ///< RenderStatistics::treeWear of the refitted tree.
    RuinRates refitted; ///< Through the tree that was built before the flight.
    RuinRates rebuilt;  ///< Through a tree built for this moment.
};

/// What it costs the render thread to have a worn tree replaced, in milliseconds. All are times to bring the
/// device up to a frame of the animation, all stages before the first ray.
struct RenewalTimes {
    double frame = 0.0;  ///< A usual one: pose, refit, top level (median).
    double start = 0.0;  ///< The one that finds the tree worn: reads the vertices back and starts the build.
    double during = 0.0; ///< The slowest one while the build goes on, which shares the cores.
    double swap = 0.0;   ///< The one that puts the new tree into use.
    double build = 0.0;  ///< From the start of the build to the swap.
};

struct RuinReport {
    std::string device;
    std::size_t triangles = 0;
    std::vector<RuinStep> steps;
    RenewalTimes renewal;
};

/// Measures what refitting does to trees whose parts fly apart (makeFlyingApart): where a new tree pays.
/// Errors: no mesh, no device, no memory.
Result<RuinReport> benchRuin(const Scene& scene, const RuinBenchOptions& options);

} // namespace prizma::bench
