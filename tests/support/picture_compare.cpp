// SPDX-License-Identifier: MIT
#include "tests/support/picture_compare.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"
#include "tests/support/test_scenes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace ballpit {

namespace {

bool has_like(const Image& image, int x, int y, const uint8_t* pixel) {
  for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u) {
      if (difference(image.pixel(u, v), pixel) <= 8) return true;
    }
  }
  return false;
}

bool differs(const Image& a, const Image& b, int x, int y) {
  return !has_like(b, x, y, a.pixel(x, y)) || !has_like(a, x, y, b.pixel(x, y));
}

Image difference_picture(const Image& actual, const Image& expected) {
  Image diff = expected;
  for (int y = 0; y < diff.height; ++y) {
    for (int x = 0; x < diff.width; ++x) {
      uint8_t* pixel = diff.pixels.data() + (y * diff.width + x) * 4;
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<uint8_t>(192 + pixel[c] / 4);
      if (differs(actual, expected, x, y)) pixel[0] = 255, pixel[1] = pixel[2] = 0;
    }
  }
  return diff;
}

/// Pictures of one size in a row, with a gap between.
Image side_by_side(const std::vector<Image>& pictures) {
  constexpr int kGap = 8;
  Image row;
  row.height = pictures.front().height;
  row.width = static_cast<int>(pictures.size()) * (pictures.front().width + kGap) - kGap;
  row.pixels.assign(static_cast<size_t>(row.width) * static_cast<size_t>(row.height) * 4, 128);
  int left = 0;
  for (const Image& picture : pictures) {
    for (int y = 0; y < row.height; ++y) {
      std::copy_n(picture.pixel(0, y), picture.width * 4, row.pixels.data() + (y * row.width + left) * 4);
    }
    left += picture.width + kGap;
  }
  return row;
}

}  // namespace

int worst_block(const Image& actual, const Image& expected) {
  int worst = 0;
  for (int top = 0; top < actual.height; top += 8) {
    for (int left = 0; left < actual.width; left += 8) {
      int count = 0;
      for (int y = top; y < std::min(top + 8, actual.height); ++y) {
        for (int x = left; x < std::min(left + 8, actual.width); ++x) count += differs(actual, expected, x, y);
      }
      worst = std::max(worst, count);
    }
  }
  return worst;
}

Image read_png(const std::string& path) {
  const std::string bytes = read_file(path);
  Image image;
  int channels = 0;
  uint8_t* pixels = stbi_load_from_memory(reinterpret_cast<const uint8_t*>(bytes.data()),
                                          static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4);
  if (!pixels) throw RunError(path, stbi_failure_reason());
  image.pixels.assign(pixels, pixels + static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 4);
  stbi_image_free(pixels);
  return image;
}

std::string compare_with_golden(const std::string& name, const Image& actual, const std::string& folder) {
  const std::string golden = folder + "/" + name + ".png";
  if (!std::getenv("BALLPIT_BLESS")) return compare_pictures(name, actual, read_png(golden));
  if (std::filesystem::exists(golden) && compare_pictures(name, actual, read_png(golden)).empty()) return "";
  write_png(golden, actual);
  return "blessed: " + golden + "; look at it, then test without BALLPIT_BLESS";
}

std::string compare_pictures(const std::string& name, const Image& actual, const Image& expected) {
  if (expected.width != actual.width || expected.height != actual.height) return name + ": of another size";
  const int worst = worst_block(actual, expected);
  if (worst <= 8) return "";
  const std::filesystem::path folder = std::filesystem::current_path() / "golden-failures";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / (name + ".png")).string();
  write_png(file, side_by_side({actual, expected, difference_picture(actual, expected)}));
  return name + ": " + std::to_string(worst) + " of 64 pixels of a block differ (8 may); see " + file;
}

}  // namespace ballpit
