#include "runtime/image.h"

#include "runtime/files.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <png.h>

namespace gnomon {

void PrintTo(const Rgb& c, std::ostream* out) { *out << fmt::format("({}, {}, {})", c.r, c.g, c.b); }

namespace {

namespace fs = std::filesystem;
using testing::error_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                              static_cast<std::uint8_t>(x * y)};
    return image;
}

/// A PNG file of another pixel format than this module writes.
template <typename Sample, std::size_t count>
std::string encode(png_uint_32 width, png_uint_32 height, png_uint_32 format,
                   const std::array<Sample, count>& samples, const void* colours = nullptr,
                   png_uint_32 colour_count = 0) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    image.colormap_entries = colour_count;
    std::string bytes(10000, '\0');
    png_alloc_size_t size = bytes.size();
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, colours), 0)
        << image.message;
    bytes.resize(size);
    return bytes;
}

void put_big_endian(std::string& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

/// A valid PNG header chunk of this size, with hardly any data behind it.
std::string claim_size(std::uint32_t width, std::uint32_t height) {
    std::string bytes = encode<png_byte, 1>(1, 1, PNG_FORMAT_GRAY, {0});
    put_big_endian(bytes, 16, width);
    put_big_endian(bytes, 20, height);
    std::uint32_t crc = ~0u;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<unsigned char>(bytes[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    put_big_endian(bytes, 29, ~crc);
    return bytes;
}

TEST(Image, FirstRowIsTheTop) {
    Image image(3, 2, {9, 9, 9});
    image.at(2, 0) = {1, 2, 3};
    EXPECT_EQ(image.pixels.size(), 6u);
    EXPECT_EQ(image.pixels[2], (Rgb{1, 2, 3}));
    EXPECT_EQ(image.pixels[5], (Rgb{9, 9, 9}));
}

TEST(Image, EveryByteSurvivesTheRoundTrip) {
    const TemporaryFolder folder;
    for (const Image& image : {gradient(256, 131), gradient(1, 1), gradient(1, 77)}) {
        write_png(folder.path() / "image.png", image);
        const Image read = read_png(folder.path() / "image.png");
        EXPECT_EQ(read.width, image.width);
        EXPECT_EQ(read.height, image.height);
        EXPECT_EQ(read.pixels, image.pixels);
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Image, ReadsGrey) {
    const TemporaryFolder folder;
    const fs::path path =
        folder.write("grey.png", encode<png_byte, 4>(2, 2, PNG_FORMAT_GRAY, {0, 10, 200, 255}));
    EXPECT_EQ(read_png(path).pixels,
              (std::vector<Rgb>{{0, 0, 0}, {10, 10, 10}, {200, 200, 200}, {255, 255, 255}}));
}

TEST(Image, ReadsPalette) {
    const TemporaryFolder folder;
    const std::array<png_byte, 6> colours{250, 20, 3, 4, 50, 6};
    const fs::path path = folder.write(
        "palette.png", encode<png_byte, 3>(3, 1, PNG_FORMAT_RGB_COLORMAP, {1, 0, 1}, colours.data(), 2));
    EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{4, 50, 6}, {250, 20, 3}, {4, 50, 6}}));
}

TEST(Image, ReadsSixteenBitsOfLinearLight) {
    const TemporaryFolder folder;
    const fs::path path =
        folder.write("deep.png", encode<png_uint_16, 6>(2, 1, PNG_FORMAT_LINEAR_RGB,
                                                        {0, 65535, 14000, 3000, 30000, 65535}));
    const Image image = read_png(path);
    const std::vector<float> linear{0, 65535, 14000, 3000, 30000, 65535};
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(image.pixels[i].r, srgb(linear[3 * i] / 65535), 2);
        EXPECT_NEAR(image.pixels[i].g, srgb(linear[3 * i + 1] / 65535), 2);
        EXPECT_NEAR(image.pixels[i].b, srgb(linear[3 * i + 2] / 65535), 2);
    }
}

TEST(Image, AlphaIsLaidOverBlack) {
    const TemporaryFolder folder;
    const fs::path path =
        folder.write("alpha.png", encode<png_byte, 12>(3, 1, PNG_FORMAT_RGBA,
                                                       {9, 80, 255, 255, 9, 80, 255, 0, 255, 0, 0, 128}));
    const Image image = read_png(path);
    EXPECT_EQ(image.pixels[0], (Rgb{9, 80, 255}));
    EXPECT_EQ(image.pixels[1], (Rgb{0, 0, 0}));
    EXPECT_NEAR(image.pixels[2].r, srgb(128.0f / 255.0f), 2);
    EXPECT_EQ(image.pixels[2].g, 0);
}

TEST(Image, DamageIsReported) {
    const TemporaryFolder folder;
    const fs::path good = folder.path() / "good.png";
    write_png(good, gradient(64, 64));
    const std::string bytes = read_file(good);
    std::string flipped = bytes;
    flipped[flipped.size() / 2] = static_cast<char>(~flipped[flipped.size() / 2]);
    const std::pair<std::string, std::string> bad[] = {
        {"empty.png", ""},
        {"text.png", "this is no picture, whatever its name says"},
        {"signature.png", bytes.substr(0, 8)},
        {"header.png", bytes.substr(0, 30)},
        {"half.png", bytes.substr(0, bytes.size() / 2)},
        {"flipped.png", flipped},
        {"nothing.png", claim_size(0, 5)},
        {"claim.png", claim_size(16384, 16384)},
    };
    for (const auto& [name, content] : bad) {
        const fs::path path = folder.write(name, content);
        EXPECT_THAT(error_of([&] { read_png(path); }), HasSubstr(path.string()));
    }
    // Before memory is taken for pixels that so few bytes cannot hold.
    EXPECT_THAT(error_of([&] { read_png(folder.path() / "claim.png"); }),
                HasSubstr("bytes cannot hold 16384 x 16384 pixels"));
    EXPECT_THAT(error_of([&] { read_png(folder.path() / "absent.png"); }), HasSubstr("absent.png"));
    EXPECT_THAT(error_of([&] { read_png(folder.path()); }), HasSubstr(folder.path().string()));
}

TEST(Image, TooLargeIsRefusedByItsHeader) {
    const TemporaryFolder folder;
    for (const auto& [width, height] :
         {std::pair{16385u, 1u}, std::pair{1u, 16385u}, std::pair{900000u, 900000u}}) {
        const fs::path path = folder.write("huge.png", claim_size(width, height));
        EXPECT_THAT(error_of([&] { read_png(path); }), AllOf(HasSubstr(path.string()), HasSubstr("16384")));
    }
}

TEST(Image, WhatIsNoPictureIsNotWritten) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "none.png";
    Image torn(4, 4);
    torn.pixels.pop_back();
    for (const Image& image : {Image(), Image(0, 5), torn, Image(16385, 1)})
        EXPECT_THAT(error_of([&] { write_png(path, image); }), HasSubstr(path.string()));
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_THAT(error_of([&] { write_png(folder.path() / "absent" / "a.png", Image(1, 1)); }),
                HasSubstr("absent/a.png"));
}

TEST(Image, SrgbAtKnownValues) {
    EXPECT_EQ(srgb(0.0f), 0);
    EXPECT_EQ(srgb(1.0f), 255);
    EXPECT_EQ(srgb(0.5f), 188);
    EXPECT_EQ(srgb(0.18f), 118);
    EXPECT_EQ(srgb(0.002f), 7); // 12.92 * 0.002 * 255 = 6.6: the straight part
    EXPECT_EQ(srgb(-1.0f), 0);
    EXPECT_EQ(srgb(7.0f), 255);
    EXPECT_EQ(srgb(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(srgb(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(srgb(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Image, SrgbInvertsTheDecodingOfEveryValue) {
    for (int value = 0; value < 256; ++value) {
        const double encoded = value / 255.0;
        const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        EXPECT_EQ(srgb(static_cast<float>(linear)), value);
    }
}

} // namespace
} // namespace gnomon
