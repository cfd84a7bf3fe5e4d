#include "runtime/image.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <png.h>

namespace gnomon {
namespace {

constexpr png_uint_32 max_side = 16384;

/// libpng's simplified interface reports through return values and frees what it holds in png_image_free.
struct PngImage {
    png_image image{};

    PngImage() { image.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

} // namespace

Image read_png(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    PngImage png;
    if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0)
        throw Error("'{}' is not a PNG file that can be read: {}", path.string(),
                    one_line(png.image.message));
    if (png.image.width > max_side || png.image.height > max_side)
        throw Error("'{}' is {} x {} pixels: at most {} on a side can be read", path.string(),
                    png.image.width, png.image.height, max_side);
    // What deflate makes of a byte is at most 1032 times as long, and a pixel has a bit at least.
    if (std::uint64_t{png.image.width} * png.image.height > 8 * 1032 * std::uint64_t{bytes.size()})
        throw Error("'{}' is a damaged PNG file: {} bytes cannot hold {} x {} pixels", path.string(),
                    bytes.size(), png.image.width, png.image.height);
    png.image.format = PNG_FORMAT_RGB;
    png.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;

    static_assert(sizeof(Rgb) == 3);
    Image image(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
    const png_color black{};
    if (png_image_finish_read(&png.image, &black, image.pixels.data(), 0, nullptr) == 0)
        throw Error("'{}' is a damaged PNG file: {}", path.string(), one_line(png.image.message));
    return image;
}

std::string encode_png(const Image& image) {
    const auto side_is_valid = [](int side) { return side > 0 && side <= static_cast<int>(max_side); };
    if (!side_is_valid(image.width) || !side_is_valid(image.height) ||
        image.pixels.size() != image.index(0, image.height))
        throw Error("an image of {} x {} with {} pixels is not a picture", image.width, image.height,
                    image.pixels.size());
    PngImage png;
    png.image.width = static_cast<png_uint_32>(image.width);
    png.image.height = static_cast<png_uint_32>(image.height);
    png.image.format = PNG_FORMAT_RGB;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png.image, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0)
        throw Error("an image cannot be made a PNG file: {}", png.image.message);
    bytes.resize(size);
    return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
    std::string bytes;
    try {
        bytes = encode_png(image);
    } catch (const Error& error) {
        throw Error("cannot write '{}': {}", path.string(), error.what());
    }
    write_file(path, bytes);
}

std::uint8_t srgb(float linear) {
    if (!(linear > 0.0f)) return 0; // also NaN
    const double x = std::min(static_cast<double>(linear), 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(encoded * 255.0 + 0.5);
}

} // namespace gnomon
