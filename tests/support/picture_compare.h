// SPDX-License-Identifier: MIT
// Golden pictures: what a drawing looked like when a person last approved of it.
#pragma once

#include <string>

#include "export/picture_compare.h"
#include "export/png.h"
#include "render/image.h"

namespace ballpit {

/// See Comparison.
inline int worst_block(const Image& a, const Image& b) { return comparison_of(a, b).worst_block; }

/// Returns "" if both look the same. Otherwise writes golden-failures/<name>.png, actual, expected and difference side
/// by side, and says so.
std::string compare_pictures(const std::string& name, const Image& actual, const Image& expected);

/// The same with the golden picture <name>.png in a folder. With BALLPIT_BLESS set, `actual` becomes the golden picture
/// where there is none, or a different one. That is said, too, so that a run that blesses does not pass.
std::string compare_with_golden(const std::string& name, const Image& actual,
                                const std::string& folder = BALLPIT_GOLDEN_FOLDER);

}  // namespace ballpit
