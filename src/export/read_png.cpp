// SPDX-License-Identifier: MIT
// Decodes PNG files of any origin by stb_image. It checks no check sums and allocates what a file says, so both are done
// here: a damaged file is refused, not compared, and no file takes more memory than its picture needs.
// Source: PNG specification, W3C REC-png-3, section 5 (chunks).
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>
#include <libdeflate.h>

#include "core/error.h"
#include "core/file.h"
#include "export/png.h"

namespace {

/// [byte] that one allocation of stb_image may have. A small file can unpack to any size.
thread_local size_t allowed = 0;

void* allocate(size_t bytes) { return bytes > allowed ? nullptr : std::malloc(bytes); }
void* reallocate(void* old, size_t bytes) { return bytes > allowed ? nullptr : std::realloc(old, bytes); }

}  // namespace

// The library's warnings are not ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC(bytes) allocate(bytes)
#define STBI_REALLOC(old, bytes) reallocate(old, bytes)
#define STBI_FREE(memory) std::free(memory)
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace ballpit {

namespace {

constexpr size_t kMaxFile = 2'000'000'000;  // [byte] stb_image counts them in int

UserError wrong_picture(const std::filesystem::path& path, std::string_view found) {
  return UserError(path.string(), found, "a PNG file");
}

/// The whole file, but no more of one that is no PNG file: /dev/zero has no end.
std::string read_signed(const std::filesystem::path& path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw wrong_picture(path, "a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_reading(path);
  std::string bytes;
  for (size_t block = kPngSignature.size(); in; block = 1 << 20) {
    const size_t before = bytes.size();
    bytes.resize(before + block);
    in.read(bytes.data() + before, static_cast<std::streamsize>(block));
    bytes.resize(before + static_cast<size_t>(in.gcount()));
    if (!bytes.starts_with(kPngSignature)) throw wrong_picture(path, bytes.empty() ? "an empty file" : "no PNG file");
    if (bytes.size() > kMaxFile) throw wrong_picture(path, "more than 2 GB");
  }
  if (in.bad()) fail_reading(path);
  return bytes;
}

/// What is wrong with the chunks, or "". Each is length, type, data and the check sum of type and data; the last is IEND.
std::string fault_of(std::string_view bytes) {
  constexpr size_t kFrame = 12;  // [byte] of length, type and check sum
  for (size_t at = kPngSignature.size(); at + kFrame <= bytes.size();) {
    const size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - kFrame) break;
    const std::string_view content = bytes.substr(at + 4, 4 + length);
    if (libdeflate_crc32(0, content.data(), content.size()) != big_endian(bytes, at + 8 + length)) {
      return fmt::format("a damaged PNG file (wrong check sum in the chunk at byte {})", at);
    }
    if (content.starts_with("IEND")) return "";
    at += kFrame + length;
  }
  return "a PNG file that ends early";
}

/// [byte] What decoding needs: the data from the file, or the pixels of 8 bytes at most, in buffers that grow by doubling.
size_t memory_for(std::string_view bytes) {
  const size_t width = big_endian(bytes, 16), height = big_endian(bytes, 20);
  const size_t most = width * height > (1u << 28) ? 0 : (8 * width + 1) * height;
  return 4096 + 2 * std::max(bytes.size(), most);
}

/// Shows transparent pixels on white, since pictures are opaque.
void make_opaque(std::vector<uint8_t>& pixels) {
  for (size_t k = 0; k < pixels.size(); k += 4) {
    const int alpha = pixels[k + 3];
    for (size_t c = 0; c < 3; ++c) {
      pixels[k + c] = static_cast<uint8_t>((pixels[k + c] * alpha + 255 * (255 - alpha) + 127) / 255);
    }
    pixels[k + 3] = 255;
  }
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = read_signed(path);
  if (const std::string fault = fault_of(bytes); !fault.empty()) throw wrong_picture(path, fault);
  allowed = memory_for(bytes);
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &image.width, &image.height, &channels, 4),
      std::free);
  if (!pixels) throw wrong_picture(path, fmt::format("a PNG file that cannot be decoded ({})", stbi_failure_reason()));
  image.pixels.assign(pixels.get(),
                      pixels.get() + static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 4);
  make_opaque(image.pixels);
  return image;
}

}  // namespace ballpit
