#include "core/import/image_saver.h"

#include "core/import/atomic_file.h"

#include <png.h>
#include <tinyexr.h>

#include <bit>
#include <csetjmp>
#include <exception>

namespace prizma {
namespace {

struct PngTarget {
    std::string content;
    std::string fault;
};

// libpng's callbacks: C, so that no exception may leave them.

void appendBytes(png_structp png, png_bytep bytes, std::size_t count) {
    bool full = false;
    try {
        static_cast<PngTarget*>(png_get_io_ptr(png))
            ->content.append(reinterpret_cast<const char*>(bytes), count);
    } catch (const std::exception&) {
        full = true;
    }
    if (full)
        png_error(png, "it does not fit into memory");
}

void flushNothing(png_structp) {}

[[noreturn]] void takeFault(png_structp png, png_const_charp message) {
    try {
        static_cast<PngTarget*>(png_get_error_ptr(png))->fault = message;
    } catch (const std::exception&) { // then without its words
    }
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// Nothing with a destructor may live in here: libpng leaves it by longjmp.
bool encodePng(PngTarget& target, int width, int height, int bits, const unsigned char* pixels) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &target, takeFault, ignoreWarning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info) {
        png_destroy_write_struct(&png, nullptr);
        return false;
    }
    if (setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_set_write_fn(png, &target, appendBytes, flushNothing);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    if (bits == 16 && std::endian::native == std::endian::little)
        png_set_swap(png);
    const std::size_t rowBytes = static_cast<std::size_t>(width) * 4 * static_cast<std::size_t>(bits / 8);
    for (int y = 0; y < height; ++y)
        png_write_row(png, pixels + static_cast<std::size_t>(y) * rowBytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

template <class T>
Result<void> checkPixels(const std::string& file, int width, int height, const std::vector<T>& pixels) {
    if (width <= 0 || height <= 0 ||
        pixels.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4)
        return failure("The picture's size does not match its pixels.", file);
    return {};
}

template <class T>
Result<void> writePng(const std::string& file, int width, int height, const std::vector<T>& pixels) {
    if (auto checked = checkPixels(file, width, height, pixels); !checked)
        return checked;
    PngTarget target;
    if (!encodePng(target, width, height, 8 * sizeof(T),
                   reinterpret_cast<const unsigned char*>(pixels.data())))
        return failure("The picture could not be written: " +
                           (target.fault.empty() ? "it does not fit into memory" : target.fault) + ".",
                       file);
    return replaceFile(file, target.content);
}

} // namespace

Result<void> savePng(const std::string& file, int width, int height,
                     const std::vector<std::uint8_t>& pixels) {
    return writePng(file, width, height, pixels);
}

Result<void> savePng16(const std::string& file, int width, int height,
                       const std::vector<std::uint16_t>& pixels) {
    return writePng(file, width, height, pixels);
}

Result<void> saveExr(const std::string& file, int width, int height, const std::vector<float>& pixels) {
    if (auto checked = checkPixels(file, width, height, pixels); !checked)
        return checked;
    return replaceFile(file, [&](const std::string& path) -> Result<void> {
        const char* message = nullptr;
        if (SaveEXR(pixels.data(), width, height, 4, 0, path.c_str(), &message) == TINYEXR_SUCCESS)
            return {};
        const std::string reason = message ? message : "its file cannot be written";
        FreeEXRErrorMessage(message);
        return failure("The picture could not be written: " + reason + ".");
    });
}

} // namespace prizma
