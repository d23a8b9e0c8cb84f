#include "core/render/mip_levels.h"

#include "core/scene/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace prizma {
namespace {

/// The linear values of the 8-bit codes, and the way back to the code whose value is nearest: that keeps
/// means of many rounded texels right.
class SrgbCodes {
  public:
    SrgbCodes() {
        for (std::size_t code = 0; code < 256; ++code)
            values_[code] = static_cast<float>(decodeSrgb(static_cast<double>(code) / 255.0));
        std::size_t code = 0;
        for (std::size_t i = 0; i < firsts_.size(); ++i) {
            while (code < 255 && limit(code) <= static_cast<float>(i) / steps)
                ++code;
            firsts_[i] = static_cast<std::uint8_t>(code);
        }
    }

    float value(std::uint8_t code) const { return values_[code]; }

    std::uint8_t nearest(float value) const {
        value = std::clamp(value, 0.0F, 1.0F);
        std::size_t code = firsts_[static_cast<std::size_t>(value * steps)];
        while (code < 255 && limit(code) <= value)
            ++code;
        return static_cast<std::uint8_t>(code);
    }

  private:
    static constexpr float steps = 4096.0F;

    /// From here on the next code is nearer.
    float limit(std::size_t code) const { return 0.5F * (values_[code] + values_[code + 1]); }

    std::array<float, 256> values_{};
    std::array<std::uint8_t, 4097> firsts_{}; ///< The lowest code that values from i / steps on can have.
};

const SrgbCodes& srgbCodes() {
    static const SrgbCodes codes;
    return codes;
}

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

bool isColor(TexelUse use) {
    return use == TexelUse::Color || use == TexelUse::OpaqueColor;
}

std::size_t texelCount(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

/// Linear RGBA of the picture itself.
class PictureTexels {
  public:
    PictureTexels(const Image& image, TexelUse use) : image_(image), linear_(!isColor(use)) {}

    glm::vec4 operator[](std::size_t index) const {
        if (image_.bytes.empty()) {
            const float* p = &image_.floats[4 * index];
            return {p[0], p[1], p[2], p[3]};
        }
        const std::uint8_t* p = &image_.bytes[4 * index];
        if (linear_)
            return glm::vec4(p[0], p[1], p[2], p[3]) / 255.0F;
        return {codes_.value(p[0]), codes_.value(p[1]), codes_.value(p[2]),
                static_cast<float>(p[3]) / 255.0F};
    }

  private:
    const Image& image_;
    const SrgbCodes& codes_ = srgbCodes();
    bool linear_;
};

/// The texels of the level above, along one axis, that one texel covers, and how much of each, summing up
/// to 1.
struct Covered {
    int first = 0, count = 0;
    std::array<float, 3> weight{};
};

std::vector<Covered> coveredTexels(int from, int to) {
    std::vector<Covered> list(static_cast<std::size_t>(to));
    const double size = static_cast<double>(from) / to; // 1, 2, or up to 3
    for (int i = 0; i < to; ++i) {
        Covered& covered = list[static_cast<std::size_t>(i)];
        const double low = i * size;
        const double high = (i + 1) * size;
        covered.first = static_cast<int>(low);
        const int end = std::min(static_cast<int>(std::ceil(high - 1e-9)), from);
        covered.count = std::clamp(end - covered.first, 1, 3);
        for (int k = 0; k < covered.count; ++k)
            covered.weight[static_cast<std::size_t>(k)] = static_cast<float>(
                (std::min(high, covered.first + k + 1.0) - std::max(low, covered.first + k + 0.0)) / size);
    }
    return list;
}

/// A mean of texels, each with its share.
class Mean {
  public:
    explicit Mean(TexelUse use) : weighted_(use == TexelUse::Color) {}

    void add(const glm::vec4& texel, float share) {
        sum_ += texel * share;
        if (weighted_)
            covered_ += glm::vec3(texel) * (share * texel.w);
    }

    glm::vec4 result() const {
        // Where there is nothing at all, any colour will do.
        return weighted_ && sum_.w > 0.0F ? glm::vec4(covered_ / sum_.w, sum_.w) : sum_;
    }

  private:
    glm::vec4 sum_{0.0F};
    glm::vec3 covered_{0.0F};
    bool weighted_;
};

template <class Texels>
std::vector<glm::vec4> halved(const Texels& texels, glm::ivec2 from, glm::ivec2 to, TexelUse use) {
    const auto columns = coveredTexels(from.x, to.x);
    const auto rows = coveredTexels(from.y, to.y);
    std::vector<glm::vec4> result;
    result.reserve(texelCount(to));
    for (const Covered& row : rows)
        for (const Covered& column : columns) {
            Mean mean(use);
            for (int y = 0; y < row.count; ++y)
                for (int x = 0; x < column.count; ++x)
                    mean.add(
                        texels[static_cast<std::size_t>(row.first + y) * static_cast<std::size_t>(from.x) +
                               static_cast<std::size_t>(column.first + x)],
                        row.weight[static_cast<std::size_t>(y)] * column.weight[static_cast<std::size_t>(x)]);
            result.push_back(mean.result());
        }
    return result;
}

glm::vec4 withUnitNormal(const glm::vec4& texel) {
    const glm::vec3 normal = glm::vec3(texel) * 2.0F - 1.0F;
    const float length = glm::length(normal);
    const glm::vec3 unit = length > 1e-6F ? normal / length : glm::vec3(0.0F, 0.0F, 1.0F);
    return {unit * 0.5F + 0.5F, texel.w};
}

std::uint32_t packed(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
    return r | static_cast<std::uint32_t>(g) << 8 | static_cast<std::uint32_t>(b) << 16 |
           static_cast<std::uint32_t>(a) << 24;
}

void append(std::vector<std::uint32_t>& words, const std::vector<glm::vec4>& texels, TexelUse use,
            bool isFloat) {
    const SrgbCodes& codes = srgbCodes();
    for (glm::vec4 texel : texels) {
        if (use == TexelUse::Normal) // the means themselves stay as long as they are, for the next level
            texel = withUnitNormal(texel);
        if (isFloat)
            for (glm::length_t c = 0; c < 4; ++c)
                words.push_back(std::bit_cast<std::uint32_t>(texel[c]));
        else if (isColor(use))
            words.push_back(packed(codes.nearest(texel.r), codes.nearest(texel.g), codes.nearest(texel.b),
                                   byteOf(texel.a)));
        else
            words.push_back(packed(byteOf(texel.r), byteOf(texel.g), byteOf(texel.b), byteOf(texel.a)));
    }
}

void appendPicture(std::vector<std::uint32_t>& words, const Image& image) {
    for (const float value : image.floats)
        words.push_back(std::bit_cast<std::uint32_t>(value));
    for (std::size_t i = 0; i + 3 < image.bytes.size(); i += 4)
        words.push_back(packed(image.bytes[i], image.bytes[i + 1], image.bytes[i + 2], image.bytes[i + 3]));
}

} // namespace

std::vector<glm::ivec2> mipSizes(int width, int height) {
    std::vector<glm::ivec2> sizes{{width, height}};
    while (sizes.back() != glm::ivec2(1))
        sizes.push_back(glm::max(sizes.back() / 2, 1));
    return sizes;
}

std::vector<std::uint32_t> texelWords(const Image& image, TexelUse use) {
    const auto sizes = mipSizes(image.width, image.height);
    const bool isFloat = image.bytes.empty();
    std::size_t count = 0;
    for (const glm::ivec2& size : sizes)
        count += texelCount(size);
    std::vector<std::uint32_t> words;
    words.reserve(isFloat ? 4 * count : count);
    appendPicture(words, image);
    std::vector<glm::vec4> texels; // not rounded, so that errors do not add up from level to level
    for (std::size_t level = 1; level < sizes.size(); ++level) {
        texels = level == 1 ? halved(PictureTexels(image, use), sizes[0], sizes[1], use)
                            : halved(texels, sizes[level - 1], sizes[level], use);
        append(words, texels, use, isFloat);
    }
    return words;
}

} // namespace prizma
