// SPDX-License-Identifier: MIT
// PNG files, two ways. Single pictures: stb_image_write, small files. Frame sequences: a fast encoder.
// Frames are opaque, so both write RGB; every viewer reads them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/image.h"

namespace ballpit {

/// The bytes of a PNG file, compressed well.
std::string encode_png(const Image& image);

/// The bytes of a PNG file, compressed fast. A key that is not empty says what the picture shows; it stands in a chunk of text
/// before the picture, and changes no pixel.
std::string encode_png_fast(const Image& image, const std::string& key = {});

/// What the first bytes of a PNG file tell.
struct PngHead {
  int width = 0, height = 0;
  std::string key;  ///< empty where there is none
};

/// Reads the head of a file. None where it does not begin as a PNG file does. Throws UserError where it cannot be read.
std::optional<PngHead> read_png_head(const std::filesystem::path& path);

/// Writes a single picture. Throws RunError naming the path.
void write_png(const std::filesystem::path& path, const Image& image);

/// Whether `bytes` begin and end as a whole PNG file does.
bool is_whole_png(const std::string& bytes);

}  // namespace ballpit
