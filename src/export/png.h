// SPDX-License-Identifier: MIT
// PNG files, two ways. Single pictures: stb_image_write, small files. Frame sequences: a fast encoder.
// Frames are opaque, so both write RGB; every viewer reads them.
#pragma once

#include <filesystem>
#include <string>

#include "render/image.h"

namespace ballpit {

/// The bytes of a PNG file, compressed well.
std::string encode_png(const Image& image);

/// The bytes of a PNG file, compressed fast.
std::string encode_png_fast(const Image& image);

/// Writes a single picture. Throws RunError naming the path.
void write_png(const std::filesystem::path& path, const Image& image);

/// Whether `bytes` begin and end as a whole PNG file does.
bool is_whole_png(const std::string& bytes);

}  // namespace ballpit
