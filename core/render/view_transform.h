#pragma once

#include "core/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace prizma {

/// What a screen shows of linear radiance with sRGB primaries: linear light, each channel 0 to 1. Standard
/// clips. Filmic is AgX (Sobotka 2022): an inset makes all colours less pure, a sigmoid over the logarithm of
/// each channel (from 10 stops under middle grey to 6.5 over it) rolls off, the inset is taken back, so that
/// highlights fade to white rather than to a primary. Inset for sRGB primaries as published by Wrensch
/// (2023); sigmoid as in Blender 4 (Chow 2023), which leaves middle grey, 0.18, where it is. Black stays
/// black; what is no number becomes black. Kernels work from `filmicTable`; this is its exact form.
glm::dvec3 displayColor(const glm::dvec3& radiance, ViewTransform transform);

/// How kernels/display.cl makes linear values into sRGB bytes: the linear value from which on each byte is
/// used, as float bits, then for every bin of floats (their upper 16 bits) from PRIZMA_SRGB_SMALLEST to 1 the
/// byte at the bin's start.
std::vector<std::uint32_t> srgbEncoding();

/// What kernels/display.cl needs for Filmic: the inset and its inverse, row by row, then the sigmoid, as
/// linear light, at the start of every bin of floats (their upper 16 bits) from PRIZMA_FILMIC_SMALLEST to
/// PRIZMA_FILMIC_LARGEST.
std::vector<float> filmicTable();

} // namespace prizma
