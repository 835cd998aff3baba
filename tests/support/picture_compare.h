// SPDX-License-Identifier: MIT
// Golden pictures: what a drawing looked like when a person last approved of it.
#pragma once

#include <string>

#include "render/image.h"

namespace ballpit {

/// What sets a fault apart from another driver's rounding: a pixel differs if none of the 3 × 3 pixels around
/// its place in the other picture is within 8/255; of all blocks of 8 × 8, the most such pixels. Above 8,
/// pictures differ.
int worst_block(const Image& actual, const Image& expected);

/// Returns "" if both look the same. Otherwise writes golden-failures/<name>.png, actual, expected and difference side
/// by side, and says so.
std::string compare_pictures(const std::string& name, const Image& actual, const Image& expected);

/// The same with the golden picture <name>.png in a folder. With BALLPIT_BLESS set, `actual` becomes the golden picture
/// where there is none, or a different one. That is said, too, so that a run that blesses does not pass.
std::string compare_with_golden(const std::string& name, const Image& actual,
                                const std::string& folder = BALLPIT_GOLDEN_FOLDER);

/// Decodes a PNG file; throws what read_file() throws, and RunError for what is no picture.
Image read_png(const std::string& path);

}  // namespace ballpit
