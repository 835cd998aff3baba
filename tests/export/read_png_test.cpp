// SPDX-License-Identifier: MIT
// read_png() decodes the pictures of any program, and refuses what is no whole picture.
#include <cstring>
#include <filesystem>
#include <memory>

#include <catch2/catch.hpp>
#include <libdeflate.h>
#include <png.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"

using namespace ballpit;
using Catch::Contains;

namespace {

/// A file that is removed at the end.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& bytes) { write_file(path, bytes); }
  ~ScratchFile() { std::filesystem::remove(path); }

  // Tests run beside each other, each in a process of its own.
  const std::string path =
      (std::filesystem::temp_directory_path() / ("ballpit-read-png-" + std::to_string(getpid()) + ".png")).string();
};

Image read(const std::string& bytes) { return read_png(ScratchFile(bytes).path); }

/// Why a file is refused; "" if it is not.
std::string refusal(const std::string& bytes) {
  try {
    read(bytes);
    return "";
  } catch (const UserError& error) {
    return error.what();
  }
}

/// Encoded by libpng.
std::string encode(const std::vector<uint8_t>& pixels, int width, int height, uint32_t format) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = format;
  png_alloc_size_t size = 0;
  REQUIRE(png_image_write_get_memory_size(header, size, 0, pixels.data(), 0, nullptr));
  std::string bytes(size, '\0');
  REQUIRE(png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels.data(), 0, nullptr));
  return bytes.substr(0, size);
}

std::string small_png() {
  Image image{5, 4, std::vector<uint8_t>(5 * 4 * 4, 255)};
  for (size_t k = 0; k < image.pixels.size(); ++k) image.pixels[k] = k % 4 == 3 ? 255 : static_cast<uint8_t>(k * 7);
  return encode_png(image);
}

void set_number(std::string& bytes, size_t at, uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes[at + static_cast<size_t>(k)] = static_cast<char>(value >> (24 - 8 * k) & 255u);
}

/// The picture's size becomes a lie, with a correct check sum.
std::string with_size(std::string bytes, uint32_t width, uint32_t height) {
  set_number(bytes, 16, width);
  set_number(bytes, 20, height);
  set_number(bytes, 29, libdeflate_crc32(0, bytes.data() + 12, 17));
  return bytes;
}

}  // namespace

TEST_CASE("what encode_png() writes is read again") {
  Image image{3, 2, {}};
  for (uint8_t k = 0; k < 24; ++k) image.pixels.push_back(k % 4 == 3 ? 255 : static_cast<uint8_t>(10 * k));
  const Image found = read(encode_png(image, "a key"));
  CHECK(found.width == 3);
  CHECK(found.height == 2);
  CHECK(found.pixels == image.pixels);
}

TEST_CASE("pictures in grey are read, and transparent pixels are shown on white") {
  const Image plain = read(encode({0, 60, 255}, 3, 1, PNG_FORMAT_GRAY));
  CHECK(plain.pixels == std::vector<uint8_t>{0, 0, 0, 255, 60, 60, 60, 255, 255, 255, 255, 255});
  const Image clear = read(encode({10, 20, 30, 0, 0, 0, 0, 255, 100, 0, 255, 128}, 3, 1, PNG_FORMAT_RGBA));
  CHECK(clear.pixels == std::vector<uint8_t>{255, 255, 255, 255, 0, 0, 0, 255, 177, 127, 255, 255});
}

TEST_CASE("a file that is cut off anywhere is refused") {
  const std::string whole = small_png();
  CHECK(refusal(whole) == "");
  for (size_t length = 0; length < whole.size(); ++length) {
    INFO(length << " of " << whole.size());
    CHECK_THAT(refusal(whole.substr(0, length)), Contains(": found ") && Contains(", allowed a PNG file"));
  }
  CHECK_THAT(refusal(whole.substr(0, whole.size() - 1)), Contains("a PNG file that ends early"));
  CHECK_THAT(refusal(""), Contains("an empty file"));
  CHECK_THAT(refusal("GIF89a and more"), Contains("no PNG file"));
}

TEST_CASE("a file in which any bit is wrong is refused") {
  const std::string whole = small_png();
  for (size_t k = 0; k < whole.size() * 8; ++k) {
    std::string damaged = whole;
    damaged[k / 8] = static_cast<char>(damaged[k / 8] ^ (1 << k % 8));
    INFO("bit " << k);
    CHECK_THAT(refusal(damaged), Contains(", allowed a PNG file"));
  }
}

TEST_CASE("any content with correct check sums ends in a picture or a refusal") {
  const std::string whole = small_png();
  const size_t data = whole.find("IDAT"), length = big_endian(whole, data - 4);
  for (size_t k = 0; k < 8 * (length + 13); ++k) {
    std::string damaged = whole;
    const size_t place = k / 8 < 13 ? 16 + k / 8 : data + 4 + k / 8 - 13;  // in the head, or in the pixels
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << k % 8));
    set_number(damaged, 29, libdeflate_crc32(0, damaged.data() + 12, 17));
    set_number(damaged, data + 4 + length, libdeflate_crc32(0, damaged.data() + data, 4 + length));
    const std::string reason = refusal(damaged);
    CHECK((reason.empty() || reason.find("a PNG file that cannot be decoded (") != std::string::npos));
  }
}

TEST_CASE("a picture of absurd size is refused without its memory") {
  for (const auto& [width, height] :
       std::vector<std::pair<uint32_t, uint32_t>>{{0, 4}, {16385, 16385}, {1u << 24, 1u << 24}, {0xFFFFFFFF, 1}}) {
    CHECK_THAT(refusal(with_size(small_png(), width, height)), Contains("cannot be decoded"));
  }
}

TEST_CASE("a small picture whose data unpack to much more than its pixels is refused without the memory for them") {
  const std::vector<uint8_t> zeros(64'000'000);
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(1), libdeflate_free_compressor);
  std::string packed(1'000'000, '\0');
  packed.resize(libdeflate_zlib_compress(compressor.get(), zeros.data(), zeros.size(), packed.data(), packed.size()));
  REQUIRE(!packed.empty());
  const std::string whole = small_png();
  const size_t data = whole.find("IDAT");
  std::string bomb = whole.substr(0, data + 4) + packed + "sum!" + whole.substr(whole.find("IEND") - 4);
  set_number(bomb, data - 4, static_cast<uint32_t>(packed.size()));
  set_number(bomb, data + 4 + packed.size(), libdeflate_crc32(0, bomb.data() + data, 4 + packed.size()));
  CHECK_THAT(refusal(bomb), Contains("cannot be decoded (outofmem)"));
}

TEST_CASE("a folder and a missing file are refused, and a device without end is not read") {
  CHECK_THROWS_WITH(read_png(std::filesystem::temp_directory_path()), Contains("found a folder, allowed a PNG file"));
  CHECK_THROWS_WITH(read_png("/nowhere/a.png"), Contains("no readable file (No such file or directory)"));
  CHECK_THROWS_WITH(read_png("/dev/zero"), Contains("found no PNG file"));
}
