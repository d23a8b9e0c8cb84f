#include "core/import/image_loader.h"

#include "core/import/atomic_file.h"
#include "core/import/image_decoder.h"

#include <tinyexr.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

// The one place where this library is compiled; its own code is not held to our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace prizma {
namespace {

constexpr int largestSide = STBI_MAX_DIMENSIONS;

struct FreeDeleter {
    void operator()(void* memory) const { std::free(memory); }
};
template <class T>
using MallocPtr = std::unique_ptr<T, FreeDeleter>;

const unsigned char* bytesOf(std::string_view content) {
    return reinterpret_cast<const unsigned char*>(content.data());
}

std::size_t valueCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
}

bool isSaneSize(long width, long height) {
    return width > 0 && height > 0 && width <= largestSide && height <= largestSide;
}

std::unexpected<Diagnostic> badSize(const std::string& file) {
    return failure("The picture is empty or larger than 16384 × 16384 pixels.", file);
}

/// NaN and infinity in a picture would spread over everything that it lights.
void makeFinite(std::vector<float>& values) {
    for (float& value : values)
        if (!std::isfinite(value))
            value = value > 0.0F ? 65504.0F : 0.0F;
}

ImagePtr floatImage(int width, int height, const float* pixels) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->floats.assign(pixels, pixels + valueCount(width, height));
    makeFinite(image->floats);
    for (std::size_t i = 3; i < image->floats.size() && image->opaque; i += 4)
        image->opaque = image->floats[i] >= 1.0F;
    return image;
}

ImagePtr byteImage(int width, int height, const unsigned char* pixels) {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->bytes.assign(pixels, pixels + valueCount(width, height));
    for (std::size_t i = 3; i < image->bytes.size() && image->opaque; i += 4)
        image->opaque = image->bytes[i] == 255;
    return image;
}

std::string takeExrMessage(const char* message) {
    std::string text = message ? message : "it is damaged";
    FreeEXRErrorMessage(message);
    return text;
}

/// Reads only the header: tinyexr would allocate whatever size a damaged file claims.
Result<void> checkExrSize(std::string_view content, const std::string& file) {
    EXRVersion version;
    if (ParseEXRVersionFromMemory(&version, bytesOf(content), content.size()) != TINYEXR_SUCCESS)
        return failure("The picture could not be read: it is damaged.", file);
    EXRHeader header;
    InitEXRHeader(&header);
    const char* message = nullptr;
    const int status =
        ParseEXRHeaderFromMemory(&header, &version, bytesOf(content), content.size(), &message);
    if (status != TINYEXR_SUCCESS)
        return failure("The picture could not be read: " + takeExrMessage(message) + ".", file);
    const auto width = static_cast<long>(header.data_window.max_x) - header.data_window.min_x + 1;
    const auto height = static_cast<long>(header.data_window.max_y) - header.data_window.min_y + 1;
    FreeEXRHeader(&header);
    if (!isSaneSize(width, height))
        return badSize(file);
    return {};
}

Result<ImagePtr> decodeExr(std::string_view content, const std::string& file) {
    if (const auto size = checkExrSize(content, file); !size)
        return std::unexpected(size.error());
    float* pixels = nullptr;
    int width = 0;
    int height = 0;
    const char* message = nullptr;
    const int status =
        LoadEXRFromMemory(&pixels, &width, &height, bytesOf(content), content.size(), &message);
    const MallocPtr<float> owner(pixels);
    if (status != TINYEXR_SUCCESS || !pixels || !isSaneSize(width, height))
        return failure("The picture could not be read: " + takeExrMessage(message) + ".", file);
    return floatImage(width, height, pixels);
}

Result<ImagePtr> decodeWithStb(std::string_view content, const std::string& file) {
    const auto* bytes = bytesOf(content);
    if (content.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return failure("The picture's file is too large.", file);
    const int length = static_cast<int>(content.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    const bool known = stbi_info_from_memory(bytes, length, &width, &height, &channels) != 0;
    if (!known)
        return failure(
            "It is not a picture in a format that can be read (PNG, JPEG, BMP, TGA, GIF, PSD, HDR, EXR).",
            file);
    if (!isSaneSize(width, height))
        return badSize(file);
    if (stbi_is_hdr_from_memory(bytes, length) != 0) {
        const MallocPtr<float> pixels(stbi_loadf_from_memory(bytes, length, &width, &height, &channels, 4));
        if (pixels)
            return floatImage(width, height, pixels.get());
    } else {
        const MallocPtr<unsigned char> pixels(
            stbi_load_from_memory(bytes, length, &width, &height, &channels, 4));
        if (pixels)
            return byteImage(width, height, pixels.get());
    }
    return failure(std::string("The picture could not be read: ") + stbi_failure_reason() + ".", file);
}

bool isExr(std::string_view content) {
    return content.starts_with("\x76\x2f\x31\x01");
}

} // namespace

Result<ImagePtr> decodeImage(std::string_view content, const std::string& file) {
    if (content.empty())
        return failure("The picture's file is empty.", file);
    try {
        return isExr(content) ? decodeExr(content, file) : decodeWithStb(content, file);
    } catch (const std::exception&) { // tinyexr and our own buffers: out of memory
        return failure("The picture does not fit into memory.", file);
    }
}

Result<ImagePtr> loadImage(const std::string& file) {
    const auto content = readFile(file);
    if (!content)
        return std::unexpected(content.error());
    return decodeImage(*content, file);
}

} // namespace prizma
