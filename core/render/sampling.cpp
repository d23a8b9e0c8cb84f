#include "core/render/sampling.h"

namespace prizma {
namespace {

std::uint32_t reverseBits(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00FF00FFu) << 8) | ((bits & 0xFF00FF00u) >> 8);
    bits = ((bits & 0x0F0F0F0Fu) << 4) | ((bits & 0xF0F0F0F0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xCCCCCCCCu) >> 2);
    return ((bits & 0x55555555u) << 1) | ((bits & 0xAAAAAAAAu) >> 1);
}

/// The second dimension: direction numbers from the polynomial x + 1.
std::uint32_t sobolSecond(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1)
        if ((index & 1u) != 0)
            result ^= direction;
    return result;
}

/// To a float in [0, 1): the upper 24 bits, which a float holds exactly.
float toUnit(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

} // namespace

glm::vec2 sobolPoint(std::uint32_t index) {
    constexpr std::uint32_t middle = 1u << 31; // a digital shift keeps the sequence's evenness
    return {toUnit(reverseBits(index) ^ middle), toUnit(sobolSecond(index) ^ middle)};
}

} // namespace prizma
