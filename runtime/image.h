// Images in memory and as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gnomon {

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Row-major, first row at the top of the picture (y = 0), 8 bits per channel, sRGB values.
struct Image {
    int width = 0, height = 0;
    std::vector<Rgb> pixels;

    Image() = default;
    Image(int columns, int rows, Rgb fill = {})
        : width(columns), height(rows),
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    Rgb& at(int x, int y) { return pixels[index(x, y)]; }
    const Rgb& at(int x, int y) const { return pixels[index(x, y)]; }
};

/// Reads any PNG (grey, palette, 16 bits …) as 8-bit RGB. Alpha is laid over black in linear light. A file
/// that states a gamma other than sRGB's is converted; one that states none is taken as sRGB. Throws Error
/// naming the file if it is missing, not a PNG, damaged, or larger than 16384 on a side.
Image read_png(const std::filesystem::path& path);

/// The bytes of a PNG file. Throws Error if the image has no pixels, or more than 16384 on a side.
std::string encode_png(const Image& image);

/// Writes atomically (see write_file). Throws Error naming the file.
void write_png(const std::filesystem::path& path, const Image& image);

/// Linear light in [0,1] (clamped; NaN becomes 0) to an 8-bit sRGB value. IEC 61966-2-1.
std::uint8_t srgb(float linear);

} // namespace gnomon
