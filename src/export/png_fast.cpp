// SPDX-License-Identifier: MIT
// PNG for frame sequences: every row filtered by SUB (each byte minus the one a pixel to the left), deflated
// at level 1 by libdeflate. Flat grounds become zeros, so that little is lost against trying all filters.
// Source: PNG specification, W3C REC-png-3, sections 5 (chunks), 9 (filtering).
#include <cstddef>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include <libdeflate.h>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"

namespace ballpit {

namespace {

constexpr const char* kSignature = "\x89PNG\r\n\x1a\n";
constexpr int kLevel = 1;
constexpr char kSubFilter = 1;

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

void append_big_endian(std::string& bytes, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 255u));
}

/// Length, type, data, check sum of type and data.
void append_chunk(std::string& bytes, std::string_view type, std::string_view data) {
  append_big_endian(bytes, static_cast<uint32_t>(data.size()));
  const size_t start = bytes.size();
  bytes.append(type);
  bytes.append(data);
  append_big_endian(bytes, libdeflate_crc32(0, bytes.data() + start, bytes.size() - start));
}

std::string header(const Image& image) {
  std::string bytes;
  append_big_endian(bytes, static_cast<uint32_t>(image.width));
  append_big_endian(bytes, static_cast<uint32_t>(image.height));
  bytes.append("\x08\x02\0\0\0", 5);  // 8 bits, RGB, deflate, adaptive filters, not interlaced
  return bytes;
}

/// Filter type and differences, row by row, RGB.
std::vector<uint8_t> filtered_rows(const Image& image) {
  const size_t width = static_cast<size_t>(image.width);
  const size_t height = static_cast<size_t>(image.height);
  std::vector<uint8_t> rows((width * 3 + 1) * height);
  for (size_t y = 0; y < height; ++y) {
    const uint8_t* from = image.pixels.data() + y * width * 4;
    uint8_t* to = rows.data() + y * (width * 3 + 1);
    *to++ = kSubFilter;
    for (size_t c = 0; c < 3; ++c) to[c] = from[c];
    for (size_t x = 1; x < width; ++x) {
      for (size_t c = 0; c < 3; ++c) to[x * 3 + c] = static_cast<uint8_t>(from[x * 4 + c] - from[x * 4 + c - 4]);
    }
  }
  return rows;
}

/// Of the chunk that holds the key, with the zero that ends it (PNG specification, section 11.3.4.3).
std::string keyword() { return std::string("Ballpit") + '\0'; }

uint32_t big_endian(const std::string& bytes, size_t at) {
  uint32_t value = 0;
  for (size_t k = at; k < at + 4; ++k) value = value << 8 | static_cast<uint8_t>(bytes[k]);
  return value;
}

std::string deflated(const std::vector<uint8_t>& rows) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(kLevel));
  if (!compressor) throw RunError("PNG", "cannot encode: out of memory");
  std::string bytes(libdeflate_zlib_compress_bound(compressor.get(), rows.size()), '\0');
  const size_t size = libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), bytes.data(), bytes.size());
  if (size == 0) throw RunError("PNG", "cannot encode: libdeflate_zlib_compress found no room");
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string encode_png_fast(const Image& image, const std::string& key) {
  std::string bytes = kSignature;
  append_chunk(bytes, "IHDR", header(image));
  if (!key.empty()) append_chunk(bytes, "tEXt", keyword() + key);
  append_chunk(bytes, "IDAT", deflated(filtered_rows(image)));
  append_chunk(bytes, "IEND", {});
  return bytes;
}

std::optional<PngHead> read_png_head(const std::filesystem::path& path) {
  constexpr size_t kHeader = 33;  // signature, and the chunk with the size
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_reading(path);
  std::string bytes(65536, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(in.gcount()));
  if (bytes.size() < kHeader || bytes.compare(0, 8, kSignature) != 0 || bytes.compare(12, 4, "IHDR") != 0) return {};
  PngHead head{static_cast<int>(big_endian(bytes, 16)), static_cast<int>(big_endian(bytes, 20)), {}};
  if (bytes.size() < kHeader + 8 || bytes.compare(kHeader + 4, 4, "tEXt") != 0) return head;
  const std::string_view text = std::string_view(bytes).substr(kHeader + 8, big_endian(bytes, kHeader));
  if (text.substr(0, keyword().size()) == keyword()) head.key = text.substr(keyword().size());
  return head;
}

}  // namespace ballpit
