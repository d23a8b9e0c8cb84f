#pragma once

#include "core/bench/procedural_scene.h"

#include <CLI/CLI.hpp>

#include <string>

namespace prizma {

/// What most measurements have in common on the command line.
struct BenchArguments {
    std::string file;
    bool json = false;
    bool instanced = false;
    std::size_t triangles = bench::proceduralTriangles;
    int repeats = 5;
};

void addCommonOptions(CLI::App& command, BenchArguments& arguments);

/// The scene that is measured. Ends the program where its file cannot be read.
Scene sceneOf(const BenchArguments& arguments);

} // namespace prizma
