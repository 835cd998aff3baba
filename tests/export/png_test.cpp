// SPDX-License-Identifier: MIT
#include "export/png.h"

#include <cstring>
#include <filesystem>

#include <catch2/catch.hpp>
#include <png.h>

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"

using namespace ballpit;

namespace {

/// Decoded by libpng, which verifies all check sums.
std::vector<uint8_t> decode_rgba(const std::string& bytes, int& width, int& height) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) return {};
  header.format = PNG_FORMAT_RGBA;
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(header));
  width = static_cast<int>(header.width);
  height = static_cast<int>(header.height);
  if (!png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr)) return {};
  return pixels;
}

/// Half noise, half a flat ground with a ramp.
Image test_picture(int width, int height) {
  Image image{width, height, std::vector<uint8_t>(static_cast<size_t>(width * height) * 4, 255)};
  Random random(1);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    image.pixels[i] = i < image.pixels.size() / 2 ? static_cast<uint8_t>(random.bits()) : static_cast<uint8_t>(i / 64);
  }
  return image;
}

}  // namespace

TEST_CASE("a PNG file gives back every pixel, at any size") {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 9}, {13, 1}, {17, 5}, {640, 360}}) {
    const Image image = test_picture(width, height);
    const std::string bytes = encode_png(image);
    int w = 0;
    int h = 0;
    CHECK(decode_rgba(bytes, w, h) == image.pixels);
    CHECK(w == width);
    CHECK(h == height);
    CHECK(is_whole_png(bytes));
  }
}

TEST_CASE("a truncated PNG file is not a whole one") {
  const std::string bytes = encode_png(test_picture(20, 10));
  CHECK_FALSE(is_whole_png(bytes.substr(0, bytes.size() - 1)));
  CHECK_FALSE(is_whole_png(bytes.substr(0, 40)));
  CHECK_FALSE(is_whole_png(bytes.substr(1)));
  CHECK_FALSE(is_whole_png(""));
}

TEST_CASE("a picture that cannot be written names its path") {
  CHECK_THROWS_WITH(write_png("/nonexistent/a.png", test_picture(4, 4)), Catch::Contains("/nonexistent/a.png"));
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "ballpit-single.png";
  write_png(path, test_picture(4, 4));
  CHECK(is_whole_png(read_file(path)));
  std::filesystem::remove(path);
}
