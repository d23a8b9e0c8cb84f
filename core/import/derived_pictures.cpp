#include "core/import/derived_pictures.h"

#include "core/import/phong_material.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace prizma {
namespace {

/// One number a pixel.
class Channel {
  public:
    Channel(const Image& image, const std::function<float(const glm::vec4&)>& value)
        : width_(image.width), height_(image.height) {
        const bool isFloat = image.bytes.empty();
        const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        values_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            glm::vec4 pixel;
            for (glm::length_t c = 0; c < 4; ++c) {
                const std::size_t place = 4 * i + static_cast<std::size_t>(c);
                pixel[c] = isFloat ? image.floats[place] : static_cast<float>(image.bytes[place]) / 255.0F;
            }
            values_.push_back(value(pixel));
        }
    }

    int width() const { return width_; }
    int height() const { return height_; }

    /// Repeated in both directions.
    float at(int x, int y) const {
        x = (x % width_ + width_) % width_;
        y = (y % height_ + height_) % height_;
        return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x)];
    }

    /// In the middle of a pixel of a picture of another size.
    float resampled(int x, int y, int width, int height) const {
        if (width == width_ && height == height_)
            return at(x, y);
        const double across = (x + 0.5) * width_ / width - 0.5;
        const double down = (y + 0.5) * height_ / height - 0.5;
        const int left = static_cast<int>(std::floor(across));
        const int top = static_cast<int>(std::floor(down));
        const auto fx = static_cast<float>(across - left);
        const auto fy = static_cast<float>(down - top);
        return glm::mix(glm::mix(at(left, top), at(left + 1, top), fx),
                        glm::mix(at(left, top + 1), at(left + 1, top + 1), fx), fy);
    }

  private:
    int width_, height_;
    std::vector<float> values_;
};

float brightest(const glm::vec4& pixel) {
    return std::clamp(std::max({pixel.r, pixel.g, pixel.b}), 0.0F, 1.0F);
}

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// An 8-bit picture; `pixel(x, y)` gives its four numbers from 0 to 1.
template <class Pixel>
ImagePtr makeImage(int width, int height, const Pixel& pixel) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec4 value = pixel(x, y);
            for (glm::length_t c = 0; c < 4; ++c)
                image->bytes.push_back(byteOf(value[c]));
            image->opaque = image->opaque && image->bytes.back() == 255;
        }
    return image;
}

Channel channelOf(const Image& image, glm::length_t index) {
    return {image, [index](const glm::vec4& pixel) { return pixel[index]; }};
}

} // namespace

ImagePtr withOpacity(const ImagePtr& color, const ImagePtr& opacity) {
    const Channel alpha = opacity->opaque ? Channel(*opacity, brightest) : channelOf(*opacity, 3);
    const int width = std::max(color ? color->width : 1, alpha.width());
    const int height = std::max(color ? color->height : 1, alpha.height());
    if (!color)
        return makeImage(width, height,
                         [&](int x, int y) { return glm::vec4(1.0F, 1.0F, 1.0F, alpha.at(x, y)); });
    const Channel red = channelOf(*color, 0);
    const Channel green = channelOf(*color, 1);
    const Channel blue = channelOf(*color, 2);
    const auto pixel = [&](int x, int y) {
        return glm::vec4(red.resampled(x, y, width, height), green.resampled(x, y, width, height),
                         blue.resampled(x, y, width, height), alpha.resampled(x, y, width, height));
    };
    if (!color->bytes.empty())
        return makeImage(width, height, pixel);
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec4 value = pixel(x, y);
            image->floats.insert(image->floats.end(), {value.r, value.g, value.b, value.a});
            image->opaque = image->opaque && value.a >= 1.0F;
        }
    return image;
}

ImagePtr metallicRoughness(const ImagePtr& roughness, const ImagePtr& metallic) {
    const Image white{1, 1, {255, 255, 255, 255}, {}, true};
    const Channel green(roughness ? *roughness : white, brightest);
    const Channel blue(metallic ? *metallic : white, brightest);
    const int width = std::max(green.width(), blue.width());
    const int height = std::max(green.height(), blue.height());
    return makeImage(width, height, [&](int x, int y) {
        return glm::vec4(1.0F, green.resampled(x, y, width, height), blue.resampled(x, y, width, height),
                         1.0F);
    });
}

ImagePtr roughnessFromShininess(const ImagePtr& map, double shininess) {
    const Channel values(*map, brightest);
    return makeImage(map->width, map->height, [&](int x, int y) {
        const double value = static_cast<double>(values.at(x, y));
        return glm::vec4(1.0F, static_cast<float>(roughnessOfShininess(shininess * value)), 1.0F, 1.0F);
    });
}

ImagePtr valuesInAlpha(const ImagePtr& specular) {
    const Channel values(*specular, brightest);
    return makeImage(specular->width, specular->height,
                     [&](int x, int y) { return glm::vec4(1.0F, 1.0F, 1.0F, values.at(x, y)); });
}

ImagePtr normalsFromHeights(const ImagePtr& heights, double scale) {
    const Channel values(*heights, brightest);
    const auto pixels = static_cast<float>(scale * heights->width / 50.0); // that height 1 is high
    return makeImage(heights->width, heights->height, [&](int x, int y) {
        const float right = 0.5F * pixels * (values.at(x + 1, y) - values.at(x - 1, y));
        const float up = 0.5F * pixels * (values.at(x, y - 1) - values.at(x, y + 1)); // rows run down
        return glm::vec4(glm::normalize(glm::vec3(-right, -up, 1.0F)) * 0.5F + 0.5F, 1.0F);
    });
}

bool looksLikeNormalMap(const Image& image) {
    if (image.bytes.empty())
        return false;
    double sums[3] = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i + 3 < image.bytes.size(); i += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += image.bytes[i + channel];
    return sums[2] > 1.3 * sums[0] && sums[2] > 1.3 * sums[1];
}

} // namespace prizma
