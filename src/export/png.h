// SPDX-License-Identifier: MIT
// Reads and writes PNG files. Pictures are opaque, so the files hold RGB.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "render/image.h"

namespace ballpit {

/// The bytes of a PNG file. A key that is not empty describes what the picture shows; it is stored in a text chunk and
/// changes no pixel. `is_small`: takes several times as long for a smaller file.
std::string encode_png(const Image& image, std::string_view key = {}, bool is_small = false);

/// Writes a single picture. Throws RunError naming the path.
void write_png(const std::filesystem::path& path, const Image& image);

/// The first bytes of a PNG file.
struct PngHead {
  int width = 0, height = 0;
  std::string key;  ///< empty if the file has none
};

/// Reads the head of a file; nothing if it is no PNG file. Throws UserError if it cannot be read.
std::optional<PngHead> read_png_head(const std::filesystem::path& path);

/// Whether `bytes` begin and end as a whole PNG file does.
bool is_whole_png(std::string_view bytes);

/// Decodes a PNG file of any program. Transparent pixels are shown on white. Throws UserError for a file that is
/// unreadable, no PNG file, cut off or damaged, or has more than 2^28 pixels.
Image read_png(const std::filesystem::path& path);

/// The bytes that each PNG file begins with, and a number in it.
inline constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
uint32_t big_endian(std::string_view bytes, size_t at);

}  // namespace ballpit
