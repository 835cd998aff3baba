// SPDX-License-Identifier: MIT
#include "export/png.h"

#include <string_view>
#include <vector>

#include <stb_image_write.h>

#include "core/error.h"
#include "core/file.h"

namespace ballpit {

namespace {

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

std::vector<uint8_t> without_alpha(const Image& image) {
  std::vector<uint8_t> rgb;
  rgb.reserve(image.pixels.size() / 4 * 3);
  for (size_t i = 0; i < image.pixels.size(); i += 4) {
    rgb.insert(rgb.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(i),
               image.pixels.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  return rgb;
}

}  // namespace

std::string encode_png(const Image& image) {
  const std::vector<uint8_t> rgb = without_alpha(image);
  std::string bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, rgb.data(), image.width * 3)) {
    throw RunError("PNG",
                   "cannot encode " + std::to_string(image.width) + "x" + std::to_string(image.height) + " pixels");
  }
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) { write_file(path, encode_png(image)); }

bool is_whole_png(const std::string& bytes) {
  using namespace std::string_view_literals;
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n"sv;
  constexpr std::string_view kEnd = "\0\0\0\0IEND\xAE\x42\x60\x82"sv;
  return bytes.size() > kSignature.size() + kEnd.size() && bytes.compare(0, kSignature.size(), kSignature) == 0 &&
         bytes.compare(bytes.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
}

}  // namespace ballpit
