// SPDX-License-Identifier: MIT
// stb_image_write forms the file, and libdeflate compresses it, as a rule at level 1. Every row has the filter SUB (each byte minus
// the one a pixel to the left), which turns flat areas into zeros. Frames of a film must not wait for the encoder, and
// little is lost against trying all filters.
// Source: PNG specification, W3C REC-png-3, sections 5 (chunks), 9 (filtering), 11.3.4.3 (text).
#include "export/png.h"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <libdeflate.h>

#include "core/error.h"
#include "core/file.h"

namespace {

/// Of libdeflate: 1 is fastest, 12 makes the smallest files.
thread_local int level = 1;

/// For stb_image_write: the compressed bytes in memory from malloc(), or nullptr.
unsigned char* compress(const unsigned char* data, int size, int* compressed_size, int) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const auto length = static_cast<size_t>(size);
  const size_t bound = libdeflate_zlib_compress_bound(compressor.get(), length);
  auto* const bytes = static_cast<unsigned char*>(std::malloc(bound));
  if (bytes == nullptr) return nullptr;
  *compressed_size = static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, length, bytes, bound));
  if (*compressed_size > 0) return bytes;
  std::free(bytes);
  return nullptr;
}

}  // namespace

// The library's warnings are not ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32(bytes, size) libdeflate_crc32(0, bytes, static_cast<size_t>(size))
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace ballpit {

namespace {

using namespace std::string_view_literals;

[[maybe_unused]] const int kSubFilter = stbi_write_force_png_filter = 1;

constexpr std::string_view kEnd = "\0\0\0\0IEND\xAE\x42\x60\x82"sv;
constexpr std::string_view kKeyword = "Ballpit\0"sv;  // of the chunk that holds the key
constexpr size_t kMaxBytes = 2'000'000'000;           // stb_image_write counts bytes in int
constexpr size_t kHeader = 33;                        // [byte] signature, and the chunk with the size

std::vector<uint8_t> without_alpha(const Image& image) {
  std::vector<uint8_t> rgb(image.pixels.size() / 4 * 3);
  const uint8_t* from = image.pixels.data();
  for (size_t k = 0; k < rgb.size(); k += 3, from += 4) {
    for (size_t c = 0; c < 3; ++c) rgb[k + c] = from[c];
  }
  return rgb;
}

void append_big_endian(std::string& bytes, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 255u));
}

/// Length, type, data, check sum of type and data.
std::string text_chunk(std::string_view key) {
  const std::string content = fmt::format("tEXt{}{}", kKeyword, key);
  std::string bytes;
  append_big_endian(bytes, static_cast<uint32_t>(content.size() - 4));
  bytes += content;
  append_big_endian(bytes, libdeflate_crc32(0, content.data(), content.size()));
  return bytes;
}

}  // namespace

std::string encode_png(const Image& image, std::string_view key, bool is_small) {
  level = is_small ? 9 : 1;
  const std::vector<uint8_t> rgb = without_alpha(image);
  int size = 0;
  std::unique_ptr<unsigned char, decltype(&std::free)> png(nullptr, std::free);
  if (rgb.size() < kMaxBytes) {
    png.reset(stbi_write_png_to_mem(rgb.data(), image.width * 3, image.width, image.height, 3, &size));
  }
  if (!png) throw RunError("PNG", fmt::format("cannot encode {}x{} pixels", image.width, image.height));
  const std::string_view file(reinterpret_cast<const char*>(png.get()), static_cast<size_t>(size));
  return fmt::format("{}{}{}", file.substr(0, kHeader), key.empty() ? "" : text_chunk(key), file.substr(kHeader));
}

void write_png(const std::filesystem::path& path, const Image& image) { write_file(path, encode_png(image)); }

std::optional<PngHead> read_png_head(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_reading(path);
  std::string bytes(65536, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(in.gcount()));
  if (bytes.size() < kHeader || !bytes.starts_with(kPngSignature) || bytes.compare(12, 4, "IHDR") != 0) return {};
  PngHead head{static_cast<int>(big_endian(bytes, 16)), static_cast<int>(big_endian(bytes, 20)), {}};
  if (bytes.size() < kHeader + 8 || bytes.compare(kHeader + 4, 4, "tEXt") != 0) return head;
  const std::string_view text = std::string_view(bytes).substr(kHeader + 8, big_endian(bytes, kHeader));
  if (text.starts_with(kKeyword)) head.key = text.substr(kKeyword.size());
  return head;
}

uint32_t big_endian(std::string_view bytes, size_t at) {
  uint32_t value = 0;
  for (const char byte : bytes.substr(at, 4)) value = value << 8 | static_cast<uint8_t>(byte);
  return value;
}

bool is_whole_png(std::string_view bytes) {
  return bytes.size() > kPngSignature.size() + kEnd.size() && bytes.starts_with(kPngSignature) && bytes.ends_with(kEnd);
}

}  // namespace ballpit
